// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the vertices are: the signed distance of each from each plane, their outcodes, and what
// follows from these before anything is cut.

import type { Distances } from '../engine';
import { codesOf } from '../outcodes';
import type { Codes } from '../outcodes';
import type { Panel } from '../panel';
import type { Scene } from '../scene';
import { kLetters, planesThatCut } from '../state';
import { html, spoken, Table, tableRow } from './dom';
import type { Cell } from './dom';
import { planeForm, planeName, planeWords, short } from './text';

const has = (code: number, plane: number) => ((code >> plane) & 1) === 1;

function bitsText(code: number, planes: number): string {
  return code.toString(2).padStart(planes, '0');
}

function distanceCell(distances: Distances, plane: number): Cell {
  const value = short(distances.byPlane[plane]!, 5);
  if (!has(distances.outcode, plane)) return value;
  return html('span', { class: 'outside' }, value, spoken(' outside'));
}

const named = (code: number, planes: readonly number[]) =>
  planeWords(planes.filter((p) => has(code, p)));

function verdict({ all, any }: Codes, scene: Scene, planes: readonly number[]): string {
  if (any === 0) return 'No bit is set: all of the triangle is inside. It is accepted without a cut.';
  if (all !== 0) {
    return `All three vertices are outside of ${named(all, planes)}: nothing can be inside. The ` +
           'triangle is rejected without a cut.';
  }
  const rest = scene.exact?.length === 0
    ? ' No single plane rejects it, and yet nothing is inside: only the cuts find that out.' : '';
  return `Only ${named(any, planes)} must cut: all vertices are inside of the others.${rest}`;
}

function mount(host: HTMLElement) {
  const table = new Table('Signed distances of the vertices from the planes');
  const text = html('p', { class: 'verdict', 'aria-live': 'polite' });
  host.append(text, table.element,
    html('details', {}, html('summary', {}, 'How to read it'),
      html('p', { class: 'note' },
        'A distance of at least 0 is inside. It is linear along an edge, so that the edge from d₀ ' +
        'to d₁ crosses the plane at t = d₀ / (d₀ − d₁). Each vertex has a bit for each plane that ' +
        'it is outside of, the left plane’s last. A bit that all three have rejects the triangle; ' +
        'planes without any bit need not be looked at again.')));
  let columns = '';
  return (scene: Scene) => {
    const { volume, frustum } = scene.state;
    const planes = planesThatCut(volume);
    const all = scene.distances[0]!.byPlane.map((_, p) => p);
    const key = `${frustum.depth} ${planes.join()}`;
    if (key !== columns) {
      columns = key;
      table.setHead(['', ...all.map((p): Cell => [
        planeName(p), html('br'),
        html('small', {}, planes.includes(p) ? planeForm(frustum.depth, p) : 'is clamped')]),
        'outcode']);
    }
    const codes = codesOf(scene);
    const bits = (code: number) => html('code', {}, bitsText(code, all.length));
    const setNames = (code: number): Cell[] => [...all.map((p) => (has(code, p) ? '1' : '·')),
                                                bits(code)];
    table.setRows([
      ...scene.distances.map((d, i) =>
        tableRow([kLetters[i]!, ...all.map((p) => distanceCell(d, p)), bits(codes.each[i]!)])),
      tableRow(['any', ...setNames(codes.any)]), tableRow(['all', ...setNames(codes.all)]),
    ]);
    text.textContent = verdict(codes, scene, planes);
  };
}

export const kOutcodesPanel: Panel = { id: 'outcodes', title: 'Outcodes', mount };
