// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the pictures of clip space have in common: the pyramid (pyramid.ts) and the slices
// (slices.ts). Clip space has four dimensions; each picture shows it by a linear map.

import type { Vec4, Vertex } from '../engine';
import { short } from '../floats';
import { isInvertible, rowsOf, toClipPosition, toViewPosition } from '../projection';
import type { Scene } from '../scene';
import type { State } from '../state';
import type { Vec3 } from './lens';
import { beforeDivide, type Placed } from './space';

export const kNames = ['x', 'y', 'z', 'w'] as const;

// The numbers of the state for a vertex that comes to a point of clip space. In view space z
// follows w, and a parallel projection has no w but 1.
export function moved({ state: { space, frustum: f } }: Scene, to: Vec4): Vec4 | null {
  if (space === 'clip') return to;
  return isInvertible(f) ? toViewPosition(f, to) : null;
}

export function inClip({ state: { space, frustum } }: Scene, held: Vec4): Vec4 {
  return space === 'clip' ? held : toClipPosition(frustum, held);
}

function clipValues(scene: Scene, vertex: number): string {
  return kNames.map((name, i) => `${name} ${short(scene.clip[vertex]!.position[i]!)}`).join(', ');
}

// The number of the state that w or z of clip space comes from.
export function along(name: 'z' | 'w', { space, frustum }: State): { index: number; sign: 1 | -1 } {
  if (space === 'clip') return { index: name === 'w' ? 3 : 2, sign: 1 };
  const slope = name === 'w' ? -1 : rowsOf(frustum).z.z;
  return { index: 2, sign: slope < 0 ? -1 : 1 };
}

// A space that shows clip space by a linear map.
export function shownBy(at: (clip: Vec4) => Vec4) {
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

export function finite(points: Vec3[]): Vec3[] {
  return points.filter((p) => p.every(Number.isFinite));
}
