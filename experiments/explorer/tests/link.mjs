// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/link.mjs ANSWERS.wasm: a state is the same after its way through a link
// (src/link.ts), and what is wrong in a link is said.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import test from 'node:test';

import { load } from './bundle.mjs';
import { Engine, exportsOf, questionOf } from './engine_of.mjs';

const [file] = process.argv.slice(2);
assert.ok(file, 'usage: node tests/link.mjs ANSWERS.wasm');

const { link: { linkOf, stateOfLink, LinkError }, state: { initialState, planesThatCut },
        projection: { isInvertible }, number_text: { hexFloat, numberText, parseNumber } } =
  await load('link', 'state', 'projection', 'number_text');
const engine = await Engine.load(await readFile(file));
const wasm = await exportsOf(file);
const names = { clippers: engine.clippers.map((c) => c.name), panels: ['clippers', 'digits'] };

test('a number is read as the bits that were written, whatever they are', () => {
  const bits = new DataView(new ArrayBuffer(8));
  let state = 12345n;
  for (let i = 0; i < 20000; ++i) {
    state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
    bits.setBigUint64(0, i % 16 === 0 ? state & 0x800fffffffffffffn : state ^ (state >> 33n));
    const x = bits.getFloat64(0);
    if (!Number.isFinite(x)) continue;
    assert.ok(Object.is(parseNumber(hexFloat(x)), x), `${x}: ${hexFloat(x)}`);
    assert.ok(Object.is(parseNumber(numberText(x)), x), `${x}: ${numberText(x)}`);
  }
  for (const x of [0, -0, 0.1, 2 ** -1074, 2 ** -1022, Number.MAX_VALUE, -2.5]) {
    assert.ok(Object.is(parseNumber(numberText(x)), x), String(x));
  }
});

test('hex floats are those of C, decimals are kept where they are short', () => {
  assert.equal(hexFloat(-0.375), '-0x1.8p-2');
  assert.equal(hexFloat(1), '0x1p+0');
  assert.equal(hexFloat(0), '0x0p+0');
  assert.equal(numberText(-2.5), '-2.5');
  assert.equal(numberText(1 / 3), '0x1.5555555555555p-2');
});

test('what is no number is not taken for one', () => {
  for (const text of ['', ' ', 'x', '0x', '0xp1', '1e', '--1', '1,5', 'NaN', 'Infinity']) {
    assert.equal(parseNumber(text), null, text);
  }
});

// A state with everything different from the page's first one.
function stateOf(question, number) {
  const order = planesThatCut(question.volume).reverse();
  return {
    ...initialState(), ...question, order, step: number % (order.length + 1),
    scalar: number % 2 === 0 ? 'double' : 'float', selected: number % 3,
    clippers: [names.clippers[number % names.clippers.length], 'textbook'],
    magnified: number % 4 === 0 ? null : number % 4, zoom: number % 50, instrument: 'digits',
    source: `w sign/100 % & = ${number}`,
  };
}

test('a state is the same after its way through a link', () => {
  let compared = 0;
  for (let number = 0; number < 8000; ++number) {
    const question = questionOf(wasm, number);
    const all = question.triangle.flatMap((v) => [...v.position, ...v.attributes]);
    if (!all.every(Number.isFinite) || !isInvertible(question.frustum)) continue;
    if (question.frustum.infiniteFar) question.frustum.far = 10 * question.frustum.near;
    if (question.space === 'view') for (const v of question.triangle) v.position[3] = 0;
    const state = stateOf(question, number);
    assert.deepStrictEqual(stateOfLink(linkOf(state), names), state, linkOf(state));
    ++compared;
  }
  assert.ok(compared > 3000, `${compared} were compared`);
});

test('what a link leaves out is as on the page when it is opened', () => {
  assert.deepStrictEqual(stateOfLink('v1', names), initialState());
  const { triangle, clippers } = stateOfLink('v1&space=clip&a=0,0,0,1&b=1,0,0,1&c=0,1,0,1;7', names);
  assert.deepStrictEqual(triangle[2], { position: [0, 1, 0, 1], attributes: [7, 0, 0, 0] });
  assert.deepStrictEqual(triangle[1].attributes, initialState().triangle[1].attributes);
  assert.deepStrictEqual(clippers, initialState().clippers);
});

const kWrong = {
  'v2': /starts with 'v2'; expected 'v1'/,
  'v1&space': /'space' was given; expected NAME=VALUE/,
  'v1&space=ndc': /space: 'ndc' was given; expected view or clip/,
  'v1&step=1&step=2': /step: it was given twice/,
  'v1&colour=red': /colour: a link has no such part/,
  'v1&a=1,2,3': /b and c are missing; expected a, b and c/,
  'v1&space=clip': /a, b and c are missing/,
  'v1&a=1,2&b=1,2,3&c=1,2,3': /a: 2 numbers were given; expected 3: X,Y,Z/,
  'v1&a=1,2,x&b=1,2,3&c=1,2,3': /a: 'x' was given; expected a finite number/,
  'v1&a=1,2,1e999&b=1,2,3&c=1,2,3': /a: '1e999' was given; expected a finite number/,
  'v1&a=1,2,3;1,2,3,4,5&b=1,2,3&c=1,2,3': /a: 5 attributes were given; expected 4 at most/,
  'v1&frustum=-1,1,-1,1,10,1': /frustum: it encloses no volume/,
  'v1&ortho=-1,1,-1,1,1,inf': /ortho: it encloses no volume/,
  'v1&shear=1,1': /shear: it goes with ortho/,
  'v1&frustum=-1,1,-1,1,1,2&ortho=-1,1,-1,1,1,2': /expected one of them/,
  'v1&depth=d3d': /depth: 'd3d' was given; expected gl, zero_to_one or reversed/,
  'v1&clip-distances=5': /expected a whole number from 0 to 4/,
  'v1&half-open=front': /half-open: 'front' was given/,
  'v1&clippers=textbook': /expected two names/,
  'v1&clippers=textbook,no/such': /there is no clipper 'no\/such'/,
  'v1&order=near,near': /expected each plane once/,
  'v1&order=0': /order: '0' was given; expected planes of left/,
  'v1&show=nothing': /show: 'nothing' was given/,
  'v1&source=%': /expected percent-encoded text/,
};

test('what is wrong in a link is said', () => {
  for (const [fragment, message] of Object.entries(kWrong)) {
    assert.throws(() => stateOfLink(fragment, names),
                  (error) => error instanceof LinkError && message.test(error.message), fragment);
  }
});
