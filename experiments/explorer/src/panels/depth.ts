// SPDX-License-Identifier: GPL-3.0-or-later
//
// Depth by convention: what the buffer keeps against the distance, and how far apart two surfaces
// must be at each distance to differ in it. The triangle's vertices are marked.

import { depthOf, distanceRange, kBuffers, resolutionOf } from '../depth';
import type { Buffer } from '../depth';
import type { Frustum } from '../engine';
import type { Panel } from '../panel';
import { isInvertible } from '../projection';
import type { Scene } from '../scene';
import { kLetters } from '../state';
import { html, svg, Table, tableRow } from './dom';
import { short } from './text';

// In the order in which they are drawn: the wide one is behind.
const kDrawn: readonly Buffer[] = ['fixed24', 'gl', 'zero_to_one', 'reversed'];
const kWidth = 460, kHeight = 220, kLeft = 52, kBottom = 26, kTop = 10, kRight = 12;
const kSamples = 160;

// From a range of values to a range of the picture, by logarithms where the values are.
interface Axis { low: number; high: number; isLogarithmic: boolean; from: number; to: number }

function place({ low, high, isLogarithmic, from, to }: Axis, value: number): number {
  const t = isLogarithmic ? Math.log(value / low) / Math.log(high / low)
    : (value - low) / (high - low);
  return from + t * (to - from);
}

function samples({ low, high, isLogarithmic }: Axis): number[] {
  return Array.from({ length: kSamples + 1 }, (_, i) => {
    const t = i / kSamples;
    return isLogarithmic ? low * (high / low) ** t : low + t * (high - low);
  });
}

// Round values from end to end, about five.
function ticks({ low, high, isLogarithmic }: Axis): number[] {
  if (isLogarithmic) {
    const first = Math.ceil(Math.log10(low) - 1e-9), last = Math.floor(Math.log10(high) + 1e-9);
    const every = Math.max(1, Math.ceil((last - first) / 5));
    const between = last - first > 2 ? [1] : [1, 2, 5];
    const values = [];
    for (let e = first - 1; e <= last; e += e < first ? 1 : every) {
      values.push(...between.map((m) => m * 10 ** e));
    }
    return values.filter((v) => v >= low * (1 - 1e-9) && v <= high * (1 + 1e-9));
  }
  return [0, 1, 2, 3, 4].map((i) => low + i / 4 * (high - low));
}

function axes(x: Axis, y: Axis): SVGElement {
  const group = svg('g', { class: 'axes' });
  for (const value of ticks(x)) {
    const at = place(x, value);
    group.append(svg('line', { x1: at, x2: at, y1: y.from, y2: y.to }),
                 svg('text', { x: at, y: y.from + 16, 'text-anchor': 'middle' }, short(value, 3)));
  }
  for (const value of ticks(y)) {
    const at = place(y, value);
    group.append(svg('line', { x1: x.from, x2: x.to, y1: at, y2: at }),
                 svg('text', { x: x.from - 5, y: at + 4, 'text-anchor': 'end' },
                     y.isLogarithmic ? value.toExponential(0).replace('-', '−') : short(value, 2)));
  }
  return group;
}

function curve(buffer: Buffer, x: Axis, y: Axis, value: (distance: number) => number): SVGElement {
  const points = samples(x).map((d) => [place(x, d), place(y, value(d))] as const)
    .filter((p) => p.every(Number.isFinite))
    .map(([px, py]) => `${px.toFixed(1)},${Math.max(y.to, Math.min(y.from, py)).toFixed(1)}`);
  return svg('polyline', { class: `curve ${buffer}`, points: points.join(' ') });
}

interface Mark { name: string; distance: number }

function marks(x: Axis, y: Axis, vertices: readonly Mark[]): SVGElement {
  const group = svg('g', { class: 'marks' });
  for (const { name, distance } of vertices) {
    if (!(distance >= x.low && distance <= x.high)) continue;
    const at = place(x, distance);
    group.append(svg('line', { x1: at, x2: at, y1: y.from, y2: y.to }),
                 svg('text', { x: at + 3, y: y.from - 4 }, name));
  }
  return group;
}

function plot(title: string) {
  const picture = svg('svg', { viewBox: `0 0 ${kWidth} ${kHeight}` });
  const show = (f: Frustum, vertices: readonly Mark[], range: [number, number],
                isLogarithmic: boolean, value: (b: Buffer, distance: number) => number,
                buffers: readonly Buffer[]) => {
    const [low, high] = distanceRange(f);
    const x: Axis = { low, high, isLogarithmic: low > 0, from: kLeft, to: kWidth - kRight };
    const y: Axis = { low: range[0], high: range[1], isLogarithmic, from: kHeight - kBottom, to: kTop };
    picture.replaceChildren(axes(x, y), marks(x, y, vertices),
                            ...buffers.map((b) => curve(b, x, y, (d) => value(b, d))));
  };
  return { element: html('figure', { role: 'img', 'aria-label': title }, html('figcaption', {}, title),
                        picture), show };
}

// The powers of ten around all values.
function decades(values: readonly number[]): [number, number] {
  const finite = values.filter((v) => v > 0 && Number.isFinite(v));
  return [10 ** Math.floor(Math.log10(Math.min(...finite))),
          10 ** Math.ceil(Math.log10(Math.max(...finite)) + 1e-9)];
}

function vertexMarks(scene: Scene): Mark[] {
  return (scene.view ?? []).map(({ position }, i) =>
    ({ name: kLetters[i]!, distance: -position[2] }));
}

function vertexRows(f: Frustum, vertices: readonly Mark[]) {
  const [low, high] = [f.near, f.infiniteFar ? Infinity : f.far];
  return vertices.map(({ name, distance }) => {
    const isInside = distance >= low && distance <= high;
    return tableRow([name, short(distance), ...kBuffers.map(({ id }) => (isInside
      ? [html('span', {}, short(depthOf(f, id, distance))),
         html('small', {}, `± ${short(resolutionOf(f, id, distance) / 2, 2)}`)]
      : 'outside'))]);
  });
}

function legend(): HTMLElement {
  return html('ul', { class: 'legend' }, ...kBuffers.map(({ id, name }) =>
    html('li', {}, html('span', { class: `line ${id}`, 'aria-hidden': 'true' }), name)));
}

function mount(host: HTMLElement) {
  const depths = plot('Depth against distance');
  const steps = plot('Smallest difference of distances that it tells');
  const table = new Table('Depth of the vertices by convention',
                          ['', 'distance', ...kBuffers.map((b) => b.name)]);
  const text = html('p', { class: 'verdict' });
  host.append(text, legend(), html('div', { class: 'curves' }, depths.element, steps.element),
    html('details', {}, html('summary', {}, 'The vertices in numbers'), table.element));
  let shown = '';
  return (scene: Scene) => {
    const f = scene.state.frustum;
    const isThere = isInvertible(f);
    text.textContent = isThere ? '' : 'The numbers of the frustum enclose no volume.';
    const vertices = vertexMarks(scene);
    const key = JSON.stringify([f, vertices]);
    if (!isThere || key === shown) return;
    shown = key;
    const range = distanceRange(f);
    const ids = kBuffers.map((b) => b.id);
    const middle = Math.sqrt(Math.max(range[0], 0) * range[1]) || range[1] / 2;
    text.textContent = `At distance ${short(middle, 3)} a reversed float tells apart what is ` +
      `${short(resolutionOf(f, 'reversed', middle), 2)} apart, OpenGL’s float ` +
      `${short(resolutionOf(f, 'gl', middle), 2)}.`;
    depths.show(f, vertices, [-1, 1], false, (b, d) => depthOf(f, b, d), kDrawn.slice(1));
    // At an end of the range a float is 0, and the numbers next to it are too near to matter.
    const inside = Array.from({ length: 31 }, (_, i) => range[0] + (i + 1) / 32 * (range[1] - range[0]));
    const all = ids.flatMap((b) => inside.map((d) => resolutionOf(f, b, d)));
    steps.show(f, vertices, decades(all), true, (b, d) => resolutionOf(f, b, d), kDrawn);
    table.setRows(vertexRows(f, vertices));
  };
}

export const kDepthPanel: Panel = { id: 'depth', title: 'Depth', mount };
