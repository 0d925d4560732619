// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/exact.mjs ANSWERS.wasm [COUNT]: exact polygons (src/exact.ts) against
// barycentric/correctly_rounded, over random questions (tests/questions.cpp). The two share no code
// and count in different ways, so each is a test of the other.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import test from 'node:test';

import { load } from './bundle.mjs';
import { Engine, exportsOf, questionOf } from './engine_of.mjs';

const [file, count = '40000'] = process.argv.slice(2);
assert.ok(file, 'usage: node tests/exact.mjs ANSWERS.wasm [COUNT]');

const { exact: { exactPolygon, nearest } } = await load('exact');
const engine = await Engine.load(await readFile(file));
const wasm = await exportsOf(file);
const correctlyRounded = engine.clipper('barycentric/correctly_rounded');

const numbersOf = (vertex) => [...vertex.position, ...vertex.attributes];

// The exact polygon, each number the float nearest to it; nothing where a coordinate is too large
// for a float, as the clipper has it.
function roundedPolygon(polygon) {
  const rounded = polygon.map((v) => numbersOf(v).map((r) => nearest(r, 'float')));
  const isFinite = rounded.every(([x, y, z, inverseW]) =>
    [x, y, z].every(Number.isFinite) && !Number.isNaN(inverseW));
  return isFinite ? rounded : [];
}

// The polygon with another vertex first; -0 and 0 are one number.
function startingAt(polygon, first) {
  return [...polygon.slice(first), ...polygon.slice(0, first)];
}
const isSame = (a, b) => a.length === b.length &&
  a.every((vertex, i) => vertex.every((x, k) => x === b[i][k]));
const isSamePolygon = (a, b) => a.length === b.length && (a.length === 0 ||
  a.some((_, first) => isSame(startingAt(a, first), b)));

test(`every coordinate of ${count} random triangles is the float nearest to the exact one`, () => {
  const byVertices = {}, wrong = [];
  let coordinates = 0;
  for (let number = 0; number < Number(count); ++number) {
    const question = questionOf(wasm, number);
    const exact = exactPolygon(question, 'float');
    if (exact === null) continue;
    const expected = roundedPolygon(exact);
    const answer = engine.clip(correctlyRounded, 'float', question).map(numbersOf);
    byVertices[expected.length] = (byVertices[expected.length] ?? 0) + 1;
    coordinates += expected.length * 8;
    if (!isSamePolygon(expected, answer)) wrong.push({ number, expected, answer });
  }
  console.log(`# ${coordinates} coordinates; triangles by vertices of the answer:`,
              JSON.stringify(byVertices));
  assert.equal(wrong.length, 0, `${wrong.length} differ; the first: ${JSON.stringify(wrong[0])}`);
  // Of triangles, quadrilaterals and all that six planes can make there were enough to say so.
  for (const vertices of [0, 3, 4, 5, 6, 7]) assert.ok(byVertices[vertices] > 20, `${vertices}`);
});
