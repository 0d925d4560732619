// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws a volume with eight corners: the frustum or the cube. Edges that it hides are dashed.

import type { Frustum, Vec4 } from '../engine';
import { toViewPosition } from '../projection';
import type { Vec3 } from './lens';
import type { Canvas } from './space';

// z / w at the near and at the far plane.
export function depthEnds({ depth }: Frustum): { near: number; far: number } {
  switch (depth) {
    case 'minus_one_to_one': return { near: -1, far: 1 };
    case 'zero_to_one': return { near: 0, far: 1 };
    case 'reversed': return { near: 1, far: 0 };
  }
}

// The corners of the frustum in view space, not beyond the farthest w: bit 0 of the index is x
// (right), bit 1 y (top) and bit 2 far. Corners at infinity have h = 0.
export function frustumCorners(f: Frustum, farthest: number): Vec4[] {
  return Array.from({ length: 8 }, (_, i) => {
    const isFar = (i & 4) !== 0;
    const x = (i & 1) !== 0 ? 1 : -1, y = (i & 2) !== 0 ? 1 : -1;
    const ends = depthEnds(f);
    if (f.parallel) return point(toViewPosition(f, [x, y, isFar ? ends.far : ends.near, 1]), 1);
    const w = isFar ? Math.min(f.far, farthest) : f.near;
    if (isFar && f.infiniteFar && farthest === Infinity) {
      return point(toViewPosition(f, [x, y, 0, 1]), 0);
    }
    return point(toViewPosition(f, [x * w, y * w, 0, w]), 1);
  });
}

function point([x, y, z]: Vec4, h: number): Vec4 {
  return [x, y, z, h];
}

export const kMarked = 0.22; // opacity of the plane that cuts

// In the order of the planes: left, right, bottom, top, near, far.
const kFaces = [[0, 2, 6, 4], [1, 3, 7, 5], [0, 1, 5, 4], [2, 3, 7, 6], [0, 1, 3, 2], [4, 5, 7, 6]];

// `seen` says which faces are seen from outside; one face may be marked.
export function drawBox({ painter, colours }: Canvas, corners: readonly Vec4[],
                        seen: readonly boolean[], marked: number | null) {
  const colour = colours.volume;
  kFaces.forEach((face, plane) => painter.area(
    face.map((i) => corners[i]!), { colour, alpha: plane === marked ? kMarked : 0.045 }));
  for (let a = 0; a < 8; ++a) {
    for (const b of [a | 1, a | 2, a | 4].filter((other) => other !== a)) {
      const isSeen = kFaces.some((face, i) => seen[i] && face.includes(a) && face.includes(b));
      painter.line([corners[a]!, corners[b]!],
                   { colour, width: isSeen ? 1.4 : 1, dash: isSeen ? [] : [3, 4] });
    }
  }
}

// Short arrows from the origin with the letters of the axes.
export function drawAxes({ painter, lens, colours }: Canvas, axes: readonly [string, Vec3][]) {
  const length = 46 * lens.pixelSize([0, 0, 0]);
  const style = { colour: colours.faint, width: 1 };
  for (const [name, direction] of axes) {
    const at = (scale: number): Vec4 =>
      [...direction.map((d) => scale * length * d) as Vec3, 1];
    painter.line([at(0), at(1)], style);
    painter.text(at(1.22), name, { ...style, paper: colours.paper, align: 'center' });
  }
}
