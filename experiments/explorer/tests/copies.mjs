// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/copies.mjs ANSWERS.wasm CATALOGUE.json CLIPSCOPE COMPILER: what the page copies
// (src/copy.ts) runs, and says what the page says: the command of the program, the hard case, and the
// C++ program.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test, { after } from 'node:test';

import { load, root } from './bundle.mjs';
import { Engine } from './engine_of.mjs';

const [file, cases, program, compiler] = process.argv.slice(2);
assert.ok(compiler, 'usage: node tests/copies.mjs ANSWERS.wasm CATALOGUE.json CLIPSCOPE COMPILER');

const { copy: { corpusCase, cppProgram, explainCommand }, state: { initialState },
        compare: { compare, exactOf }, number_text: { parseNumber } } =
  await load('copy', 'state', 'compare', 'number_text');
const engine = await Engine.load(await readFile(file));
const catalogue = JSON.parse(await readFile(cases, 'utf8'));
const folder = await mkdtemp(join(tmpdir(), 'clipscope-copies-'));
after(() => rm(folder, { recursive: true }));

// Runs it where the program is found. Errors: fails where it does.
function shell(command) {
  const PATH = `${dirname(program)}:${process.env.PATH}`;
  const { status, stdout, stderr } = spawnSync(
    'sh', ['-c', command], { cwd: folder, env: { ...process.env, PATH }, encoding: 'utf8' });
  assert.equal(status, 0, `${command}\n${stderr}`);
  return stdout;
}

const answersIn = (scalar) => engine.clippers.filter((c) => scalar === 'float' || c.double);

// Every case, each with another clipper and scalar; oblique and half-open ones are among them.
const asked = catalogue.map((hardCase, i) => {
  const scalar = i % 3 === 0 ? 'double' : 'float';
  const clippers = answersIn(scalar);
  const state = { ...initialState(), ...hardCase.question, scalar, source: hardCase.name };
  const clipper = clippers[i % clippers.length];
  return { name: hardCase.name, state, clipper, polygon: engine.clip(clipper, scalar, state) };
});

const coordinates = ['x', 'y', 'z', '1/w', 'a0', 'a1', 'a2', 'a3'];

// What the page says of an answer, in the words of `clipscope explain --json`.
function assertSays(said, { name, state, polygon }) {
  const where = `${name} by ${said.clipper} in ${state.scalar}`;
  const found = said.vertices.map((v) => coordinates.map((k) => parseNumber(v[k].hex) ??
    Number(v[k].hex.replace('inf', 'Infinity'))));
  assert.deepEqual(found, polygon.map((v) => [...v.position, ...v.attributes]), where);
  assert.equal(said.outcome, compare(polygon, exactOf(state), state.scalar).outcome, where);
}

test('the command of each hard case runs, and the program says what the page says', () => {
  const outcomes = new Set();
  for (const one of asked) {
    const copied = explainCommand(one.state, one.clipper, one.polygon !== null);
    if (one.polygon === null) {
      assert.match(copied.reason, /does not take this question/);
      continue;
    }
    const said = JSON.parse(shell(`${copied.text} --json`));
    assertSays(said, one);
    outcomes.add(said.outcome);
  }
  for (const outcome of ['exact', 'subpixel', 'vertex_count', 'missing']) {
    assert.ok(outcomes.has(outcome), `${outcome} is not among ${[...outcomes]}`);
  }
});

test('the program reads each hard case as it is copied, and finds the same outcome', async () => {
  const floats = asked.map((one, i) => ({ ...one, name: `c${i}`,
                                          state: { ...one.state, scalar: 'float' } }));
  const texts = floats.map(({ name, state }) => {
    const copied = corpusCase(state);
    return copied.text.replace('case from_the_explorer', `case ${name}`);
  });
  assert.ok(texts.filter((text) => text.includes('\nexpect clipped')).length > 50);
  assert.ok(texts.filter((text) => text.includes('\nexpect accepted')).length > 5);
  await writeFile(join(folder, 'copied.cases'), `${texts.join('\n\n')}\n`);
  // Reading the file checks what is expected of every case in it.
  for (const { name, state } of floats.filter((_, i) => i % 20 === 0)) {
    const clipper = engine.clipper('textbook');
    const polygon = engine.clip(clipper, 'float', state);
    assertSays(JSON.parse(shell('clipscope explain --corpus copied.cases --clipper textbook ' +
                                `--case copied/${name} --json`)), { name, state, polygon });
  }
});

test('what can not be copied is said', () => {
  const start = initialState();
  const textbook = engine.clipper('textbook');
  const withA = (position) => ({ ...start, scalar: 'double', triangle: start.triangle.map((v, i) =>
    (i === 0 ? { ...v, position } : v)) });
  assert.match(corpusCase(withA([0.1, 0, -2, 0])).reason, /x of A is 0\.1, which no float holds/);
  assert.match(explainCommand(withA([NaN, 0, -2, 0]), textbook, true).reason, /not finite/);
  assert.match(cppProgram(withA([Infinity, 0, -2, 0]), textbook, true).reason, /not finite/);
});

const flags = ['-std=c++20', '-ffp-contract=off', '-DGLM_FORCE_XYZW_ONLY', '-I', dirname(dirname(root))];

async function runCpp(name, text) {
  const source = join(folder, `${name}.cpp`), out = join(folder, name);
  await writeFile(source, text);
  const { status, stderr } = spawnSync(compiler, [...flags, source, '-o', out], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  return spawnSync(out, { encoding: 'utf8' }).stdout;
}

const positionsIn = (text) => text.trim().split('\n').filter((line) => line !== '')
  .map((line) => line.split(' ').map((word) => parseNumber(word) ?? Number(word.replace('inf', 'Infinity'))));

// The first case that the clipper answers with a polygon, beginning at another one for each.
function askedOf(clipper, i) {
  const scalar = clipper.double && i % 2 === 0 ? 'double' : 'float';
  for (let k = 0; k < catalogue.length; ++k) {
    const { name, question } = catalogue[(7 * i + k) % catalogue.length];
    const state = { ...initialState(), ...question, scalar };
    const polygon = engine.clip(clipper, scalar, state);
    if (polygon !== null && polygon.length > 0) return { name, state, clipper, polygon };
  }
  return assert.fail(`${clipper.name} answers no case`);
}

test('the C++ programs of all clippers compile, and print what the page shows', async () => {
  const all = engine.clippers.map(askedOf);
  const texts = all.map(({ state, clipper }) => cppProgram(state, clipper, true).text);
  // One for all takes the compiler a twentieth of the time.
  const functions = texts.map((text, i) => text.replace(/^(\/\/|#include).*$/gm, '')
    .replace('int main() {', `void program_${i}() {`));
  const calls = all.map((_, i) => `  program_${i}();\n  std::printf("--\\n");`);
  const printed = await runCpp('all', ['#include <cstdio>', '#include <spaces/clippers.hpp>',
    ...functions, 'int main() {', ...calls, '}', ''].join('\n'));
  const answers = printed.split('--\n');
  all.forEach(({ name, clipper, polygon }, i) => {
    assert.deepEqual(positionsIn(answers[i]), polygon.map((v) => v.position),
                     `${clipper.name} on ${name}`);
  });
  const one = askedOf(engine.clipper('homogeneous/sutherland_hodgman'), 1);
  const alone = await runCpp('alone', `${cppProgram(one.state, one.clipper, true).text}\n`);
  assert.deepEqual(positionsIn(alone), one.polygon.map((v) => v.position));
});
