// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of the triangle, which may be typed, and the switch of the space that they are in.

import { kAttributes, rounded } from '../engine';
import type { Space, Triangle, Vec4, Vertex } from '../engine';
import type { Page, Panel } from '../panel';
import { choice, html } from '../panels/dom';
import { isInvertible, toClipPosition, toViewPosition } from '../projection';
import type { Scene } from '../scene';
import { kLetters, type State } from '../state';
import { withVertex } from './drag';
import { numberField, type NumberField } from './number_field';
import { volumeForm } from './volume_form';

const kNames = ['x', 'y', 'z', 'w'] as const;

// The triangle with its numbers in the other space, as the clippers have them there.
function converted({ state, clip, view }: Scene): Partial<State> | null {
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

interface Fields {
  element: HTMLTableElement;
  heads: HTMLElement[]; // of the columns
  show: (scene: Scene) => void;
}

// A table of one number per vertex and column.
function fieldsOf(names: readonly string[], get: (vertex: Vertex) => readonly number[],
                  set: (vertex: number, column: number, value: number) => void): Fields {
  const fields: NumberField[][] = kLetters.map((letter, vertex) => names.map((name, k) =>
    numberField(`${name} of ${letter}`, (value) => { set(vertex, k, value); return true; })));
  const row = (vertex: number) => html('tr', {},
    html('th', { scope: 'row' }, kLetters[vertex]!),
    ...fields[vertex]!.map((field) => html('td', {}, field.element)));
  const heads = names.map((name) => html('th', { scope: 'col' }, name));
  const element = html('table', { class: 'vertices' },
    html('thead', {}, html('tr', {}, html('td'), ...heads)),
    html('tbody', {}, ...kLetters.map((_, i) => row(i))));
  const show = ({ state }: Scene) => fields.forEach((own, vertex) => own.forEach((field, k) =>
    field.show(get(state.triangle[vertex]!)[k]!, state.scalar)));
  return { element, heads, show };
}

function positions({ store }: Page): Fields {
  const set = (vertex: number, k: number, value: number) => {
    const position = [...store.state.triangle[vertex]!.position] as Vec4;
    position[k] = value;
    store.update(withVertex(store.state, vertex, position));
  };
  const fields = fieldsOf(kNames, (v) => v.position, set);
  const show = (scene: Scene) => {
    fields.element.classList.toggle('without_w', scene.state.space === 'view');
    fields.show(scene);
  };
  return { ...fields, show };
}

// The first of them are clip distances, where there are any.
function attributes({ store }: Page): { element: HTMLElement; show: (scene: Scene) => void } {
  const names = Array.from({ length: kAttributes }, (_, i) => `attribute ${i}`);
  const fields = fieldsOf(names, (v) => v.attributes, (vertex, k, value) => {
    const triangle = [...store.state.triangle] as Triangle;
    const own = triangle[vertex]!.attributes.map((old, i) => i === k ? value : old);
    triangle[vertex] = { ...triangle[vertex]!, attributes: own };
    store.update({ triangle, selected: vertex });
  });
  const element = html('details', {}, html('summary', {}, 'Attributes'), fields.element);
  const show = (scene: Scene) => {
    const { clipDistances } = scene.state.volume;
    fields.heads.forEach((head, i) => {
      head.textContent = i < clipDistances ? `clip distance ${i}` : names[i]!;
    });
    fields.show(scene);
  };
  return { element, show };
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
    const parts = [positions(page), attributes(page)];
    const volume = volumeForm(page);
    const remark = html('p', { class: 'remark', role: 'status' });
    host.append(space.element, html('div', { class: 'numbers' },
      html('div', {}, parts[0]!.element, remark, parts[1]!.element), volume.element));
    return (scene: Scene) => {
      shown = scene;
      space.show(scene.state.space);
      for (const part of parts) part.show(scene);
      volume.show(scene.state);
      const text = note(scene);
      if (remark.textContent !== text) remark.textContent = text;
    };
  },
};
