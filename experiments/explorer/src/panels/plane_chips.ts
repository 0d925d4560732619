// SPDX-License-Identifier: GPL-3.0-or-later
//
// The planes in the order in which they cut: each can be chosen as the step, dragged to another
// place, and moved by the arrow keys.

import type { Scene } from '../scene';
import type { Store } from '../state';
import { button, html } from './dom';
import { planeName } from './text';

// Pre-condition: both are places of the order.
export function moved(order: readonly number[], from: number, to: number): number[] {
  const rest = order.filter((_, i) => i !== from);
  return [...rest.slice(0, to), order[from]!, ...rest.slice(to)];
}

export function planeChips(store: Store) {
  const element = html('ol', { class: 'chips', 'aria-label': 'Planes in the order of their cuts' });
  let shown = '';

  const move = (from: number, to: number) => {
    const { order } = store.state;
    if (to < 0 || to >= order.length || from === to) return;
    const plane = order[from]!;
    store.update({ order: moved(order, from, to) });
    focused = plane;
  };
  let focused: number | null = null; // the plane whose chip shall have the focus once it is shown

  const chip = (plane: number, i: number, scene: Scene) => {
    const { step, order } = scene.state;
    const name = planeName(plane);
    const counts = `${scene.steps[i]!.length} → ${scene.steps[i + 1]!.length}`;
    const main = button('', () => store.update({ step: i + 1 }), {
      class: 'chip', 'data-plane': plane, 'aria-current': i + 1 === step ? 'step' : 'false',
      'aria-label': `${name}, place ${i + 1}: ${scene.steps[i]!.length} vertices become ` +
                    `${scene.steps[i + 1]!.length}; Shift with Left or Right moves it`,
      keydown: (event) => {
        const { key, shiftKey } = event as KeyboardEvent;
        if (!shiftKey || (key !== 'ArrowLeft' && key !== 'ArrowRight')) return;
        event.preventDefault();
        event.stopPropagation();
        move(i, key === 'ArrowLeft' ? i - 1 : i + 1);
      },
    });
    main.append(html('span', {}, name), html('small', {}, counts));
    const arrow = (text: string, label: string, to: number) =>
      button(text, () => move(i, to), { class: 'arrow', 'aria-label': `${name}: ${label}`,
                                        disabled: to < 0 || to >= order.length });
    return html('li', {
      class: i < step ? 'done' : '', draggable: 'true',
      dragstart: (event) => (event as DragEvent).dataTransfer?.setData('text/plain', String(i)),
      dragover: (event) => event.preventDefault(),
      drop: (event) => {
        event.preventDefault();
        const from = (event as DragEvent).dataTransfer?.getData('text/plain') ?? '';
        if (/^\d+$/.test(from)) move(Number(from), i);
      },
    }, arrow('‹', 'earlier', i - 1), main, arrow('›', 'later', i + 1));
  };

  const show = (scene: Scene) => {
    const { order, step } = scene.state;
    const key = `${order.join()} ${step} ${scene.steps.map((p) => p.length).join()}`;
    if (key === shown) return;
    shown = key;
    const active = document.activeElement;
    const plane = focused ?? (element.contains(active) ? Number((active as HTMLElement).dataset.plane)
      : null);
    focused = null;
    element.replaceChildren(...order.map((p, i) => chip(p, i, scene)));
    if (plane !== null) element.querySelector<HTMLElement>(`[data-plane="${plane}"]`)?.focus();
  };
  return { element, show };
}
