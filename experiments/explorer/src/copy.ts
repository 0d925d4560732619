// SPDX-License-Identifier: GPL-3.0-or-later
//
// A state as text for other places: a command of the program, a case of tests/corpus and a C++
// program. The numbers are those that the clippers get, in the state's scalar.

import { exactOf } from './compare';
import { kPlanes, rounded } from './engine';
import type { Clipper, Depth, Question, Scalar, Vertex } from './engine';
import { exactPolygon } from './exact';
import { kDepthNames } from './link';
import { numberText } from './number_text';
import { kLetters } from './state';
import type { State } from './state';

// The text, or why there is none.
export type Copied = { text: string } | { reason: string };

const kCaseName = 'from_the_explorer';
const kSides = ['left', 'right', 'bottom', 'top'] as const;

interface Numbers {
  frustum: [number, number, number, number, number, number]; // far is infinite where it is
  shear: [number, number];
  triangle: { position: number[]; attributes: number[] }[];
}

function numbersOf({ frustum: f, space, triangle }: Question, scalar: Scalar): Numbers {
  const r = (x: number) => rounded(scalar, x);
  const far = f.infiniteFar ? Infinity : r(f.far);
  return {
    frustum: [r(f.left), r(f.right), r(f.bottom), r(f.top), r(f.near), far],
    shear: [r(f.shearX), r(f.shearY)],
    triangle: triangle.map((v: Vertex) => ({
      position: v.position.slice(0, space === 'view' ? 3 : 4).map(r),
      attributes: v.attributes.map(r),
    })),
  };
}

const listOf = (numbers: readonly number[], separator: string) =>
  numbers.map(numberText).join(separator);
const openSides = ({ volume }: Question) => kSides.filter((side) => volume.openSides[side]);

function clampText({ volume }: Question): string | null {
  if (!volume.clampNear && !volume.clampFar) return null;
  return !volume.clampFar ? 'near' : !volume.clampNear ? 'far' : 'both';
}

// Why the question can't be asked elsewhere; null where it can.
function obstacle(state: State, clipper: Clipper, isTaken: boolean): string | null {
  const all = numbersOf(state, state.scalar).triangle.flatMap((v) =>
    [...v.position, ...v.attributes]);
  if (!all.every(Number.isFinite)) {
    return `A number is not finite in ${state.scalar}; the program takes finite numbers only.`;
  }
  if (!isTaken) return `${clipper.name} does not take this question; choose another first clipper.`;
  return null;
}

// --- clipscope explain --------------------------------------------------------------------------

function explainOptions(state: State): string[] {
  const { frustum } = numbersOf(state, state.scalar);
  const options = [`--space ${state.space}`, `--depth ${kDepthNames[state.frustum.depth]}`];
  if (state.space === 'view') {
    options.push(`--${state.frustum.parallel ? 'ortho' : 'frustum'}=${listOf(frustum, ',')}`);
  }
  options.push(`--attributes ${state.triangle[0].attributes.length}`);
  if (state.volume.clipDistances > 0) options.push(`--clip-distances ${state.volume.clipDistances}`);
  const clamp = clampText(state);
  if (clamp !== null) options.push(`--depth-clamp=${clamp}`);
  const open = openSides(state);
  return open.length > 0 ? [...options, `--half-open=${open.join(',')}`] : options;
}

const chosen = (state: State, clipper: Clipper) =>
  `--clipper ${clipper.name} --scalar ${state.scalar}`;

// The clipper is the first one; isTaken: whether it takes the question.
export function explainCommand(state: State, clipper: Clipper, isTaken: boolean): Copied {
  const reason = obstacle(state, clipper, isTaken);
  if (reason !== null) return { reason };
  const isOblique = state.frustum.shearX !== 0 || state.frustum.shearY !== 0;
  // The command line has no oblique projection; a case has.
  if (state.space === 'view' && isOblique) return obliqueCommand(state, clipper);
  const line = numbersOf(state, state.scalar).triangle
    .map((v) => listOf([...v.position, ...v.attributes], ' ')).join('  ');
  return { text: `echo '${line}' |\n  clipscope explain ${explainOptions(state).join(' ')} \\\n    ` +
                 chosen(state, clipper) };
}

function obliqueCommand(state: State, clipper: Clipper): Copied {
  const hardCase = corpusCase(state);
  if ('reason' in hardCase) return hardCase;
  return { text: `cat > explorer.cases <<'END'\n${hardCase.text}\nEND\n` +
                 `clipscope explain --corpus explorer.cases --case explorer/${kCaseName} \\\n  ` +
                 chosen(state, clipper) };
}

// --- A case of the corpus -----------------------------------------------------------------------

// The first number that no float holds, with what it is: cases are made of floats.
function numberOfDouble({ frustum, shear, triangle }: Numbers): string | null {
  const named: [string, number][] = [
    ...frustum.map((x, i): [string, number] => [`${[...kPlanes][i]} plane`, x]),
    ...shear.map((x, i): [string, number] => [`shear in ${'xy'[i]}`, x]),
    ...triangle.flatMap((v, i) => [
      ...v.position.map((x, k): [string, number] => [`${'xyzw'[k]} of ${kLetters[i]}`, x]),
      ...v.attributes.map((x, k): [string, number] => [`attribute ${k} of ${kLetters[i]}`, x])]),
  ];
  const wide = named.find(([, x]) => Number.isFinite(x) && Math.fround(x) !== x);
  return wide === undefined ? null : `The ${wide[0]} is ${numberText(wide[1])}`;
}

function spaceLine(state: State, { frustum, shear }: Numbers): string {
  const depth = kDepthNames[state.frustum.depth];
  if (state.space === 'clip') return `space clip ${depth}`;
  const kind = state.frustum.parallel ? 'parallel' : 'perspective';
  const slant = state.frustum.parallel ? ` ${listOf(shear, ' ')}` : '';
  return `space view ${kind} ${listOf(frustum, ' ')}${slant} ${depth}`;
}

function isInside(state: State, vertex: Vertex): boolean {
  const openSidesToo = { left: false, right: false, bottom: false, top: false };
  const point: Question = { ...state, triangle: [vertex, vertex, vertex],
                            volume: { ...state.volume, openSides: openSidesToo } };
  return exactPolygon(point, state.scalar)?.length === 3;
}

// What comes out in exact arithmetic, where it has an area: what the program says of less is not
// known here, and it says so itself when it reads a case without this line.
function expectedLine(state: State): string[] {
  const polygon = exactOf(state);
  if (polygon === null || polygon.length < 3) return [];
  const isAccepted = state.triangle.every((v) => isInside(state, v));
  return [`expect ${isAccepted ? 'accepted' : 'clipped'} ${polygon.length}`];
}

export function corpusCase(state: State): Copied {
  const numbers = numbersOf(state, state.scalar);
  if (!numbers.triangle.every((v) => [...v.position, ...v.attributes].every(Number.isFinite))) {
    return { reason: 'A number is not finite; a case takes finite numbers only.' };
  }
  const wide = numberOfDouble(numbers);
  if (wide !== null) return { reason: `${wide}, which no float holds; cases are made of floats.` };
  const clamp = clampText(state), open = openSides(state);
  return { text: [
    `case ${kCaseName}`,
    'source the explorer',
    `why ${state.source === '' ? 'found by hand' : `from ${state.source}`}`,
    'primitive triangle',
    spaceLine(state, numbers),
    ...(clamp === null ? [] : [clamp === 'both' ? 'depth_clamp' : `depth_clamp ${clamp}`]),
    ...(state.volume.clipDistances > 0 ? [`clip_distances ${state.volume.clipDistances}`] : []),
    ...(open.length > 0 ? [`half_open ${open.join(' ')}`] : []),
    ...numbers.triangle.map((v) =>
      `vertex ${listOf(v.position, ' ')} | ${listOf(v.attributes, ' ')}`),
    ...expectedLine(state),
  ].join('\n') };
}

// --- C++ ----------------------------------------------------------------------------------------

// -0 without a point would be a whole number, which has no sign where it is 0.
const literal = (x: number) => (Object.is(x, -0) ? '-0.0' : numberText(x));
const literals = (numbers: readonly number[]) => numbers.map(literal).join(', ');

const kDepthRanges: Record<Depth, string> = {
  minus_one_to_one: 'minus_one_to_one', zero_to_one: 'zero_to_one', reversed: 'reversed',
};

// Options of the volume that differ from the plain one, as statements.
function volumeStatements(state: State, volume: string): string[] {
  const { clampNear, clampFar, clipDistances } = state.volume;
  const r: string[] = [];
  if (clampNear || clampFar) r.push(`${volume}.depth_clamp = {${clampNear}, ${clampFar}};`);
  if (clipDistances > 0) r.push(`${volume}.clip_distances = ${clipDistances};`);
  return [...r, ...openSides(state).map((side) => `${volume}.open_sides.${side} = true;`)];
}

function viewStatements(state: State, { frustum, shear }: Numbers): string[] {
  const [left, right, bottom, top, near, far] = frustum.map(literal);
  const infinite = state.frustum.infiniteFar;
  return [
    'Frustum<T> frustum;',
    `frustum.kind = ProjectionKind::${state.frustum.parallel ? 'parallel' : 'perspective'};`,
    `frustum.left = ${left}, frustum.right = ${right};`,
    `frustum.bottom = ${bottom}, frustum.top = ${top};`,
    infinite ? `frustum.near = ${near}, frustum.infinite_far = true;`
      : `frustum.near = ${near}, frustum.far = ${far};`,
    ...(shear.some((x) => x !== 0)
      ? [`frustum.shear_x = ${literal(shear[0])}, frustum.shear_y = ${literal(shear[1])};`] : []),
    `frustum.depth = DepthRange::${kDepthRanges[state.frustum.depth]};`,
    'Projection<T> projection(frustum);',
    ...volumeStatements(state, 'projection.volume'),
  ];
}

function clipStatements(state: State): string[] {
  return ['ClipVolume volume;', `volume.depth = DepthRange::${kDepthRanges[state.frustum.depth]};`,
          ...volumeStatements(state, 'volume')];
}

// A program that clips the triangle and prints the polygon.
export function cppProgram(state: State, clipper: Clipper, isTaken: boolean): Copied {
  const reason = obstacle(state, clipper, isTaken);
  if (reason !== null) return { reason };
  const numbers = numbersOf(state, state.scalar);
  const isView = state.space === 'view';
  const attributes = state.triangle[0].attributes.length;
  const vertices = numbers.triangle.map((v) =>
    `    {{${literals(v.position)}}, {{${literals(v.attributes)}}}},`);
  const statements = [
    `using T = ${state.scalar};`,
    ...(isView ? viewStatements(state, numbers) : clipStatements(state)),
    `const ${isView ? 'View' : 'Clip'}Triangle<T, ${attributes}> triangle = {{`,
    ...vertices.map((line) => line.slice(2)),
    '}};',
    `NdcPolygon<T, ${attributes}> polygon;`,
    `${clipper.type}{}(${isView ? 'projection' : 'volume'}, triangle, polygon);`,
    'for (const auto& v : polygon) {',
    '  std::printf("%a %a %a %a\\n", double(v.position[0]), double(v.position[1]),',
    '              double(v.position[2]), double(v.position[3]));',
    '}',
  ];
  return { text: [
    '// g++ -std=c++20 -ffp-contract=off -DGLM_FORCE_XYZW_ONLY -I CLIPSCOPE triangle.cpp',
    '#include <cstdio>',
    '',
    '#include <spaces/clippers.hpp>',
    '',
    'int main() {',
    '  using namespace clipscope;',
    ...statements.map((line) => `  ${line}`),
    '}',
  ].join('\n') };
}
