// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page: loads the clippers, mounts the panels and shows them every scene.

import { Engine } from './engine';
import type { Panel } from './panel';
import { kPanels, kViews } from './panels';
import { sceneOf } from './scene';
import { initialState, Store } from './state';

// The bytes of a script element of this page: compressed by gzip, in base64.
async function embedded(id: string): Promise<ArrayBuffer> {
  const text = document.getElementById(id)!.textContent!;
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

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
  const page = { engine, store };
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
