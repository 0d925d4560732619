// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/same_bits.mjs ANSWERS.wasm ANSWERS_PROGRAM [COUNT]: WebAssembly and the machine answer
// random questions (tests/questions.cpp) alike, bit for bit: all clippers in float and double,
// projections, distances and steps. What differs is printed, question by question.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import test from 'node:test';

import { exportsOf, textAt } from './engine_of.mjs';

const [file, program, count = '100000'] = process.argv.slice(2);
assert.ok(program, 'usage: node tests/same_bits.mjs ANSWERS.wasm ANSWERS_PROGRAM [COUNT]');

const kBlock = 5000;
const kShown = 3; // so many questions that differ are printed
const wasm = await exportsOf(file);
const room = wasm.malloc(8 * kBlock);

function digestsHere(first, size) {
  wasm.clipscope_digests(first, room, size);
  return new BigUint64Array(wasm.memory.buffer.slice(room, room + 8 * size));
}

function digestsOfMachine(first, size) {
  const bytes = execFileSync(program, [String(first), String(size)], { maxBuffer: 16 * kBlock });
  assert.equal(bytes.length, 8 * size);
  return new BigUint64Array(new Uint8Array(bytes).buffer);
}

// The lines of both that differ.
function differences(number) {
  const here = textAt(wasm, wasm.clipscope_answers(number)).trimEnd().split('\n');
  const machine = execFileSync(program, [String(number)], { encoding: 'utf8' }).trimEnd().split('\n');
  const lines = here.flatMap((line, i) =>
    (line === machine[i] ? [] : [`WebAssembly ${line}`, `machine     ${machine[i]}`]));
  return [`question ${number}`, ...here.slice(0, 2), ...lines].join('\n');
}

test(`zero bits differ between WebAssembly and the machine over ${count} triangles`, () => {
  const differing = [], seen = new Set();
  for (let first = 0; first < Number(count); first += kBlock) {
    const size = Math.min(kBlock, Number(count) - first);
    const here = digestsHere(first, size), machine = digestsOfMachine(first, size);
    here.forEach((digest, i) => {
      seen.add(digest);
      if (digest !== machine[i]) differing.push(first + i);
    });
  }
  // The digests tell questions apart, so that those of the machine were really asked.
  assert.equal(seen.size, Number(count));
  assert.equal(differing.length, 0,
               `${differing.length} questions have other answers; the first:\n` +
               differing.slice(0, kShown).map(differences).join('\n'));
});

test('every clipper was asked in both scalars, and all but one answered in both', () => {
  const clippers = JSON.parse(textAt(wasm, wasm.clipscope_clippers()));
  const answered = new Set();
  for (let number = 0; number < 2000; ++number) {
    for (const line of textAt(wasm, wasm.clipscope_answers(number)).split('\n')) {
      const [what, clipper, scalar, vertices] = line.split(' ');
      if (what === 'clip' && Number(vertices) >= 3) answered.add(`${clippers[clipper].name} ${scalar}`);
    }
  }
  const expected = clippers.flatMap(({ name, double }) =>
    [`${name} float`, ...(double ? [`${name} double`] : [])]);
  assert.deepEqual([...answered].sort(), expected.sort());
  assert.deepEqual(clippers.filter((c) => !c.double).map((c) => c.name),
                   ['barycentric/correctly_rounded']);
});
