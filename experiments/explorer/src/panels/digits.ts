// SPDX-License-Identifier: GPL-3.0-or-later
//
// The coordinates of one vertex digit by digit: both answers beside the exact decimal expansion,
// the first wrong digit marked.

import { exactNumbers, exactOf, numbersOf, vertexFor } from '../compare';
import { digitsOf, firstWrong, kDigits, positional } from '../digits';
import type { Scalar } from '../engine';
import { exactly, ulpsFrom } from '../exact';
import type { Rational } from '../exact';
import { hexFloat } from '../number_text';
import type { Page, Panel } from '../panel';
import type { Scene } from '../scene';
import { button, html, spoken, Table, tableRow } from './dom';
import type { Cell, Child } from './dom';
import { short } from './text';
import { vertexChoice } from './vertex_choice';

const kNames = ['x', 'y', 'z', '1/w'];

function markedDigits(value: number, exact: Rational, scalar: Scalar): Child {
  if (!Number.isFinite(value)) return short(value);
  const count = kDigits[scalar];
  const found = digitsOf(exactly(value), count);
  const wrong = firstWrong(found, digitsOf(exact, count));
  const { text, places } = positional(found);
  if (wrong === null) return html('code', {}, text);
  const at = places[wrong]!;
  return html('code', {}, text.slice(0, at),
              html('mark', {}, spoken('wrong from here: '), text[at]!), text.slice(at + 1));
}

function ulpsText(value: number, exact: Rational, scalar: Scalar): string {
  return Number.isFinite(value) ? short(Math.abs(ulpsFrom(value, exact, scalar)), 3) : '';
}

function answerCells(value: number | undefined, exact: Rational, scalar: Scalar): Cell[] {
  if (value === undefined) return ['–', ''];
  return [[markedDigits(value, exact, scalar), html('small', { class: 'hex' }, hexFloat(value))],
          ulpsText(value, exact, scalar)];
}

function mount(host: HTMLElement, { store }: Page) {
  const vertex = vertexChoice('Vertex', store);
  const table = new Table('Coordinates of the vertex, digit by digit');
  const bits = html('input', { type: 'checkbox',
                               change: () => table.element.classList.toggle('with-hex', bits.checked) });
  const reverse = button('Walk round the other way', () => {
    const [a, b, c] = store.state.triangle;
    store.update({ triangle: [a, c, b] });
  });
  const text = html('p', { class: 'verdict' });
  host.append(html('div', { class: 'controls' }, vertex.element,
                   html('label', {}, bits, 'with hex floats'), reverse), text, table.element,
    html('details', {}, html('summary', {}, 'What is compared'),
      html('p', { class: 'note' },
        'Every float is a whole number times a power of two, hence has a finite decimal expansion, ' +
        'cut off here after as many digits as tell neighbouring numbers apart. A marked digit need ' +
        'not be a mistake: the exact value need not be a float at all. An error of at most 0.5 ulp ' +
        'is the best that there is.')));
  let heads = '';
  return (scene: Scene) => {
    const exact = exactOf(scene.state);
    const at = vertex.show(exact);
    text.textContent = at < 0 ? 'Nothing is visible, so there is no coordinate to compare.' : '';
    const [a, b] = scene.answers;
    const key = `${a.clipper.name} ${b.clipper.name}`;
    if (key !== heads) {
      heads = key;
      table.setHead(['', html('span', { class: 'first' }, a.clipper.name), 'ulps',
                     html('span', { class: 'second' }, b.clipper.name), 'ulps',
                     html('span', { class: 'exact' }, 'exact')]);
    }
    if (exact === null || at < 0) return table.setRows([]);
    const { scalar } = scene.state;
    const vertices = scene.answers.map(({ polygon }) => vertexFor(polygon, exact, at, scalar));
    table.setRows(exactNumbers(exact[at]!).map((e, k) => tableRow([
      kNames[k] ?? `a${k - 4}`,
      ...vertices.flatMap((v) =>
        answerCells(v === null ? undefined : numbersOf(v)[k], e, scalar)),
      html('code', {}, positional(digitsOf(e, kDigits[scalar])).text)])));
  };
}

export const kDigitsPanel: Panel = { id: 'digits', title: 'Digits', mount };
