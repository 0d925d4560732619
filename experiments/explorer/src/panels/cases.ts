// SPDX-License-Identifier: GPL-3.0-or-later
//
// The catalogue of hard cases: a list that can be searched. A click opens a case.

import type { HardCase } from '../catalogue';
import type { Page, Panel } from '../panel';
import type { Scene } from '../scene';
import { kAllPlanes } from '../state';
import type { Store } from '../state';
import { button, html } from './dom';
import { counted } from './text';

export function openCase(store: Store, { name, question }: HardCase) {
  store.update({ ...question, source: name, step: kAllPlanes, magnified: null, zoom: 0 });
}

// Every word of the search must be somewhere in what is said of the case.
function fits({ name, why, source, expected }: HardCase, search: string): boolean {
  const text = `${name} ${why} ${source} ${expected}`.toLowerCase();
  return search.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}

function entry(hardCase: HardCase, store: Store) {
  const open = button('', () => openCase(store, hardCase), { class: 'case' });
  open.append(html('strong', {}, hardCase.name), html('span', {}, hardCase.why));
  return { hardCase, open, item: html('li', {}, open) };
}

// Scrolls the list, and not the page, so far that the item is seen.
function reveal(list: HTMLElement, item: HTMLElement) {
  const [frame, box] = [list.getBoundingClientRect(), item.getBoundingClientRect()];
  if (box.top < frame.top) list.scrollTop -= frame.top - box.top;
  else if (box.bottom > frame.bottom) list.scrollTop += box.bottom - frame.bottom;
}

function mount(host: HTMLElement, { store, catalogue }: Page) {
  const entries = catalogue.map((hardCase) => entry(hardCase, store));
  const search = html('input', { type: 'search', placeholder: 'behind, sliver, ulp, clipped 9, …',
                                 input: () => filter() });
  const count = html('p', { class: 'note', 'aria-live': 'polite' });
  const about = html('p', { class: 'verdict' });
  const list = html('ul', { class: 'cases' }, ...entries.map((e) => e.item));
  const filter = () => {
    for (const e of entries) e.item.hidden = !fits(e.hardCase, search.value.trim());
    const shown = entries.filter((e) => !e.item.hidden).length;
    count.textContent = `${counted(shown, 'case', 'cases')} of ${entries.length}`;
  };
  filter();
  host.append(html('label', { class: 'search' }, 'Search ', search), count, about, list);
  let shown: string | null = null;
  return ({ state }: Scene) => {
    if (state.source === shown) return;
    shown = state.source;
    for (const { hardCase, open } of entries) {
      open.setAttribute('aria-current', String(hardCase.name === shown));
    }
    const entryOfCase = entries.find((e) => e.hardCase.name === shown);
    if (entryOfCase !== undefined) reveal(list, entryOfCase.item);
    const current = entryOfCase?.hardCase;
    about.replaceChildren(...(current === undefined ? [] : [
      html('strong', {}, current.name),
      ` Exact outcome: ${current.expected}. Where it was met: ${current.source}.`]));
  };
}

export const kCasesPanel: Panel = { id: 'cases', title: 'Hard cases', mount };
