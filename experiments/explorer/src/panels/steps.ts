// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sutherland and Hodgman plane by plane: forwards, back and by itself, in any order of the planes.
// The views draw the polygon after the chosen step.

import type { Vertex } from '../engine';
import type { Page, Panel } from '../panel';
import type { Scene } from '../scene';
import { planesThatCut } from '../state';
import type { Store } from '../state';
import { button, html, Table, tableRow } from './dom';
import { planeChips } from './plane_chips';
import { counted, planeForm, planeWords, short } from './text';

const kPlayMilliseconds = 900;
const kNear = 4;

// The planes by their numbers, but for one that has a place of its own.
export function orderWithNear(store: Store, place: 'first' | 'last' | 'by number'): number[] {
  const planes = planesThatCut(store.state.volume);
  if (place === 'by number' || !planes.includes(kNear)) return planes;
  const rest = planes.filter((p) => p !== kNear);
  return place === 'first' ? [kNear, ...rest] : [...rest, kNear];
}

export function stepBy(store: Store, steps: number) {
  const { step, order } = store.state;
  store.update({ step: Math.max(0, Math.min(order.length, step + steps)) });
}

// Steps from plane to plane until all have cut.
class Player {
  private timer: number | null = null;
  readonly button = button('▶ Play', () => this.toggle(), { 'aria-pressed': 'false' });

  constructor(private readonly store: Store) {}

  private toggle() {
    if (this.timer !== null) return this.stop();
    if (this.store.state.step >= this.store.state.order.length) this.store.update({ step: 0 });
    this.timer = window.setInterval(() => this.advance(), kPlayMilliseconds);
    this.label('Pause', true);
  }

  private advance() {
    stepBy(this.store, 1);
    if (this.store.state.step >= this.store.state.order.length) this.stop();
  }

  private stop() {
    if (this.timer !== null) window.clearInterval(this.timer);
    this.timer = null;
    this.label('▶ Play', false);
  }

  private label(text: string, isPressed: boolean) {
    this.button.textContent = text;
    this.button.setAttribute('aria-pressed', String(isPressed));
  }
}

const isSame = (a: Vertex, b: Vertex) => a.position.every((x, k) => Object.is(x, b.position[k]));

function isNew(scene: Scene, step: number, v: Vertex): boolean {
  return step > 0 && !scene.steps[step - 1]!.some((u) => isSame(u, v));
}

function sentence(scene: Scene): string {
  const { step, order, frustum } = scene.state;
  const polygon = scene.steps[step]!;
  if (step === 0) return `Before the first cut: the triangle. After that ${planeWords([order[0]!])} cuts first.`;
  const plane = order[step - 1]!;
  const before = scene.steps[step - 1]!;
  const made = polygon.filter((v) => isNew(scene, step, v)).length;
  const lost = before.length - (polygon.length - made);
  const who = `Step ${step} of ${order.length}: ${planeWords([plane])} keeps ` +
              `${planeForm(frustum.depth, plane)} ≥ 0.`;
  if (before.length === 0) return `${who} Nothing was left to cut.`;
  if (lost === 0 && made === 0) return `${who} All vertices are inside, so nothing changes.`;
  if (polygon.length === 0) return `${who} All vertices are outside, so nothing is left.`;
  return `${who} It removes ${counted(lost, 'vertex', 'vertices')} and makes ` +
         `${counted(made, 'new one', 'new ones')}: ${polygon.length} in all.`;
}

function mount(host: HTMLElement, { store }: Page) {
  const to = (step: number) => store.update({ step });
  const first = button('|◀', () => to(0), { 'aria-label': 'Before the first cut' });
  const back = button('◀ Back', () => stepBy(store, -1));
  const player = new Player(store);
  const forth = button('Next ▶', () => stepBy(store, 1));
  const last = button('▶|', () => to(store.state.order.length), { 'aria-label': 'After the last' });
  const preset = (label: string, place: 'first' | 'last' | 'by number') =>
    button(label, () => store.update({ order: orderWithNear(store, place) }));
  const chips = planeChips(store);
  const text = html('p', { class: 'verdict', 'aria-live': 'polite' });
  const table = new Table('Vertices of the polygon after this step, in clip space',
                          ['', 'x', 'y', 'z', 'w', '']);
  host.append(
    html('div', { class: 'controls' }, first, back, player.button, forth, last),
    chips.element, text, table.element,
    html('div', { class: 'controls' }, 'Order:', preset('near first', 'first'),
         preset('near last', 'last'), preset('by number', 'by number')));
  return (scene: Scene) => {
    const { step, order } = scene.state;
    first.disabled = back.disabled = step === 0;
    forth.disabled = last.disabled = step >= order.length;
    chips.show(scene);
    text.textContent = sentence(scene);
    table.setRows(scene.steps[step]!.map((v, i) => tableRow([
      String(i + 1), ...v.position.map((x) => short(x)),
      isNew(scene, step, v) ? html('span', { class: 'new' }, 'new') : ''])));
  };
}

export const kStepsPanel: Panel = { id: 'steps', title: 'Steps', mount };
