// SPDX-License-Identifier: GPL-3.0-or-later
//
// Panels in one place, of which one is open: a list of tabs and the panel of the chosen one. Only
// the open panel is shown scenes.

import type { Page, Panel } from '../panel';
import type { Scene } from '../scene';
import { html } from './dom';

// Who keeps which panel is open.
export interface TabChoice {
  of(scene: Scene): string;
  choose(page: Page, id: string): void;
}

interface Tab {
  id: string;
  button: HTMLButtonElement;
  section: HTMLElement;
  show: (scene: Scene) => void;
}

function mountTab(panel: Panel, page: Page, choice: TabChoice): Tab {
  const button = html('button', {
    type: 'button', role: 'tab', id: `${panel.id}-tab`, 'aria-controls': panel.id,
    click: () => choice.choose(page, panel.id),
  }, panel.title);
  const section = html('section', {
    id: panel.id, role: 'tabpanel', 'aria-labelledby': button.id, class: 'panel', hidden: true,
  });
  return { id: panel.id, button, section, show: panel.mount(section, page) };
}

// Left, Right, Home and End go from tab to tab.
function followKeys(list: HTMLElement, tabs: readonly Tab[]) {
  list.addEventListener('keydown', (event) => {
    const at = tabs.findIndex((tab) => tab.button === document.activeElement);
    const last = tabs.length - 1;
    const targets: Record<string, number> =
      { ArrowLeft: at > 0 ? at - 1 : last, ArrowRight: at < last ? at + 1 : 0, Home: 0, End: last };
    const target = targets[event.key];
    if (at < 0 || target === undefined) return;
    event.preventDefault();
    tabs[target]!.button.focus();
    tabs[target]!.button.click();
  });
}

export function tabbed(id: string, title: string, panels: readonly Panel[],
                       choice: TabChoice): Panel {
  const mount = (host: HTMLElement, page: Page) => {
    const tabs = panels.map((panel) => mountTab(panel, page, choice));
    const list = html('div', { role: 'tablist', 'aria-label': title },
                      ...tabs.map((tab) => tab.button));
    followKeys(list, tabs);
    host.append(list, ...tabs.map((tab) => tab.section));
    let open = '';
    const turnTo = (wanted: string) => {
      open = wanted;
      for (const tab of tabs) {
        const isOpen = tab.id === wanted;
        tab.section.hidden = !isOpen;
        tab.button.setAttribute('aria-selected', String(isOpen));
        tab.button.tabIndex = isOpen ? 0 : -1;
      }
    };
    return (scene: Scene) => {
      const wanted = choice.of(scene);
      if (wanted !== open) turnTo(wanted);
      tabs.find((tab) => tab.id === wanted)?.show(scene);
    };
  };
  return { id, title, mount };
}
