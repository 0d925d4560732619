// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which vertex of the exact polygon a panel looks at, by its number; the state keeps it.

import type { ExactVertex } from '../exact';
import type { State, Store } from '../state';
import { choice, html } from './dom';

// The number of the vertex; -1 where there is none.
export function chosenVertex(state: State, exact: readonly ExactVertex[] | null): number {
  return Math.min(state.magnified ?? 0, (exact?.length ?? 0) - 1);
}

export function vertexChoice(label: string, store: Store) {
  const element = html('div');
  let shown = -1;
  let radios = choice<string>(label, [], () => {});
  // Returns chosenVertex.
  const show = (exact: readonly ExactVertex[] | null): number => {
    const count = exact?.length ?? 0;
    if (count !== shown) {
      shown = count;
      const options = Array.from({ length: count }, (_, i) => [String(i), String(i + 1)] as const);
      radios = choice<string>(label, options, (i) => store.update({ magnified: Number(i) }));
      element.replaceChildren(...(count > 0 ? [radios.element] : []));
    }
    const at = chosenVertex(store.state, exact);
    radios.show(String(at));
    return at;
  };
  return { element, show };
}
