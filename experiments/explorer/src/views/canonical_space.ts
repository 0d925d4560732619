// SPDX-License-Identifier: GPL-3.0-or-later
//
// The canonical view volume, after the divide. Points are drawn by their four numbers before it, so
// that an edge through w = 0 is seen as it is: two rays that go out to infinity.

import type { Frustum, Vec4, Vertex } from '../engine';
import { short } from '../floats';
import { isInvertible, rowsOf, toViewPosition } from '../projection';
import type { Scene } from '../scene';
import type { State } from '../state';
import { depthEnds, drawAxes, drawBox } from './box';
import { isDrawn, lastPlane } from './layers';
import { OrbitLens, type Vec3 } from './lens';
import type { Canvas, Placed, Space } from './space';
import { outsideOf } from './view_space';

// The near plane is drawn to the front, whatever its z.
function front({ depth }: Frustum): 1 | -1 {
  return depth === 'reversed' ? 1 : -1;
}

function place({ state: { frustum } }: Scene, [x, y, z, w]: Vec4): Placed {
  return { at: [x, y, front(frustum) * z, w], w };
}

function placeAnswer({ state: { frustum } }: Scene, polygon: readonly Vertex[]): Placed[] {
  return polygon.map(({ position: [x, y, z] }) =>
    ({ at: [x, y, front(frustum) * z, 1], w: 1 }));
}

// What is wrong with joining the divided vertices: the edge through w = 0 is not between them.
function drawWrongEdges(scene: Scene, { painter, colours }: Canvas) {
  scene.clip.forEach((a, i) => {
    const b = scene.clip[(i + 1) % 3]!;
    if (a.position[3] * b.position[3] >= 0) return;
    const ends = [a, b].map(({ position }) =>
      place(scene, position).at.map((n) => n / position[3]) as Vec4);
    painter.line(ends, { colour: colours.faint, width: 1, dash: [1, 4] });
  });
}

function drawVolume(scene: Scene, canvas: Canvas) {
  const { state: { frustum } } = scene;
  const { painter, lens, colours } = canvas;
  const ends = depthEnds(frustum), sign = front(frustum);
  const corners = Array.from({ length: 8 }, (_, i): Vec4 => [
    (i & 1) !== 0 ? 1 : -1, (i & 2) !== 0 ? 1 : -1,
    sign * ((i & 4) !== 0 ? ends.far : ends.near), 1]);
  const [x, y, z] = lens.eye!;
  drawBox(canvas, corners, outsideOf(frustum, [x, y, sign * z, 1]), lastPlane(scene.state));
  const label = { paper: colours.paper, colour: colours.volume, dy: -9, align: 'center' } as const;
  const infinity = frustum.infiniteFar ? ' (\u221e)' : '';
  painter.text(corners[2]!, `near, z = ${short(ends.near)}`, label);
  painter.text(corners[7]!, `far, z = ${short(ends.far)}${infinity}`, label);
  drawAxes(canvas, [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['z', [0, 0, sign]]]);
  if (isDrawn('input')) drawWrongEdges(scene, canvas);
}

// The w of view-space points that have this depth after the divide.
function viewDepth(f: Frustum, z: number): number {
  const row = rowsOf(f).z;
  return f.parallel ? (z - row.one) / row.z : -row.one / (z + row.z);
}

function move({ state: { space, frustum: f } }: Scene, held: Vec4, to: Vec3,
              from: Vec3): Vec4 | null {
  const x = to[0], y = to[1], z = front(f) * to[2];
  if (space === 'clip') {
    const w = held[3];
    return w === 0 ? null : [x * w, y * w, z * w, w];
  }
  if (!isInvertible(f)) return null;
  // What keeps z keeps the depth to the last bit.
  const depth = to[2] === from[2] ? held[2] : viewDepth(f, z);
  const w = f.parallel ? 1 : -depth;
  const [vx, vy] = toViewPosition(f, [x * w, y * w, f.parallel ? z : 0, w]);
  return [vx, vy, depth, 0];
}

function landmarks(scene: Scene): Vec3[] {
  const sign = front(scene.state.frustum), ends = depthEnds(scene.state.frustum);
  const near = (p: Vec3) => p.every((n) => Math.abs(n) < 2.5); // NaN is not
  const vertices = scene.ndc.flatMap((v) => v === null ? [] : [v.position])
    .map(([x, y, z]): Vec3 => [x, y, sign * z]).filter(near);
  const cube = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [ends.near, ends.far].map(
    (z): Vec3 => [1.1 * x, 1.1 * y, sign * z])));
  return [...cube, ...vertices];
}

export const kCanonicalSpace: Space = {
  id: 'canonical',
  label: 'the canonical view volume',
  kept: 2,
  makeLens: () => new OrbitLens({ yaw: 0.45, pitch: 0.3 }),
  triangle: (scene: Scene) => scene.clip.map((v) => place(scene, v.position)),
  place,
  placeAnswer,
  drawVolume,
  landmarks,
  move,
  component(axis: 0 | 1 | 2, state: State) {
    if (axis !== 2) return { index: axis, sign: 1 };
    const sign = state.space === 'clip' ? front(state.frustum) : 1;
    return { index: 2, sign };
  },
  values(scene: Scene, vertex: number) {
    const position = scene.ndc[vertex]?.position;
    if (position === undefined) return 'at infinity, w is 0';
    return ['x', 'y', 'z'].map((name, i) => `${name} ${short(position[i]!)}`).join(', ') +
      (position[3] < 0 ? ', behind the eye' : '');
  },
};
