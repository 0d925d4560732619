// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first two attributes of a polygon at the centres of pixels of the whole screen, interpolated
// with perspective correction and without it.

import type { Vertex } from './engine';

// Row by row from the top; NaN where the polygon is not.
export interface Field { size: number; u: Float64Array; v: Float64Array }
export interface Fields { correct: Field; affine: Field }

interface Corner { x: number; y: number; inverse: number; u: number; v: number }

function field(size: number): Field {
  return { size, u: new Float64Array(size * size).fill(NaN),
           v: new Float64Array(size * size).fill(NaN) };
}

// In pixels, y down.
function cornerOf({ position: [x, y, , inverse], attributes: [u = 0, v = 0] }: Vertex,
                  size: number): Corner {
  return { x: (x + 1) * size / 2, y: (1 - y) * size / 2, inverse, u, v };
}

const doubleArea = (a: Corner, b: Corner, x: number, y: number) =>
  (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);

function drawTriangle([a, b, c]: [Corner, Corner, Corner], { correct, affine }: Fields) {
  const size = correct.size;
  const whole = doubleArea(a, b, c.x, c.y);
  if (whole === 0 || !Number.isFinite(whole)) return;
  const range = (values: number[]): [number, number] =>
    [Math.max(0, Math.floor(Math.min(...values))), Math.min(size, Math.ceil(Math.max(...values)))];
  const [x0, x1] = range([a.x, b.x, c.x]), [y0, y1] = range([a.y, b.y, c.y]);
  for (let y = y0; y < y1; ++y) {
    for (let x = x0; x < x1; ++x) {
      const la = doubleArea(b, c, x + 0.5, y + 0.5) / whole;
      const lb = doubleArea(c, a, x + 0.5, y + 0.5) / whole;
      const lc = 1 - la - lb;
      if (la < 0 || lb < 0 || lc < 0) continue;
      const at = y * size + x;
      affine.u[at] = la * a.u + lb * b.u + lc * c.u;
      affine.v[at] = la * a.v + lb * b.v + lc * c.v;
      const [qa, qb, qc] = [la * a.inverse, lb * b.inverse, lc * c.inverse];
      const sum = qa + qb + qc;
      correct.u[at] = (qa * a.u + qb * b.u + qc * c.u) / sum;
      correct.v[at] = (qa * a.v + qb * b.v + qc * c.v) / sum;
    }
  }
}

// The polygon as a fan of triangles around its first vertex, as it goes to a rasteriser.
export function fieldsOf(polygon: readonly Vertex[], size: number): Fields {
  const fields = { correct: field(size), affine: field(size) };
  const corners = polygon.map((v) => cornerOf(v, size));
  for (let i = 1; i + 1 < corners.length; ++i) {
    drawTriangle([corners[0]!, corners[i]!, corners[i + 1]!], fields);
  }
  return fields;
}

// The largest difference of either attribute at a pixel; 0 where there is no pixel.
export function largestDifference({ correct, affine }: Fields): number {
  let largest = 0;
  for (let i = 0; i < correct.u.length; ++i) {
    const du = Math.abs(correct.u[i]! - affine.u[i]!), dv = Math.abs(correct.v[i]! - affine.v[i]!);
    if (du > largest) largest = du;
    if (dv > largest) largest = dv;
  }
  return largest;
}

// w_max / w_min of the polygon: 1/w is its fourth coordinate. null where some w <= 0 or there is no
// vertex.
export function wRatio(polygon: readonly Vertex[]): number | null {
  const inverse = polygon.map((v) => v.position[3]);
  const least = Math.min(...inverse), most = Math.max(...inverse);
  return polygon.length > 0 && least > 0 && Number.isFinite(most) ? most / least : null;
}

// How far the affine parameter along an edge is from the true one at most, of an edge whose ends
// have w in this ratio.
export function largestParameterError(ratio: number): number {
  const root = Math.sqrt(ratio);
  return (root - 1) / (root + 1);
}
