// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clip space has four dimensions: three slices of it (x, y or z against w), in which clip planes are
// lines through the origin, and a projection of x, y and w, in which the sides are a pyramid.

import type { Frustum, Vec4, Vertex } from '../engine';
import { niceStep, short, toStep } from '../floats';
import { isInvertible, rowsOf, toClipPosition, toViewPosition } from '../projection';
import type { Scene } from '../scene';
import type { State } from '../state';
import { depthEnds, drawAxes } from './box';
import { OrbitLens, PlaneLens, type Vec3 } from './lens';
import { beforeDivide, type Canvas, type Placed, type Space } from './space';
import { reachOf } from './view_space';

const kNames = ['x', 'y', 'z', 'w'] as const;

// The numbers of the state for a vertex that comes to a point of clip space. In view space z follows
// w, and a parallel projection has no w but 1.
function moved({ state: { space, frustum: f } }: Scene, to: Vec4): Vec4 | null {
  if (space === 'clip') return to;
  return isInvertible(f) ? toViewPosition(f, to) : null;
}

function inClip({ state: { space, frustum } }: Scene, held: Vec4): Vec4 {
  return space === 'clip' ? held : toClipPosition(frustum, held);
}

function clipValues(scene: Scene, vertex: number): string {
  return kNames.map((name, i) => `${name} ${short(scene.clip[vertex]!.position[i]!)}`).join(', ');
}

// The number of the state that w or z of clip space comes from.
function along(name: 'z' | 'w', { space, frustum }: State): { index: number; sign: 1 | -1 } {
  if (space === 'clip') return { index: name === 'w' ? 3 : 2, sign: 1 };
  const slope = name === 'w' ? -1 : rowsOf(frustum).z.z;
  return { index: 2, sign: slope < 0 ? -1 : 1 };
}

// A space that shows clip space by a linear map.
function shownBy(at: (clip: Vec4) => Vec4) {
  const place = (_: Scene, clip: Vec4): Placed => ({ at: at(clip), w: clip[3] });
  return {
    place,
    placeAnswer: (scene: Scene, polygon: readonly Vertex[]) =>
      beforeDivide(polygon)?.map((p) => place(scene, p)) ?? null,
    triangle: (scene: Scene) => scene.clip.map((v) => place(scene, v.position)),
    values: clipValues,
    kept: null,
  };
}

function finite(points: Vec3[]): Vec3[] {
  return points.filter((p) => p.every(Number.isFinite));
}

function drawPyramid({ state: { frustum, space } }: Scene, canvas: Canvas) {
  const { painter, lens, colours } = canvas;
  const [x, y, z] = lens.eye!;
  const w = -z;
  const outside = [w + x, w - x, w + y, w - y].map((d) => d < 0);
  const ray = (i: number): Vec4 => [(i & 1) !== 0 ? 1 : -1, (i & 2) !== 0 ? 1 : -1, -1, 0];
  const apex: Vec4 = [0, 0, 0, 1];
  const colour = colours.volume;
  [[0, 2], [1, 3], [0, 1], [2, 3]].forEach(([a, b]) =>
    painter.area([apex, ray(a!), ray(b!)], { colour, alpha: 0.06 }));
  for (let i = 0; i < 4; ++i) {
    const isSeen = outside[i & 1]! || outside[2 + (i >> 1)]!;
    painter.line([apex, ray(i)], { colour, width: isSeen ? 1.4 : 1, dash: isSeen ? [] : [3, 4] });
  }
  const square = (size: number): Vec4[] => [0, 1, 3, 2].map((i) => {
    const [dx, dy, dz] = ray(i);
    return [size * dx, size * dy, size * dz, 1];
  });
  if (space === 'view' && !frustum.parallel) {
    const ends = frustum.infiniteFar ? [frustum.near] : [frustum.near, frustum.far];
    ends.forEach((size, i) => {
      painter.outline(square(size), { colour, width: 1.2 });
      painter.text(square(size)[2]!, i === 0 ? 'near' : 'far',
                   { colour, paper: colours.paper, dx: 6, dy: -8 });
    });
  }
  drawAxes(canvas, [0, 0, 0], [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['w', [0, 0, -1]]]);
  painter.dot(apex, 3, { colour: colours.faint });
}

export const kPyramid: Space = {
  id: 'xyw',
  label: 'clip space, x y w',
  makeLens: () => new OrbitLens({ yaw: 0.62, pitch: 0.36 }),
  ...shownBy(([x, y, , w]) => [x, y, -w, 1]),
  drawVolume: drawPyramid,
  landmarks(scene: Scene) {
    const size = 1.15 * reachOf(scene);
    const ends = [0, 1, 2, 3].map((i): Vec3 =>
      [(i & 1) !== 0 ? size : -size, (i & 2) !== 0 ? size : -size, -size]);
    return finite([[0, 0, 0], ...ends,
                   ...scene.clip.map(({ position: [x, y, , w] }): Vec3 => [x, y, -w])]);
  },
  move(scene: Scene, held: Vec4, [x, y, z]: Vec3) {
    return moved(scene, [x, y, inClip(scene, held)[2], -z]);
  },
  component(axis: 0 | 1 | 2, state: State) {
    if (axis !== 2) return { index: axis, sign: 1 };
    const { index, sign } = along('w', state);
    return { index, sign: sign === 1 ? -1 : 1 };
  },
};

// Where a coordinate stands between its two planes: from low w to high w.
interface Range { low: number; high: number; names: [string, string]; isOpen: [boolean, boolean] }

function rangeOf(coordinate: 0 | 1 | 2, { frustum, volume }: State): Range {
  const { left, right, bottom, top } = volume.openSides;
  if (coordinate === 0) {
    return { low: -1, high: 1, names: ['left', 'right'], isOpen: [left, right] };
  }
  if (coordinate === 1) {
    return { low: -1, high: 1, names: ['bottom', 'top'], isOpen: [bottom, top] };
  }
  const { near, far } = depthEnds(frustum);
  const isNearLow = near < far;
  const open: [boolean, boolean] = [volume.clampNear, volume.clampFar];
  return isNearLow ? { low: near, high: far, names: ['near', 'far'], isOpen: open }
    : { low: far, high: near, names: ['far', 'near'], isOpen: [open[1], open[0]] };
}

// The part of the slice on the canvas.
function windowOf({ painter, lens }: Canvas): { left: number; right: number; low: number; high: number } {
  const [left, low] = lens.pointAt({ x: 0, y: painter.height }, [0, 0, 0]);
  const [right, high] = lens.pointAt({ x: painter.width, y: 0 }, [0, 0, 0]);
  return { left, right, low, high };
}

function drawScales(canvas: Canvas, name: string) {
  const { painter, lens, colours } = canvas;
  const { left, right, low, high } = windowOf(canvas);
  const step = niceStep(48 * lens.pixelSize([0, 0, 0]));
  const grid = { colour: colours.line, width: 1, alpha: 0.6 };
  const text = { colour: colours.faint, paper: colours.paper, size: 10 };
  for (let i = Math.ceil(left / step); i <= right / step; ++i) {
    const x = toStep(i * step, step);
    painter.line([[x, low, 0, 1], [x, high, 0, 1]], grid);
    painter.text([x, low, 0, 1], short(x), { ...text, dy: -8, align: 'center' });
  }
  for (let i = Math.ceil(low / step); i <= high / step; ++i) {
    const w = toStep(i * step, step);
    painter.line([[left, w, 0, 1], [right, w, 0, 1]], grid);
    painter.text([left, w, 0, 1], short(w), { ...text, dx: 3 });
  }
  const axis = { ...text, size: 13, colour: colours.ink };
  painter.text([right, low, 0, 1], name, { ...axis, dx: -9, dy: -9, align: 'right' });
  painter.text([left, high, 0, 1], 'w', { ...axis, dx: 9, dy: 10 });
}

function drawRegion(canvas: Canvas, range: Range) {
  const { painter, colours } = canvas;
  const { left, right, low } = windowOf(canvas);
  const colour = colours.volume;
  // Open sides go on to infinity; the eye is at the apex.
  const ends: [Vec4, Vec4] = [range.isOpen[0] ? [-1, 0, 0, 0] : [range.low, 1, 0, 0],
                              range.isOpen[1] ? [1, 0, 0, 0] : [range.high, 1, 0, 0]];
  painter.area([[0, 0, 0, 1], ends[0], [0, 1, 0, 0], ends[1]], { colour, alpha: 0.13 });
  if (low < 0) {
    const corners: Vec4[] = [[left, 0, 0, 1], [right, 0, 0, 1], [right, low, 0, 1], [left, low, 0, 1]];
    painter.area(corners, { colour: colours.faint, alpha: 0.3, isHatched: true });
    painter.text([right, 0, 0, 1], 'w < 0, behind the eye',
                 { colour: colours.faint, paper: colours.paper, dx: -6, dy: 10, align: 'right', size: 10 });
  }
  painter.line([[left, 0, 0, 1], [right, 0, 0, 1]], { colour: colours.faint, width: 1 });
  [range.low, range.high].forEach((slope, i) => {
    painter.line([[0, 0, 0, 1], [slope, 1, 0, 0]], { colour, width: range.isOpen[i] ? 0.8 : 1.6 });
    painter.line([[0, 0, 0, 1], [-slope, -1, 0, 0]], { colour, width: 0.8, dash: [3, 4] });
    nameOfLine(canvas, slope, range.names[i]!);
  });
}

// The name of a plane stands where its line leaves the canvas.
function nameOfLine(canvas: Canvas, slope: number, name: string) {
  const { painter, colours, lens } = canvas;
  const { left, right, high } = windowOf(canvas);
  const side = slope < 0 ? left : right;
  const w = slope === 0 ? high : Math.min(high, side / slope);
  if (!(w > 0)) return;
  const text = { colour: colours.volume, paper: colours.paper, size: 11 };
  const inset = 30 * lens.pixelSize([0, 0, 0]);
  painter.text([slope * (w - inset), w - inset, 0, 1], name,
               { ...text, dx: slope < 0 ? 8 : slope > 0 ? -8 : 5, align: slope > 0 ? 'right' : 'left' });
}

// All points of view space have a z that follows from w: they stand on one line.
function depthLine(f: Frustum): { from: Vec4; direction: Vec4 } {
  const { z, w } = rowsOf(f);
  return { from: [z.one, w.one, 0, 1], direction: [z.z, w.z, 0, 0] };
}

function drawDepthLine({ state: { frustum } }: Scene, { painter, colours }: Canvas) {
  if (!isInvertible(frustum)) return;
  const { from, direction } = depthLine(frustum);
  for (const sign of [1, -1]) {
    painter.line([from, direction.map((v) => sign * v) as Vec4],
                 { colour: colours.faint, width: 1, dash: [1, 3] });
  }
}

// The z of view space whose z and w of clip space are nearest to a point of the slice.
function nearestDepth(f: Frustum, zClip: number, w: number): number {
  const { from, direction } = depthLine(f);
  const [dz, dw] = direction;
  return ((zClip - from[0]) * dz + (w - from[1]) * dw) / (dz * dz + dw * dw);
}

function moveInSlice(coordinate: 0 | 1 | 2, scene: Scene, held: Vec4, [value, w]: Vec3): Vec4 | null {
  const { space, frustum } = scene.state;
  const to: Vec4 = [...inClip(scene, held)];
  if (space === 'view' && coordinate === 2) {
    if (!isInvertible(frustum)) return null;
    const depth = toClipPosition(frustum, [0, 0, nearestDepth(frustum, value, w), 0]);
    return moved(scene, [to[0], to[1], depth[2], depth[3]]);
  }
  to[coordinate] = value;
  to[3] = w;
  return moved(scene, to);
}

function slice(coordinate: 0 | 1 | 2): Space {
  const name = kNames[coordinate];
  return {
    id: `${name}w`,
    label: `clip space, ${name} and w`,
    makeLens: () => new PlaneLens(),
    ...shownBy((clip) => [clip[coordinate], clip[3], 0, 1]),
    drawVolume(scene: Scene, canvas: Canvas) {
      drawScales(canvas, name);
      drawRegion(canvas, rangeOf(coordinate, scene.state));
      if (coordinate === 2 && scene.state.space === 'view') drawDepthLine(scene, canvas);
    },
    landmarks(scene: Scene) {
      const size = 1.1 * reachOf(scene);
      return finite([[-size, size, 0], [size, size, 0], [0, -0.3 * size, 0],
                     ...scene.clip.map(({ position: p }): Vec3 => [p[coordinate], p[3], 0])]);
    },
    move: (scene: Scene, held: Vec4, to: Vec3) => moveInSlice(coordinate, scene, held, to),
    component(axis: 0 | 1 | 2, state: State) {
      if (axis === 1) return along('w', state);
      return coordinate === 2 ? along('z', state) : { index: coordinate, sign: 1 };
    },
  };
}

export const kSlices: readonly Space[] = [slice(0), slice(1), slice(2)];
