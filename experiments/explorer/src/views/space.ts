// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a space is to a plot: where its points stand there, what its volume looks like, and which
// numbers of the triangle a drag there gives. The plot itself (plot.ts) knows no space.

import type { Vec4, Vertex } from '../engine';
import type { Scene } from '../scene';
import type { State } from '../state';
import type { Lens, Vec3 } from './lens';
import type { Painter } from './painter';
import type { Colours } from './theme';

// A point of a plot: homogeneous there, with its w of clip space. Both are linear in the point of
// clip space, so that a point between two placed ones is placed between them.
export interface Placed {
  at: Vec4;
  w: number;
}

export interface Canvas {
  painter: Painter;
  lens: Lens;
  colours: Colours;
}

export interface Space {
  id: string;
  label: string; // in a sentence: "A in view space"
  makeLens(): Lens;
  // The vertices of the triangle; null where this space has none.
  triangle(scene: Scene): Placed[] | null;
  // A point of clip space.
  place(scene: Scene, clip: Vec4): Placed;
  // A polygon of an answer; null where it cannot be shown here.
  placeAnswer(scene: Scene, polygon: readonly Vertex[]): Placed[] | null;
  drawVolume(scene: Scene, canvas: Canvas): void;
  // What a plot that is fitted shows.
  landmarks(scene: Scene): Vec3[];
  // The state's numbers of a vertex that stood at `from` with the numbers `held` and comes to stand
  // at `to`; null where there are none.
  move(scene: Scene, held: Vec4, to: Vec3, from: Vec3): Vec4 | null;
  // The number of the state that lies along an axis of the plot.
  component(axis: 0 | 1 | 2, state: State): { index: number; sign: 1 | -1 };
  // The numbers of a vertex here, as text.
  values(scene: Scene, vertex: number): string;
  // The coordinate that a drag keeps, where it is not the depth on the screen.
  kept: 2 | null;
}

// In the plot; null at infinity and where there is no such point.
export function pointOf(space: Space, scene: Scene, vertex: number): Vec3 | null {
  const [x, y, z, h] = space.triangle(scene)?.[vertex]?.at ?? [0, 0, 0, 0];
  const point: Vec3 = [x / h, y / h, z / h];
  return h !== 0 && point.every(Number.isFinite) ? point : null;
}

// A polygon of NDC as points of clip space; null unless all of it lies before the eye, for else it
// exists only after the divide.
export function beforeDivide(polygon: readonly Vertex[]): Vec4[] | null {
  const points = polygon.map(({ position: [x, y, z, inverse] }): Vec4 =>
    [x / inverse, y / inverse, z / inverse, 1 / inverse]);
  return points.every((p) => p[3] > 0 && p.every(Number.isFinite)) ? points : null;
}
