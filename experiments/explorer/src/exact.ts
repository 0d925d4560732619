// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact polygon of a question in big-integer rationals: the part of the triangle inside the
// volume, no number rounded. It shares no code with the clippers and none with reference/.
//
// Sutherland and Hodgman's algorithm on barycentric coordinates of the triangle. In view space the
// numbers of the frustum count, not a matrix rounded from them. The volume is closed but for its
// open sides; vertices with w = 0 are left out, and fewer than three vertices are nothing.

import type { Question, Scalar, Vertex } from './engine';
import { kPlanes, rounded } from './engine';
import { isInvertible } from './projection';
import { overOnePower, quotient } from './rational';
import type { Rational } from './rational';

export { decimal, exactly, nearest, ulpsFrom } from './rational';
export type { Rational } from './rational';

export interface ExactVertex {
  position: [Rational, Rational, Rational, Rational]; // x y z 1/w
  attributes: Rational[];
}

// A value at each vertex of the triangle; also the weights of a point, which need not add up to 1.
type Three = readonly [bigint, bigint, bigint];

// Clip coordinates in whole numbers: the true ones are these times 2^exponent / denominator.
interface ClipTriangle {
  x: Three;
  y: Three;
  z: Three;
  w: Three;
  denominator: bigint;
  exponent: number;
}

const three = (f: (i: number) => bigint): Three => [f(0), f(1), f(2)];
const sum = (a: Three, b: Three): Three => three((i) => a[i]! + b[i]!);
const difference = (a: Three, b: Three): Three => three((i) => a[i]! - b[i]!);
const at = (weights: Three, values: Three): bigint =>
  weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];

function greatestDivisor(a: bigint, b: bigint): bigint {
  while (b !== 0n) [a, b] = [b, a % b];
  return a < 0n ? -a : a;
}

function shortened(weights: Three): Three {
  const divisor = greatestDivisor(greatestDivisor(weights[0], weights[1]), weights[2]);
  return three((i) => weights[i]! / divisor);
}

// The whole numbers of coordinate k at the three vertices, where each vertex has so many in a row.
const column = (values: readonly bigint[], perVertex: number, k: number): Three =>
  three((i) => values[i * perVertex + k]!);

function clipTriangleOfClip(triangle: readonly Vertex[]): ClipTriangle {
  const { values, exponent } = overOnePower(triangle.flatMap((v) => v.position));
  const [x, y, z, w] = [0, 1, 2, 3].map((k) => column(values, 4, k)) as [Three, Three, Three, Three];
  return { x, y, z, w, denominator: 1n, exponent };
}

// glFrustum, glOrtho and their kin as quotients: row by row a numerator of whole numbers over the
// extent of the frustum in that direction. All four rows are brought to one denominator.
function clipTriangleOfView({ frustum: f, triangle }: Question): ClipTriangle {
  const far = f.infiniteFar ? 0 : f.far;
  const { values, exponent } = overOnePower([
    1, f.left, f.right, f.bottom, f.top, f.near, far, f.shearX, f.shearY,
    ...triangle.flatMap((v) => v.position.slice(0, 3))]);
  const [one, left, right, bottom, top, near, end, shearX, shearY] = values as bigint[];
  const points = values.slice(9);
  const px = column(points, 3, 0), py = column(points, 3, 1), pz = column(points, 3, 2);
  const width = right! - left!, height = top! - bottom!;
  const length = f.infiniteFar ? one! : end! - near!;
  const depth = three((i) => depthNumerator(f, pz[i]!, near!, end!, one!));
  if (f.parallel) {
    const across = (p: Three, shear: bigint, low: bigint, high: bigint, rest: bigint) =>
      three((i) => (2n * (p[i]! * one! + shear * pz[i]!) - (low + high) * one!) * rest);
    const denominator = one! * width * height * length;
    return { x: across(px, shearX!, left!, right!, height * length),
             y: across(py, shearY!, bottom!, top!, width * length),
             z: three((i) => depth[i]! * width * height), w: three(() => denominator),
             denominator, exponent: 0 };
  }
  const across = (p: Three, low: bigint, high: bigint, rest: bigint) =>
    three((i) => (2n * near! * p[i]! + (low + high) * pz[i]!) * rest);
  const denominator = width * height * length;
  return { x: across(px, left!, right!, height * length),
           y: across(py, bottom!, top!, width * length),
           z: three((i) => depth[i]! * width * height), w: three((i) => -pz[i]! * denominator),
           denominator, exponent };
}

// z_clip times the length of the frustum, all in whole multiples of one power of two, of which the
// numbers given are multiples, too; the result is one of its square. `one` is 1 in them.
function depthNumerator(f: Question['frustum'], z: bigint, near: bigint, far: bigint,
                        one: bigint): bigint {
  if (f.parallel) {
    switch (f.depth) {
      case 'minus_one_to_one': return (-2n * z - far - near) * one;
      case 'zero_to_one': return (-z - near) * one;
      case 'reversed': return (z + far) * one;
    }
  }
  if (f.infiniteFar) {
    switch (f.depth) {
      case 'minus_one_to_one': return (-z - 2n * near) * one;
      case 'zero_to_one': return (-z - near) * one;
      case 'reversed': return near * one;
    }
  }
  switch (f.depth) {
    case 'minus_one_to_one': return -(far + near) * z - 2n * far * near;
    case 'zero_to_one': return -far * z - far * near;
    case 'reversed': return near * z + near * far;
  }
}

interface HalfSpace { distance: Three; isOpen: boolean }

// Inside is distance >= 0. The six planes in the order of kPlanes, then the clip distances.
function halfSpaces({ frustum, volume }: Question, t: ClipTriangle, attributes: Three[]): HalfSpace[] {
  const low = frustum.depth === 'minus_one_to_one' ? sum(t.w, t.z) : t.z;
  const high = difference(t.w, t.z);
  const reversed = frustum.depth === 'reversed';
  const open = volume.openSides;
  const planes: Record<(typeof kPlanes)[number], HalfSpace> = {
    left: { distance: sum(t.w, t.x), isOpen: open.left },
    right: { distance: difference(t.w, t.x), isOpen: open.right },
    bottom: { distance: sum(t.w, t.y), isOpen: open.bottom },
    top: { distance: difference(t.w, t.y), isOpen: open.top },
    near: { distance: reversed ? high : low, isOpen: false },
    far: { distance: reversed ? low : high, isOpen: false },
  };
  const isThere = (name: string) =>
    !(name === 'near' && volume.clampNear) && !(name === 'far' && volume.clampFar);
  return [...kPlanes.filter(isThere).map((name) => planes[name]),
          ...attributes.slice(0, volume.clipDistances).map((distance) =>
            ({ distance, isOpen: false }))];
}

// The part of the polygon where the distance is at least 0; nothing if that has no area.
function cut(polygon: readonly Three[], distance: Three): Three[] {
  const d = polygon.map((point) => at(point, distance));
  const part: Three[] = [];
  polygon.forEach((point, i) => {
    const next = (i + 1) % polygon.length;
    if (d[i]! >= 0n) part.push(point);
    if (d[i]! * d[next]! >= 0n) return;
    const [a, b] = d[i]! > 0n ? [i, next] : [next, i]; // from inside, so that weights are positive
    part.push(shortened(three((k) => d[a]! * polygon[b]![k]! - d[b]! * polygon[a]![k]!)));
  });
  return part.length < 3 ? [] : part;
}

function isFinite({ frustum: f, space, triangle }: Question): boolean {
  const numbers = triangle.flatMap((v) =>
    [...v.position.slice(0, space === 'view' ? 3 : 4), ...v.attributes]);
  const bounds = [f.left, f.right, f.bottom, f.top, f.near, f.infiniteFar ? 0 : f.far, f.shearX,
                  f.shearY];
  return (space === 'clip' ? numbers : [...numbers, ...bounds]).every(Number.isFinite);
}

// The question in the numbers that a clipper gets.
function roundedQuestion(scalar: Scalar, question: Question): Question {
  const r = (x: number) => rounded(scalar, x);
  const f = question.frustum;
  return {
    ...question,
    frustum: { ...f, left: r(f.left), right: r(f.right), bottom: r(f.bottom), top: r(f.top),
               near: r(f.near), far: r(f.far), shearX: r(f.shearX), shearY: r(f.shearY) },
    triangle: question.triangle.map((v) => ({
      position: v.position.map(r), attributes: v.attributes.map(r),
    })) as Question['triangle'],
  };
}

// The exact answer to the question in the numbers that a clipper of this scalar gets: its vertices
// in order, [] where nothing is inside. null: there is none, since a number is not finite or the
// frustum encloses no volume.
export function exactPolygon(question: Question, scalar: Scalar): ExactVertex[] | null {
  const asked = roundedQuestion(scalar, question);
  if (!isFinite(asked) || (asked.space === 'view' && !isInvertible(asked.frustum))) return null;
  const t = asked.space === 'clip' ? clipTriangleOfClip(asked.triangle) : clipTriangleOfView(asked);
  const perVertex = asked.triangle[0].attributes.length;
  const given = overOnePower(asked.triangle.flatMap((v) => v.attributes));
  const attributes = Array.from({ length: perVertex }, (_, k) => column(given.values, perVertex, k));

  const planes = halfSpaces(asked, t, attributes);
  let polygon: Three[] = [[1n, 0n, 0n], [0n, 1n, 0n], [0n, 0n, 1n]];
  for (const { distance } of planes) polygon = cut(polygon, distance);
  // A half-open volume has a point of the closed part only if none of its open sides has it all.
  const isOwned = planes.every(({ distance, isOpen }) =>
    !isOpen || polygon.some((point) => at(point, distance) > 0n));
  const inFront = isOwned ? polygon.filter((point) => at(point, t.w) > 0n) : [];
  if (inFront.length < 3) return [];
  return inFront.map((point) => {
    const w = at(point, t.w), total = point[0] + point[1] + point[2];
    return {
      position: [quotient(at(point, t.x), w), quotient(at(point, t.y), w),
                 quotient(at(point, t.z), w),
                 quotient(total * t.denominator, w, -t.exponent)],
      attributes: attributes.map((a) => quotient(at(point, a), total, given.exponent)),
    };
  });
}
