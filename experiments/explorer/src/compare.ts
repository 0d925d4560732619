// SPDX-License-Identifier: GPL-3.0-or-later
//
// A clipper's answer against the exact polygon, in the words of `clipscope explain`
// (experiments/judge): which outcome it is, and by how much its numbers are off.

import type { Scalar, Vertex } from './engine';
import { exactly, exactPolygon, nearest, ulpsFrom } from './exact';
import type { ExactVertex, Rational } from './exact';
import type { State } from './state';

export const kScreen = { width: 3840, height: 2160 };
const kSubpixel = 1 / 256; // px

export type Outcome = 'exact' | 'faithful' | 'subpixel' | 'visible' | 'vertex_count' | 'missing' |
  'extra' | 'flipped' | 'not_finite' | 'not_applicable';

// Vertex i of the answer stands for `exact`.
export interface Pair { answer: number; exact: ExactVertex }

export interface Comparison {
  outcome: Outcome;
  ulps: number;      // of x, y, z and 1/w at most; 0 but for outcomes that compare vertices
  px: number;        // on the screen
  attribute: number; // the largest error of one
  pairs: Pair[];     // none but for outcomes that compare vertices
}

type Point = readonly [number, number]; // px

export function exactNumbers(v: ExactVertex): Rational[] {
  return [...v.position, ...v.attributes];
}
export function numbersOf(v: Vertex): number[] {
  return [...v.position, ...v.attributes];
}

const isEqual = (a: Rational, b: Rational) => a.n * b.d === b.n * a.d;
const coincide = (a: ExactVertex, b: ExactVertex) =>
  [0, 1, 2].every((k) => isEqual(a.position[k]!, b.position[k]!));

// Of vertices that coincide the first, as reference/ has it.
export function withoutRepeats(polygon: readonly ExactVertex[]): ExactVertex[] {
  return polygon.filter((v, i) => !polygon.slice(0, i).some((u) => coincide(u, v)));
}

// The exact polygon of a state in its scalar, computed once for all who ask; less than three
// vertices have no area.
const known = new WeakMap<State, ExactVertex[] | null>();
export function exactOf(state: State): ExactVertex[] | null {
  let polygon = known.get(state);
  if (polygon === undefined) {
    const found = exactPolygon(state, state.scalar);
    polygon = found === null ? null : withoutRepeats(found);
    known.set(state, polygon);
  }
  return polygon;
}

const onScreen = (x: number, y: number): Point => [x * kScreen.width / 2, y * kScreen.height / 2];
const pointOf = ({ position: [x, y] }: Vertex): Point => onScreen(x, y);
const exactPoint = ({ position: [x, y] }: ExactVertex): Point =>
  onScreen(nearest(x, 'double'), nearest(y, 'double'));
const apart = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1]);

// Places of the vertices but those that repeat the one before them.
function distinct(polygon: readonly Vertex[]): number[] {
  const isSame = (a: Vertex, b: Vertex) => [0, 1, 2].every((k) => a.position[k] === b.position[k]);
  const places = polygon.map((_, i) => i).filter((i) =>
    i === 0 || !isSame(polygon[i]!, polygon[i - 1]!));
  const last = places.at(-1);
  if (last !== undefined && last > 0 && isSame(polygon[last]!, polygon[0]!)) places.pop();
  return places;
}

// 1/w may overflow; the others may not.
function isUsable({ position, attributes }: Vertex): boolean {
  const [x, y, z, inverse] = position;
  return [x, y, z, ...attributes].every(Number.isFinite) && !Number.isNaN(inverse);
}

function signedArea(p: readonly Point[]): number {
  return p.reduce((area, a, i) => {
    const b = p[(i + 1) % p.length]!;
    return area + (a[0] * b[1] - a[1] * b[0]) / 2;
  }, 0);
}

// Below one square pixel rounding may turn a sliver over.
function isFlipped(a: readonly Point[], b: readonly Point[]): boolean {
  const [areaA, areaB] = [signedArea(a), signedArea(b)];
  return Math.min(Math.abs(areaA), Math.abs(areaB)) > 1 && (areaA < 0) !== (areaB < 0);
}

// Both are convex and wound alike: the turn that brings the vertices closest together.
function bestTurn(from: readonly Point[], to: readonly Point[]): number {
  const largest = (turn: number) =>
    Math.max(...from.map((p, i) => apart(p, to[(i + turn) % to.length]!)));
  const turns = from.map((_, turn) => largest(turn));
  return turns.indexOf(Math.min(...turns));
}

function ulpsOf(value: number, exact: Rational, scalar: Scalar): number {
  if (Number.isFinite(value)) return Math.abs(ulpsFrom(value, exact, scalar));
  return Number.isFinite(nearest(exact, scalar)) ? Infinity : 0;
}

// value - exact, the nearest double. Pre-condition: the value is finite.
export function errorOf(value: number, exact: Rational): number {
  const v = exactly(value);
  return nearest({ n: v.n * exact.d - exact.n * v.d, d: v.d * exact.d }, 'double');
}

function withErrors(comparison: Comparison, polygon: readonly Vertex[], scalar: Scalar): Comparison {
  const r = { ...comparison };
  for (const { answer, exact } of r.pairs) {
    const v = polygon[answer]!;
    exact.position.forEach((e, k) => {
      r.ulps = Math.max(r.ulps, ulpsOf(v.position[k]!, e, scalar));
    });
    const [dx, dy] = [0, 1].map((k) => errorOf(v.position[k]!, exact.position[k]!));
    r.px = Math.max(r.px, Math.hypot(...onScreen(dx!, dy!)));
    exact.attributes.forEach((e, k) => {
      r.attribute = Math.max(r.attribute, Math.abs(errorOf(v.attributes[k]!, e)));
    });
  }
  r.outcome = r.ulps <= 0.5 ? 'exact' : r.ulps <= 1 ? 'faithful'
    : r.px < kSubpixel ? 'subpixel' : 'visible';
  return r;
}

export function compare(polygon: readonly Vertex[] | null, exact: readonly ExactVertex[],
                        scalar: Scalar): Comparison {
  const only = (outcome: Outcome): Comparison =>
    ({ outcome, ulps: 0, px: 0, attribute: 0, pairs: [] });
  if (polygon === null) return only('not_applicable');
  if (!polygon.every(isUsable)) return only('not_finite');
  const places = distinct(polygon);
  if (places.length < 3) return only(exact.length < 3 ? 'exact' : 'missing');
  if (exact.length < 3) return only('extra');
  const expected = exact.map(exactPoint), found = places.map((i) => pointOf(polygon[i]!));
  if (isFlipped(expected, found)) return only('flipped');
  if (expected.length !== found.length) return only('vertex_count');
  const turn = bestTurn(expected, found);
  const pairs = exact.map((e, i) => ({ answer: places[(i + turn) % places.length]!, exact: e }));
  return withErrors({ ...only('exact'), pairs }, polygon, scalar);
}

// The vertex of the answer that stands for exact vertex `at`: where their numbers of vertices differ,
// the one nearest to it on the screen; null where the answer has none that can be placed.
export function vertexFor(polygon: readonly Vertex[] | null, exact: readonly ExactVertex[],
                          at: number, scalar: Scalar): Vertex | null {
  const paired = compare(polygon, exact, scalar).pairs.find((p) => p.exact === exact[at]);
  if (polygon === null) return null;
  if (paired !== undefined) return polygon[paired.answer]!;
  const distances = polygon.map((v) => apart(pointOf(v), exactPoint(exact[at]!)));
  const least = Math.min(...distances.filter(Number.isFinite));
  return polygon[distances.indexOf(least)] ?? null;
}

const rounded = (x: number) => String(Number(x.toPrecision(3)));

export function meaningOf({ outcome, px }: Comparison, exact: readonly ExactVertex[]): string {
  switch (outcome) {
    case 'exact': return exact.length < 3 ? 'nothing is visible, and nothing was drawn'
      : 'each coordinate is the nearest number that there is';
    case 'faithful': return 'each coordinate is within one ulp';
    case 'subpixel': return px === 0 ? 'some ulps off in depth or 1/w alone, which nobody sees'
      : `up to ${rounded(px)} px off, which nobody sees`;
    case 'visible': return `up to ${rounded(px)} px off`;
    case 'vertex_count': return 'another number of vertices';
    case 'missing': return 'nothing was drawn where something is visible';
    case 'extra': return 'something was drawn where nothing is visible';
    case 'flipped': return 'the winding is reversed';
    case 'not_finite': return 'some number is NaN or infinite';
    case 'not_applicable': return 'the method does not take such input';
  }
}
