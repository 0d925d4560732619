// SPDX-License-Identifier: GPL-3.0-or-later
//
// Slices of clip space: x, y or z against w, in which clip planes are lines through the origin.

import type { Frustum, Vec4 } from '../engine';
import { niceStep, short, toStep } from '../floats';
import { isInvertible, rowsOf, toClipPosition } from '../projection';
import type { Scene } from '../scene';
import type { State } from '../state';
import { depthEnds } from './box';
import { along, finite, inClip, kNames, moved, shownBy } from './clip_space';
import { lastPlane, planeName } from './layers';
import { PlaneLens, type Vec3 } from './lens';
import type { Canvas, Space } from './space';
import { reachOf } from './view_space';

// Where a coordinate stands between its two planes: from low w to high w. A plane may not own the
// points that are on it, and one of depth may not clip at all.
interface Range {
  low: number;
  high: number;
  names: [string, string];
  isHalfOpen: [boolean, boolean];
  isClamped: [boolean, boolean];
}
const kNeither: [boolean, boolean] = [false, false];

function rangeOf(coordinate: 0 | 1 | 2, { frustum, volume }: State): Range {
  const { left, right, bottom, top } = volume.openSides;
  if (coordinate === 0) {
    return { low: -1, high: 1, names: ['left', 'right'], isHalfOpen: [left, right],
             isClamped: kNeither };
  }
  if (coordinate === 1) {
    return { low: -1, high: 1, names: ['bottom', 'top'], isHalfOpen: [bottom, top],
             isClamped: kNeither };
  }
  const { near, far } = depthEnds(frustum);
  const { clampNear, clampFar } = volume;
  return near < far
    ? { low: near, high: far, names: ['near', 'far'], isHalfOpen: kNeither,
        isClamped: [clampNear, clampFar] }
    : { low: far, high: near, names: ['far', 'near'], isHalfOpen: kNeither,
        isClamped: [clampFar, clampNear] };
}

// The part of the slice on the canvas.
function windowOf({ painter, lens }: Canvas) {
  const [left, low] = lens.pointAt({ x: 0, y: painter.height }, [0, 0, 0]);
  const [right, high] = lens.pointAt({ x: painter.width, y: 0 }, [0, 0, 0]);
  return { left, right, low, high };
}

function drawScales(canvas: Canvas, name: string) {
  const { painter, lens, colours } = canvas;
  const { left, right, low, high } = windowOf(canvas);
  const pixel = lens.pixelSize([0, 0, 0]);
  const step = niceStep(36 * pixel);
  const grid = { colour: colours.line, width: 1, alpha: 0.6 };
  const text = { colour: colours.faint, paper: colours.paper, size: 10 };
  for (let i = Math.ceil(left / step); i <= right / step; ++i) {
    const x = toStep(i * step, step);
    painter.line([[x, low, 0, 1], [x, high, 0, 1]], grid);
    // The corners are the other axis's and the name's.
    if (x - left > 26 * pixel && right - x > 28 * pixel) {
      painter.text([x, low, 0, 1], short(x), { ...text, dy: -8, align: 'center' });
    }
  }
  for (let i = Math.ceil(low / step); i <= high / step; ++i) {
    const w = toStep(i * step, step);
    painter.line([[left, w, 0, 1], [right, w, 0, 1]], grid);
    if (high - w > 22 * pixel) painter.text([left, w, 0, 1], short(w), { ...text, dx: 3 });
  }
  const axis = { ...text, size: 13, colour: colours.ink };
  painter.text([right, low, 0, 1], name, { ...axis, dx: -9, dy: -9, align: 'right' });
  painter.text([left, high, 0, 1], 'w', { ...axis, dx: 9, dy: 10 });
}

function drawRegion(canvas: Canvas, range: Range, marked: string | null) {
  const { painter, colours } = canvas;
  const { left, right, low } = windowOf(canvas);
  const colour = colours.volume;
  // The region goes on to infinity where a plane does not clip; the eye is at the apex.
  const ends: [Vec4, Vec4] = [range.isClamped[0] ? [-1, 0, 0, 0] : [range.low, 1, 0, 0],
                              range.isClamped[1] ? [1, 0, 0, 0] : [range.high, 1, 0, 0]];
  painter.area([[0, 0, 0, 1], ends[0], [0, 1, 0, 0], ends[1]], { colour, alpha: 0.13 });
  if (low < 0) {
    const rows = [[left, 0], [right, 0], [right, low], [left, low]] as const;
    painter.area(rows.map(([x, w]): Vec4 => [x, w, 0, 1]),
                 { colour: colours.faint, alpha: 0.3, isHatched: true });
    painter.text([right, 0, 0, 1], 'w < 0, behind the eye',
                 { colour: colours.faint, paper: colours.paper, dx: -6, dy: 10, align: 'right',
                   size: 10 });
  }
  painter.line([[left, 0, 0, 1], [right, 0, 0, 1]], { colour: colours.faint, width: 1 });
  [range.low, range.high].forEach((slope, i) => {
    painter.line([[0, 0, 0, 1], [slope, 1, 0, 0]],
                 { colour, width: range.isClamped[i] ? 0.8 : range.names[i] === marked ? 4 : 1.6,
                   dash: range.isHalfOpen[i] ? [6, 4] : [] });
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
               { ...text, dx: slope < 0 ? 8 : slope > 0 ? -8 : 5,
                 align: slope > 0 ? 'right' : 'left' });
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

function moveInSlice(coordinate: 0 | 1 | 2, scene: Scene, held: Vec4,
                     [value, w]: Vec3): Vec4 | null {
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
      const plane = lastPlane(scene.state);
      drawRegion(canvas, rangeOf(coordinate, scene.state),
                 plane === null ? null : planeName(plane));
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
