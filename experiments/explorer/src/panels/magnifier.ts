// SPDX-License-Identifier: GPL-3.0-or-later
//
// The magnifier: the surroundings of one exact vertex, from the whole screen down to single ulps,
// where the numbers that there are form a grid.

import { errorOf, exactOf } from '../compare';
import type { Scalar, Vertex } from '../engine';
import { nearest } from '../exact';
import type { ExactVertex, Rational } from '../exact';
import type { Page, Panel } from '../panel';
import type { Scene } from '../scene';
import { kMostZoom } from '../state';
import type { State } from '../state';
import { button, html, svg } from './dom';
import { neighbours } from './neighbours';
import { short } from './text';
import { chosenVertex, vertexChoice } from './vertex_choice';

const kSize = 400;              // of the picture, in its units
const kWhole = 2.2;             // half of what it shows at zoom 0, in NDC: the whole screen
const kLeastGrid = 7;           // lines nearer to each other than this are not drawn
const kPixelZoom = 12;          // where a pixel of 3840 is about a quarter of the picture
const kClear = 14;              // where lines are this far apart, one sees them well
const kMostApart = 24;          // spacings of x and y that differ by more aren't seen together

type Point = [number, number];

// How far the numbers around x are apart; at a power of two the mean of both sides.
function spacing(x: number, scalar: Scalar): number {
  const { below, above } = neighbours(x, scalar);
  return (above - below) / 2;
}

// NDC relative to the exact vertex, which is in the middle, to the picture.
class Lens {
  readonly half: number; // of what is shown, in NDC

  constructor(private readonly centre: ExactVertex, zoom: number) {
    this.half = kWhole * 2 ** -zoom;
  }

  // Where a number stands along an axis (0: x, 1: y).
  place(value: number, axis: 0 | 1): number {
    const offset = errorOf(value, this.centre.position[axis]);
    return kSize / 2 + (axis === 0 ? 1 : -1) * offset / this.half * (kSize / 2);
  }

  point(v: Vertex): Point {
    return [this.place(v.position[0], 0), this.place(v.position[1], 1)];
  }

  exactPoint(v: ExactVertex): Point {
    const offset = (axis: 0 | 1) => {
      const a = v.position[axis], c: Rational = this.centre.position[axis];
      return nearest({ n: a.n * c.d - c.n * a.d, d: a.d * c.d }, 'double');
    };
    const scale = kSize / 2 / this.half;
    return [kSize / 2 + offset(0) * scale, kSize / 2 - offset(1) * scale];
  }
}

// The part of the segment in the picture and a little around it: pictures can't draw a line that
// is 2^50 of them long.
function shortened([x0, y0]: Point, [x1, y1]: Point): [Point, Point] | null {
  let t0 = 0, t1 = 1;
  const keep = (d0: number, d1: number) => { // where d >= 0
    if (d0 < 0 && d1 < 0) t1 = -1;
    else if (d0 < 0) t0 = Math.max(t0, d0 / (d0 - d1));
    else if (d1 < 0) t1 = Math.min(t1, d0 / (d0 - d1));
  };
  for (const [a, b] of [[x0, x1], [y0, y1]] as const) {
    keep(a + kSize, b + kSize);
    keep(2 * kSize - a, 2 * kSize - b);
  }
  if (t0 > t1) return null;
  const at = (t: number): Point => [x0 + t * (x1 - x0), y0 + t * (y1 - y0)];
  return [at(t0), at(t1)];
}

function outline(points: readonly Point[], className: string): SVGElement {
  const group = svg('g', { class: className });
  points.forEach((p, i) => {
    if (![...p, ...points[(i + 1) % points.length]!].every(Number.isFinite)) return;
    const line = shortened(p, points[(i + 1) % points.length]!);
    if (line === null) return;
    const [[x1, y1], [x2, y2]] = line;
    group.append(svg('line', { x1, y1, x2, y2 }));
  });
  for (const [x, y] of className === 'screen' ? [] : points) {
    if (!(Math.abs(x) < 2 * kSize && Math.abs(y) < 2 * kSize)) continue;
    group.append(svg('circle', { cx: x, cy: y, r: className === 'exact' ? 3 : 6 }));
  }
  return group;
}

// The numbers that there are along an axis, from end to end of the picture; none where they are too
// near to each other.
function gridLines(lens: Lens, centre: Rational, axis: 0 | 1, scalar: Scalar): number[] {
  const middle = nearest(centre, scalar);
  const { below, above } = neighbours(middle, scalar);
  if (Math.abs(lens.place(above, axis) - lens.place(below, axis)) < 2 * kLeastGrid) return [];
  const lines = [middle];
  const isShown = (x: number) => Math.abs(lens.place(x, axis) - kSize / 2) <= kSize / 2;
  for (let x = below; isShown(x); x = neighbours(x, scalar).below) lines.push(x);
  for (let x = above; isShown(x); x = neighbours(x, scalar).above) lines.push(x);
  return lines.map((x) => lens.place(x, axis));
}

// The grid, the cell of four neighbouring floats that the exact point is in, and the nearest.
function grid(lens: Lens, centre: ExactVertex, scalar: Scalar): SVGElement {
  const [x, y] = centre.position;
  const columns = gridLines(lens, x, 0, scalar), rows = gridLines(lens, y, 1, scalar);
  const group = svg('g', { class: 'grid' });
  for (const c of columns) group.append(svg('line', { x1: c, x2: c, y1: 0, y2: kSize }));
  for (const r of rows) group.append(svg('line', { x1: 0, x2: kSize, y1: r, y2: r }));
  if (columns.length === 0 || rows.length === 0) return group;
  const around = (lines: number[]): [number, number] => {
    const low = Math.max(...lines.filter((p) => p <= kSize / 2), 0);
    return [low, Math.min(...lines.filter((p) => p > low), kSize)];
  };
  const [left, right] = around(columns), [top, bottom] = around(rows);
  group.prepend(svg('rect', { class: 'cell', x: left, y: top, width: right - left,
                              height: bottom - top }));
  const best: Point = [lens.place(nearest(x, scalar), 0), lens.place(nearest(y, scalar), 1)];
  group.append(svg('rect', { class: 'best', x: best[0] - 9, y: best[1] - 9, width: 18,
                             height: 18 }));
  return group;
}

// The border of the screen, where it is near.
function border(lens: Lens): SVGElement {
  const corners: [number, number][] = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
  const points = corners.map(([x, y]): Point => [lens.place(x, 0), lens.place(y, 1)]);
  return outline(points, 'screen');
}

// A pixel of the screen around the exact vertex, for its size.
function pixel(lens: Lens): SVGElement {
  const width = 2 / 3840 / lens.half * (kSize / 2), height = 2 / 2160 / lens.half * (kSize / 2);
  if (width < 6 || width > 6 * kSize) return svg('g');
  return svg('rect', { class: 'pixel', x: (kSize - width) / 2, y: (kSize - height) / 2, width,
                       height });
}

// The zoom at which the grid is clear in both directions, or in the coarser one.
function ulpZoom(state: State): number {
  const exact = exactOf(state);
  const vertex = exact?.[chosenVertex(state, exact)];
  if (vertex === undefined) return 0;
  const [x, y] = [0, 1].map((axis) => spacing(nearest(vertex.position[axis]!, state.scalar),
                                              state.scalar));
  const step = Math.max(Math.min(x!, y!), Math.max(x!, y!) / kMostApart);
  const half = step * (kSize / 2) / kClear;
  return Math.max(0, Math.min(kMostZoom, Math.round(Math.log2(kWhole / half))));
}

function scaleText(half: number, exact: ExactVertex, scalar: Scalar): string {
  const px = half * 2 * 3840 / 2;
  const ulps = 2 * half / spacing(nearest(exact.position[0], scalar), scalar);
  return `The picture is ${short(2 * half, 3)} wide in NDC: ${short(px, 3)} pixels ` +
         `of a screen 3840 wide, ${short(ulps, 3)} ulps of x.`;
}

function mount(host: HTMLElement, { store }: Page) {
  const vertex = vertexChoice('Vertex', store);
  const slider = html('input', {
    type: 'range', min: 0, max: kMostZoom, step: 1,
    input: () => store.update({ zoom: Number(slider.value) }),
  });
  const go = (label: string, zoom: () => number) =>
    button(label, () => store.update({ zoom: zoom() }));
  const picture = svg('svg', { viewBox: `0 0 ${kSize} ${kSize}`, class: 'magnifier', role: 'img' });
  const text = html('p', { class: 'verdict', 'aria-live': 'polite' });
  host.append(
    html('div', { class: 'beside' },
      html('div', {},
        html('div', { class: 'controls' }, vertex.element),
        html('label', { class: 'slider' }, 'Zoom', slider),
        html('div', { class: 'controls' }, go('whole screen', () => 0),
             go('one pixel', () => kPixelZoom),
             go('single ulps', () => ulpZoom(store.state))),
        text,
        html('p', { class: 'note' }, 'Each crossing of the grid is a point that the numbers can ' +
          'say. The exact point lies somewhere in the shaded cell; the square is around the ' +
          'nearest crossing, which is the best answer.')),
      picture));
  return (scene: Scene) => {
    const { zoom, scalar } = scene.state;
    slider.value = String(zoom);
    slider.setAttribute('aria-valuetext', `2 to the power of ${zoom}`);
    const exact = exactOf(scene.state);
    const at = vertex.show(exact);
    picture.replaceChildren();
    if (exact === null || at < 0) {
      text.textContent = 'Nothing is visible, so there is nothing to magnify.';
      return;
    }
    const centre = exact[at]!;
    const lens = new Lens(centre, zoom);
    const [first, second] = scene.answers.map(({ polygon }) =>
      (polygon ?? []).filter((v) => v.position.every(Number.isFinite)).map((v) => lens.point(v)));
    picture.append(grid(lens, centre, scalar), pixel(lens), border(lens), outline(second!, 'second'),
                   outline(first!, 'first'), outline(exact.map((v) => lens.exactPoint(v)), 'exact'));
    text.textContent = scaleText(lens.half, centre, scalar);
    picture.setAttribute('aria-label', `Surroundings of exact vertex ${at + 1}. ${text.textContent}`);
  };
}

export const kMagnifierPanel: Panel = { id: 'magnifier', title: 'Magnifier', mount };
