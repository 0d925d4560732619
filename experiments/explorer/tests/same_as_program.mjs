// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/same_as_program.mjs ANSWERS.wasm CLIPSCOPE: what the page gets from its engine
// (src/engine.ts) is what `clipscope clip` prints, bit for bit, so that the page's numbers on their
// way in and out are right, too. Each clipper is asked several random questions in each scalar.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import test from 'node:test';

import { Engine, exportsOf, kAttributes, questionOf } from './engine_of.mjs';

const [file, program] = process.argv.slice(2);
assert.ok(program, 'usage: node tests/same_as_program.mjs ANSWERS.wasm CLIPSCOPE');

const kEach = 4; // so many questions for each clipper in each scalar that it answers
const engine = await Engine.load(await readFile(file));
const wasm = await exportsOf(file);

// The options of `clipscope clip` that ask the same.
function optionsOf({ frustum: f, volume: v, space }, clipper, scalar) {
  const depth = f.depth === 'minus_one_to_one' ? 'gl' : f.depth;
  const open = Object.keys(v.openSides).filter((side) => v.openSides[side]);
  const bounds = [f.left, f.right, f.bottom, f.top, f.near, f.infiniteFar ? 'inf' : f.far].join();
  return ['--clipper', clipper.name, '--scalar', scalar, '--space', space, '--depth', depth,
          '--attributes', kAttributes, '--clip-distances', v.clipDistances, '--hex',
          ...(space === 'view' ? [`--${f.parallel ? 'ortho' : 'frustum'}=${bounds}`] : []),
          ...(v.clampNear ? [`--depth-clamp=${v.clampFar ? 'both' : 'near'}`]
            : v.clampFar ? ['--depth-clamp=far'] : []),
          ...(open.length > 0 ? [`--half-open=${open.join()}`] : [])].map(String);
}

function numberOfHex(text) {
  const match = /^(-?)0x([01])(?:\.([0-9a-f]+))?p([+-]\d+)$/.exec(text);
  if (match === null) return Number(text.replace('inf', 'Infinity'));
  const [, sign, whole, fraction = '', exponent] = match;
  const significand = Number(`0x${whole}${fraction}`) * 2 ** (-4 * fraction.length);
  const half = Math.trunc(exponent / 2);
  const value = significand * 2 ** half * 2 ** (exponent - half);
  return sign === '-' ? -value : value;
}

// The vertices that the program prints; null where it says that the clipper does not take such.
function answerOfProgram(question, clipper, scalar) {
  const numbers = question.triangle.flatMap((v) =>
    [...v.position.slice(0, question.space === 'view' ? 3 : 4), ...v.attributes]);
  const { status, stdout, stderr } = spawnSync(
    program, ['clip', ...optionsOf(question, clipper, scalar)],
    { input: numbers.map((x) => (Object.is(x, -0) ? '-0' : String(x))).join(' '), encoding: 'utf8' });
  if (status === 2 && /does not take|not applicable/.test(stderr)) return null;
  assert.equal(status, 0, stderr);
  return stdout.trimEnd().split('\n').slice(1).map((row) => row.split(',').slice(2).map(numberOfHex));
}

function canBeAsked({ frustum, triangle }) {
  const numbers = triangle.flatMap((v) => [...v.position, ...v.attributes]);
  return frustum.shearX === 0 && frustum.shearY === 0 &&
    numbers.every((x) => Number.isFinite(Math.fround(x)));
}

const answerOfPage = (question, clipper, scalar) => {
  const polygon = engine.clip(clipper, scalar, question);
  return polygon && polygon.map((v) => [...v.position, ...v.attributes]);
};

test('hex floats are read as what they are', () => {
  assert.deepEqual(['0x1.8p+1', '-0x0p+0', '0x1p-1074', '-0x1.fffffffffffffp+1023', 'inf'].map(numberOfHex),
                   [3, -0, 5e-324, -Number.MAX_VALUE, Infinity]);
});

test('the page gets what the program prints, of every clipper and scalar', () => {
  let number = 0, polygons = 0, refused = 0;
  for (const clipper of engine.clippers) {
    for (const scalar of clipper.double ? ['float', 'double'] : ['float']) {
      for (let asked = 0; asked < kEach; ++number) {
        const question = questionOf(wasm, number);
        if (!canBeAsked(question)) continue;
        const polygon = answerOfPage(question, clipper, scalar);
        // Most triangles leave nothing; an eighth of those is enough.
        if (polygon !== null && polygon.length === 0 && number % 8 !== 0) continue;
        ++asked;
        polygons += Number(polygon !== null && polygon.length > 0);
        refused += Number(polygon === null);
        assert.deepEqual(polygon, answerOfProgram(question, clipper, scalar),
                         `question ${number}: ${clipper.name} in ${scalar}, ${JSON.stringify(question)}`);
      }
    }
  }
  assert.ok(polygons > 100, `${polygons} polygons`);
  assert.ok(refused > 0, 'some question is not applicable');
});
