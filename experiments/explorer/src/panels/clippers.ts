// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two clippers that are laid over each other, and what each answer is worth beside the exact
// one.

import { compare, exactOf, meaningOf } from '../compare';
import type { Comparison } from '../compare';
import type { Clipper, Engine, Scalar } from '../engine';
import type { ExactVertex } from '../exact';
import type { Page, Panel } from '../panel';
import type { Answer, Scene } from '../scene';
import { button, choice, html, Table, tableRow } from './dom';
import { short } from './text';

const folderOf = ({ name }: Clipper) => (name.includes('/') ? name.slice(0, name.indexOf('/')) : '');

// All clippers, grouped by the space that they cut in.
function clipperList(engine: Engine, label: string, choose: (name: string) => void) {
  const select = html('select', { id: `clipper-${label.toLowerCase()}`,
                                  change: () => choose(select.value) });
  for (const folder of new Set(engine.clippers.map(folderOf))) {
    const options = engine.clippers.filter((c) => folderOf(c) === folder)
      .map((c) => html('option', { value: c.name }, c.name));
    if (folder === '') select.append(...options);
    else select.append(html('optgroup', { label: folder }, ...options));
  }
  // Beside the list, for else the names of all clippers would be its label.
  return { select, element: html('span', { class: 'field' }, html('label', { for: select.id }, label),
                                 select) };
}

const swatch = (which: 'first' | 'second' | 'exact') =>
  html('span', { class: `swatch ${which}`, 'aria-hidden': 'true' });

function errorsOf(c: Comparison): [string, string, string] {
  if (c.pairs.length === 0) return ['', '', ''];
  return [short(c.ulps, 3), short(c.px, 3), short(c.attribute, 3)];
}

function answerRow(which: 'first' | 'second', answer: Answer, scene: Scene) {
  const exact = exactOf(scene.state);
  const vertices = answer.polygon === null ? '–' : String(answer.polygon.length);
  const name = [swatch(which), answer.clipper.name];
  if (exact === null) return tableRow([name, vertices, 'there is no exact answer', '', '', '']);
  const comparison = compare(answer.polygon, exact, scene.state.scalar);
  const outcome = [html('strong', { class: 'outcome', 'data-outcome': comparison.outcome },
                        comparison.outcome.replaceAll('_', ' ')),
                   `: ${meaningOf(comparison, exact)}`];
  return tableRow([name, vertices, outcome, ...errorsOf(comparison)]);
}

function exactText(exact: readonly ExactVertex[] | null): string {
  if (exact === null) return 'the numbers enclose no volume';
  if (exact.length >= 3) return 'in rational numbers';
  return exact.length === 0 ? 'nothing is visible' : 'nothing that has an area is visible';
}

function description(which: 'first' | 'second', { name, summary, source }: Clipper) {
  return html('p', { class: 'note' }, swatch(which), html('strong', {}, name), ` ${summary}. `,
              html('cite', {}, source), '.');
}

function mount(host: HTMLElement, { engine, store }: Page) {
  const first = clipperList(engine, 'First', (name) =>
    store.update({ clippers: [name, store.state.clippers[1]] }));
  const second = clipperList(engine, 'Second', (name) =>
    store.update({ clippers: [store.state.clippers[0], name] }));
  const swap = button('⇄ Exchange', () =>
    store.update({ clippers: [store.state.clippers[1], store.state.clippers[0]] }));
  const scalar = choice<Scalar>('Numbers are', [['float', 'float'], ['double', 'double']],
                                (value) => store.update({ scalar: value }));
  const table = new Table('Both answers against the exact one',
    ['clipper', 'vertices', 'outcome', 'ulps', 'px', 'attributes']);
  const notes = html('div');
  host.append(
    html('div', { class: 'controls' }, first.element, swap, second.element, scalar.element),
    table.element, notes,
    html('details', {}, html('summary', {}, 'What the columns mean'),
      html('p', { class: 'note' },
        'The largest error of any vertex: of x, y, z and 1/w in ulps (the distance of neighbouring ' +
        'numbers), on a screen of 3840 × 2160 pixels, and of an attribute. The exact polygon is ' +
        'computed in whole numbers of any length from the bits of the triangle.')));

  return (scene: Scene) => {
    const [a, b] = scene.answers;
    first.select.value = a.clipper.name;
    second.select.value = b.clipper.name;
    scalar.show(scene.state.scalar);
    const exact = exactOf(scene.state);
    table.setRows([
      answerRow('first', a, scene), answerRow('second', b, scene),
      tableRow([[swatch('exact'), 'exact'], exact === null ? '–' : String(exact.length),
                exactText(exact), '', '', '']),
    ]);
    notes.replaceChildren(description('first', a.clipper), description('second', b.clipper));
  };
}

export const kClippersPanel: Panel = { id: 'clippers', title: 'Clippers', mount };
