// SPDX-License-Identifier: GPL-3.0-or-later
//
// View space: the eye at the origin, looking down -z into the frustum.

import type { Frustum, Vec4, Vertex } from '../engine';
import { isInvertible, rowsOf, toClipPosition, toViewPosition } from '../projection';
import type { Scene } from '../scene';
import { short } from '../floats';
import type { State } from '../state';
import { depthEnds, drawAxes, drawBox, frustumCorners } from './box';
import { lastPlane } from './layers';
import { OrbitLens, type Vec3 } from './lens';
import { beforeDivide, type Canvas, type Placed, type Space } from './space';

// Whether a point of clip space is outside each of the six planes.
export function outsideOf(f: Frustum, [x, y, z, w]: Vec4): boolean[] {
  const ends = depthEnds(f);
  const inwards = ends.near < ends.far ? 1 : -1;
  const near = inwards * (z - ends.near * w), far = inwards * (ends.far * w - z);
  return [w + x, w - x, w + y, w - y, near, far].map((d) => d < 0);
}

// How large w becomes in the triangle, or in the nearest part of the volume.
export function reachOf(scene: Scene): number {
  const { near, parallel } = scene.state.frustum;
  const sizes = scene.clip.map((v) => Math.abs(v.position[3])).filter(Number.isFinite);
  return Math.max(parallel ? 1 : 2 * near, ...sizes);
}

// The w up to which a plot that is fitted shows the volume: to the far plane, if that leaves the
// triangle large enough.
export function shownDepth(scene: Scene): number {
  const { far, infiniteFar, parallel } = scene.state.frustum;
  const reach = reachOf(scene);
  return !parallel && !infiniteFar && far <= 3 * reach ? far : 1.3 * reach;
}

function place({ state }: Scene, clip: Vec4): Placed {
  const [x, y, z] = toViewPosition(state.frustum, clip);
  return { at: [x, y, z, 1], w: clip[3] };
}

function move({ state }: Scene, held: Vec4, [x, y, z]: Vec3): Vec4 | null {
  if (state.space === 'view') return [x, y, z, 0];
  const f = state.frustum;
  if (!isInvertible(f)) return null;
  const to = toClipPosition(f, [x, y, z, 0]);
  if (f.parallel) return [to[0], to[1], to[2], held[3]];
  // A z that is not that of its w differs from it by as much as before.
  const own = toClipPosition(f, toViewPosition(f, held))[2];
  return [to[0], to[1], to[2] + (held[2] - own), to[3]];
}

function drawVolume({ state }: Scene, canvas: Canvas) {
  const { frustum } = state;
  const { painter, lens, colours } = canvas;
  const faint = { colour: colours.faint, paper: colours.paper };
  const eye: Vec4 = [0, 0, 0, 1];
  if (isInvertible(frustum)) {
    const corners = frustumCorners(frustum, Infinity);
    const seen = outsideOf(frustum, toClipPosition(frustum, [...lens.eye!, 0]));
    drawBox(canvas, corners, seen, lastPlane(state));
    if (!frustum.parallel) {
      for (const corner of corners.slice(0, 4)) {
        painter.line([eye, corner], { colour: colours.volume, width: 0.8, dash: [2, 4] });
      }
    }
    const label = { ...faint, colour: colours.volume, dx: -5, dy: -7, align: 'right' } as const;
    painter.text(corners[2]!, 'near', label);
    if (!frustum.infiniteFar) painter.text(corners[6]!, 'far', label);
  } else {
    painter.text(eye, 'no view volume has these numbers', { ...faint, dy: -30, align: 'center' });
  }
  drawAxes(canvas, [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['\u2212z', [0, 0, -1]]]);
  if (frustum.parallel) return;
  painter.dot(eye, 4, faint);
  painter.text(eye, 'eye', { ...faint, dx: -8, dy: 10, align: 'right' });
}

function landmarks(scene: Scene): Vec3[] {
  const f = scene.state.frustum;
  const corners = isInvertible(f) ? frustumCorners(f, shownDepth(scene)) : [];
  const vertices = scene.view?.map((v) => v.position) ?? [];
  return [[0, 0, 0], ...[...corners, ...vertices].map(([x, y, z]): Vec3 => [x, y, z])]
    .filter((p): p is Vec3 => p.every(Number.isFinite));
}

export const kViewSpace: Space = {
  id: 'view',
  label: 'view space',
  kept: null,
  makeLens: () => new OrbitLens({ yaw: 0.8, pitch: 0.3 }),
  triangle(scene: Scene) {
    const { parallel } = scene.state.frustum;
    return scene.view?.map(({ position: [x, y, z] }): Placed =>
      ({ at: [x, y, z, 1], w: parallel ? 1 : -z })) ?? null;
  },
  place,
  placeAnswer: (scene: Scene, polygon: readonly Vertex[]) =>
    beforeDivide(polygon)?.map((p) => place(scene, p)) ?? null,
  drawVolume,
  landmarks,
  move,
  component(axis: 0 | 1 | 2, { space, frustum }: State) {
    if (axis !== 2 || space === 'view') return { index: axis, sign: 1 };
    if (!frustum.parallel) return { index: 3, sign: -1 };
    return { index: 2, sign: rowsOf(frustum).z.z < 0 ? -1 : 1 };
  },
  values(scene: Scene, vertex: number) {
    const position = scene.view?.[vertex]?.position;
    return position === undefined ? 'nowhere'
      : ['x', 'y', 'z'].map((name, i) => `${name} ${short(position[i]!)}`).join(', ');
  },
};
