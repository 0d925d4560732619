// SPDX-License-Identifier: GPL-3.0-or-later
//
// The projection in double, for showing and dragging: from view space to clip space and back. What
// clippers are asked is projected by them (engine.ts), never here.

import type { Frustum, Triangle, Vec4, Vertex } from './engine';

interface Row { own: number; z: number; one: number }

// The rows of the matrix as spaces/projection.hpp has them: x_clip = x.own x + x.z z + x.one.
export function rowsOf(f: Frustum): { x: Row; y: Row; z: Row; w: Row } {
  const width = f.right - f.left, height = f.top - f.bottom;
  if (f.parallel) {
    const own = (size: number, shear: number, low: number, high: number): Row =>
      ({ own: 2 / size, z: (2 / size) * shear, one: -(high + low) / size });
    return { x: own(width, f.shearX, f.left, f.right), y: own(height, f.shearY, f.bottom, f.top),
             z: depthRow(f), w: { own: 0, z: 0, one: 1 } };
  }
  return { x: { own: 2 * f.near / width, z: (f.right + f.left) / width, one: 0 },
           y: { own: 2 * f.near / height, z: (f.top + f.bottom) / height, one: 0 },
           z: depthRow(f), w: { own: 0, z: -1, one: 0 } };
}

// Depth in [0, 1], 0 at the near plane, then stretched to the convention.
function depthRow(f: Frustum): Row {
  const length = f.far - f.near;
  const unit: Row = f.parallel
    ? { own: 0, z: -1 / length, one: -f.near / length }
    : f.infiniteFar ? { own: 0, z: -1, one: -f.near }
      : { own: 0, z: -f.far / length, one: -f.near * (f.far / length) };
  const w: Row = f.parallel ? { own: 0, z: 0, one: 1 } : { own: 0, z: -1, one: 0 };
  const combined = (a: number, b: number): Row =>
    ({ own: 0, z: a * unit.z + b * w.z, one: a * unit.one + b * w.one });
  switch (f.depth) {
    case 'minus_one_to_one': return combined(2, -1);
    case 'zero_to_one': return unit;
    case 'reversed': return combined(-1, 1);
  }
}

export function toClipPosition(f: Frustum, [x, y, z]: Vec4): Vec4 {
  const rows = rowsOf(f);
  const value = (row: Row, own: number) => row.own * own + row.z * z + row.one;
  return [value(rows.x, x), value(rows.y, y), value(rows.z, 0), value(rows.w, 0)];
}

// The point of view space with these x, y and w (perspective) or x, y and z (parallel); where z of
// clip space is not that of its w, it is left out of account.
export function toViewPosition(f: Frustum, [x, y, zClip, w]: Vec4): Vec4 {
  const rows = rowsOf(f);
  const z = f.parallel ? (zClip - rows.z.one) / rows.z.z : -w;
  const back = (row: Row, value: number) => (value - row.z * z - row.one) / row.own;
  return [back(rows.x, x), back(rows.y, y), z, 0];
}

export function toView(f: Frustum, triangle: Triangle): Triangle {
  return triangle.map((v: Vertex) =>
    ({ position: toViewPosition(f, v.position), attributes: v.attributes })) as Triangle;
}

// Whether a view volume has these numbers at all.
export function isInvertible(f: Frustum): boolean {
  const enclosed = f.left < f.right && f.bottom < f.top && (f.infiniteFar || f.near < f.far);
  return enclosed && (f.parallel ? !f.infiniteFar : f.near > 0);
}
