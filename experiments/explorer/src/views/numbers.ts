// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of the triangle, which may be typed, and the switch of the space that they are in.

import { rounded, type Space, type Triangle, type Vec4 } from '../engine';
import type { Page, Panel } from '../panel';
import { choice, html } from '../panels/dom';
import { isInvertible, toClipPosition, toViewPosition } from '../projection';
import type { Scene } from '../scene';
import type { State } from '../state';
import { withVertex } from './drag';
import { numberField, type NumberField } from './number_field';
import { kLetters } from './plot';
import { volumeForm } from './volume_form';

const kNames = ['x', 'y', 'z', 'w'] as const;

// The triangle with its numbers in the other space, as the clippers have them there.
export function converted({ state, clip, view }: Scene): Partial<State> | null {
  const triangle = state.space === 'view' ? clip : view;
  if (triangle === null) return null;
  const space: Space = state.space === 'view' ? 'clip' : 'view';
  const inScalar = (position: Vec4) => position.map((x) => rounded(state.scalar, x)) as Vec4;
  return {
    space,
    triangle: triangle.map(({ position, attributes }) =>
      ({ position: inScalar(position), attributes })) as Triangle,
  };
}

// Vertices that no point of view space has in clip space: z is not that of their w.
function strangers({ state: { space, frustum }, clip }: Scene): string[] {
  if (space === 'view' || !isInvertible(frustum)) return [];
  return kLetters.filter((_, i) => {
    const [x, y, z, w] = clip[i]!.position;
    const own = toClipPosition(frustum, toViewPosition(frustum, [x, y, z, w]));
    return Math.abs(own[2] - z) > 1e-4 * Math.max(Math.abs(z), Math.abs(w), 1e-30) ||
           Math.abs(own[3] - w) > 1e-4 * Math.abs(w);
  });
}

function note(scene: Scene): string {
  const { space, frustum } = scene.state;
  if (!isInvertible(frustum)) return 'No view volume has these numbers.';
  const names = strangers(scene);
  if (names.length > 0) {
    return `z and w of ${names.join(', ')} are of no point in this view space; there z follows w.`;
  }
  if (space === 'clip') return '';
  return frustum.parallel ? 'In a parallel projection w is 1.'
    : 'In view space w is not free: it is \u2212z.';
}

function vertexFields(page: Page): { element: HTMLElement; show: (scene: Scene) => void } {
  const change = (vertex: number, k: number, value: number) => {
    const position = [...page.store.state.triangle[vertex]!.position] as Vec4;
    position[k] = value;
    page.store.update({ ...withVertex(page.store.state, vertex, position), source: '' });
  };
  const fields: NumberField[][] = kLetters.map((letter, vertex) => kNames.map((name, k) =>
    numberField(`${name} of ${letter}`, (value) => { change(vertex, k, value); return true; })));
  const row = (vertex: number) => html('tr', {},
    html('th', { scope: 'row' }, kLetters[vertex]!),
    ...fields[vertex]!.map((field) => html('td', {}, field.element)));
  const table = html('table', { class: 'vertices' },
    html('thead', {}, html('tr', {}, html('td'),
      ...kNames.map((name) => html('th', { scope: 'col' }, name)))),
    html('tbody', {}, ...kLetters.map((_, i) => row(i))));
  const show = ({ state }: Scene) => {
    table.classList.toggle('without_w', state.space === 'view');
    fields.forEach((own, vertex) => own.forEach((field, k) =>
      field.show(state.triangle[vertex]!.position[k]!, state.scalar)));
  };
  return { element: table, show };
}

export const kNumbers: Panel = {
  id: 'numbers',
  title: 'Numbers',
  mount(host: HTMLElement, page: Page) {
    let shown: Scene | null = null;
    const space = choice<Space>('The triangle is given in',
      [['view', 'view space'], ['clip', 'clip space']], (wanted) => {
        if (shown === null || wanted === shown.state.space) return;
        const change = converted(shown);
        if (change !== null) page.store.update(change);
        else space.show(shown.state.space);
      });
    const vertices = vertexFields(page);
    const volume = volumeForm(page);
    const remark = html('p', { class: 'remark', role: 'status' });
    host.append(html('div', { class: 'numbers' },
      html('div', { class: 'given' }, space.element, vertices.element, remark), volume.element));
    return (scene: Scene) => {
      shown = scene;
      space.show(scene.state.space);
      vertices.show(scene);
      volume.show(scene.state);
      const text = note(scene);
      if (remark.textContent !== text) remark.textContent = text;
    };
  },
};
