// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page: loads the clippers, mounts the panels and shows them every scene.

import { loadCatalogue } from './catalogue';
import { embedded } from './embedded';
import { Engine } from './engine';
import { followLink } from './follow_link';
import type { Panel } from './panel';
import { kPanels, kViews } from './panels';
import { kInstrumentPanels } from './panels/groups';
import { mountHelp } from './panels/help';
import { sceneOf } from './scene';
import { initialState, Store } from './state';

function section(panel: Panel, parent: HTMLElement): HTMLElement {
  const host = document.createElement('section');
  host.id = panel.id;
  const heading = document.createElement('h2');
  heading.textContent = panel.title;
  host.append(heading);
  parent.append(host);
  return host;
}

async function start() {
  const engine = await Engine.load(await embedded('engine'));
  const store = new Store(initialState());
  const page = { engine, store, catalogue: await loadCatalogue() };
  followLink(store, { clippers: engine.clippers.map((clipper) => clipper.name),
                      panels: kInstrumentPanels.map((panel) => panel.id) });
  mountHelp(page, kInstrumentPanels, document.querySelector('header')!);
  const mounted = (panels: readonly Panel[], id: string) =>
    panels.map((panel) => panel.mount(section(panel, document.getElementById(id)!), page));
  const shows = [...mounted(kViews, 'views'), ...mounted(kPanels, 'panels')];
  store.subscribe((state) => {
    const scene = sceneOf(engine, state);
    for (const show of shows) show(scene);
  });
  document.body.classList.add('ready');
}

void start();
