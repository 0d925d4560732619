// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/lessons.mjs ANSWERS.wasm: what the lessons say is so, their tasks are open when they
// start and done when they were done; and the figures that panels print.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import test from 'node:test';

import { load } from './bundle.mjs';
import { Engine } from './engine_of.mjs';

const [file] = process.argv.slice(2);
assert.ok(file, 'usage: node tests/lessons.mjs ANSWERS.wasm');

const loaded = await load('lessons/lessons', 'state', 'scene', 'compare', 'checkerboard', 'depth',
                          'digits', 'rational', 'outcodes');
const { lessons_lessons: { kLessons, kLessonSource, lessonOf, openLesson },
        state: { initialState, Store }, scene: { sceneOf },
        compare: { compare, exactOf }, checkerboard: { fieldsOf, largestDifference,
          largestParameterError, wRatio }, depth: { depthOf, floatSpacing, resolutionOf },
        digits: { digitsOf, firstWrong, positional }, rational: { exactly, quotient },
        outcodes: { codesOf } } = loaded;
const engine = await Engine.load(await readFile(file));
globalThis.requestAnimationFrame = (call) => call();

// The scene after the lesson was opened and then changed.
function sceneAfter(id, change = () => ({})) {
  const store = new Store(initialState());
  openLesson(store, kLessons.find((lesson) => lesson.id === id));
  store.update(change(store.state));
  return sceneOf(engine, store.state);
}

const withVertex = (i, position) => ({ triangle }) => ({
  triangle: triangle.map((v, k) => (k === i ? { ...v, position } : v)),
});
const withFirst = (name) => ({ clippers }) => ({ clippers: [name, clippers[1]] });

// What the reader is asked to do.
const kSolutions = {
  drop: withVertex(1, [1, 0, -2.5, 0]),
  four_numbers: withVertex(0, [-2, -2, 1, 4]),
  outcodes: withVertex(0, [3, -1, -2, 0]),
  after_the_divide: withFirst('cvv/perspective'),
  behind_the_eye: withVertex(2, [0.5, -1, -2, 0]),
  near_first: () => ({ order: [0, 1, 2, 3, 5, 4], step: 6 }),
  epsilon: withFirst('homogeneous/w_first_0'),
  perspective: withVertex(2, [0, 1, -1.4, 0]),
  watertight: ({ triangle: [a, b, c] }) => ({ triangle: [a, c, b] }),
  correctly_rounded: () => ({ zoom: 24 }),
};

test('there are ten lessons, each with a task that is open at first and can be done', () => {
  assert.deepEqual(kLessons.map(({ id }) => id), Object.keys(kSolutions));
  for (const lesson of kLessons) {
    assert.equal(lesson.isDone(sceneAfter(lesson.id)), false, `${lesson.id} at its start`);
    assert.equal(lesson.isDone(sceneAfter(lesson.id, kSolutions[lesson.id])), true, lesson.id);
    assert.equal(lessonOf(kLessonSource + lesson.id), lesson);
  }
});

const judged = (scene, answer) =>
  compare(scene.answers[answer].polygon, exactOf(scene.state), scene.state.scalar);
const outcomes = (scene) => [judged(scene, 0).outcome, judged(scene, 1).outcome];
const kRight = ['exact', 'faithful', 'subpixel'];

test('drop: the first clipper leaves a hole where the second is right', () => {
  const [first, second] = outcomes(sceneAfter('drop'));
  assert.equal(first, 'missing');
  assert.ok(kRight.includes(second), second);
});

test('outcodes: what shares a bit is rejected by every clipper', () => {
  const scene = sceneAfter('outcodes', kSolutions.outcodes);
  assert.notEqual(codesOf(scene).all, 0);
  for (const { polygon } of scene.answers) assert.equal(polygon.length, 0);
});

test('after the divide: corners are right, attributes are not, and a/w mends them', () => {
  const naive = judged(sceneAfter('after_the_divide'), 0);
  assert.ok(kRight.includes(naive.outcome) && naive.attribute > 0.3, naive.outcome);
  const mended = judged(sceneAfter('after_the_divide', kSolutions.after_the_divide), 0);
  assert.ok(mended.attribute < 1e-5, String(mended.attribute));
});

test('behind the eye: the divide turns the polygon over, and only there', () => {
  assert.equal(outcomes(sceneAfter('behind_the_eye'))[0], 'flipped');
  for (const outcome of outcomes(sceneAfter('behind_the_eye', kSolutions.behind_the_eye))) {
    assert.ok(kRight.includes(outcome), outcome);
  }
});

test('near first: left and right alone leave no w below 0, up to rounding', () => {
  const scene = sceneAfter('near_first', kSolutions.near_first);
  assert.ok(scene.clip.some(({ position }) => position[3] < 0));
  assert.ok(scene.steps[2].length > 0);
  // Where left and right meet, w is 0; it is computed from numbers below 4, by two cuts.
  assert.ok(scene.steps[2].every(({ position }) => position[3] >= -4 * 4 * 2 ** -24));
});

test('epsilon: the w-plane cuts off what ε = 0 keeps', () => {
  assert.equal(outcomes(sceneAfter('epsilon'))[0], 'vertex_count');
  const kept = outcomes(sceneAfter('epsilon', kSolutions.epsilon))[0];
  assert.ok(kRight.includes(kept), kept);
});

test('perspective: the boards are apart by what the ratio says, then hardly', () => {
  const difference = (scene) => largestDifference(fieldsOf(scene.exact, 240));
  const far = sceneAfter('perspective');
  const bound = largestParameterError(wRatio(far.exact));
  assert.ok(difference(far) > 0.8 * bound && difference(far) <= bound * (1 + 1e-6));
  assert.ok(difference(sceneAfter('perspective', kSolutions.perspective)) < 0.05);
  assert.ok(Math.abs(largestParameterError(2) - 0.1716) < 1e-4);
  assert.ok(Math.abs(largestParameterError(1.01) - 0.0025) < 1e-4);
});

// The numbers of a polygon, as a set: which vertex is first does not matter.
const numbersOf = (polygon) =>
  new Set(polygon.map((v) => v.position.concat(v.attributes.slice(2)).join()));

test('watertight: walking round the other way changes the first answer and not the second', () => {
  const [there, back] = [sceneAfter('watertight'), sceneAfter('watertight', kSolutions.watertight)];
  const sets = [there, back].map(({ answers }) => answers.map(({ polygon }) => numbersOf(polygon)));
  assert.notDeepEqual(sets[0][0], sets[1][0]);
  assert.deepEqual(sets[0][1], sets[1][1]);
});

test('correctly rounded: the second answer is the nearest, the first some ulps away', () => {
  const scene = sceneAfter('correctly_rounded');
  assert.equal(outcomes(scene)[1], 'exact');
  assert.ok(judged(scene, 0).ulps > 2);
});

// --- What panels print --------------------------------------------------------------------------

test('digits are cut off, not rounded, and the first wrong one is found', () => {
  const third = quotient(1n, 3n), near = exactly(Math.fround(1 / 3));
  assert.equal(positional(digitsOf(third, 10)).text, '0.3333333333…');
  assert.equal(positional(digitsOf(near, 10)).text, '0.3333333432…');
  assert.equal(firstWrong(digitsOf(near, 10), digitsOf(third, 10)), 7);
  assert.equal(positional(digitsOf(exactly(-2.5), 5)).text, '−2.5000');
  assert.equal(positional(digitsOf(quotient(-2n, 3n * 10n ** 12n), 4)).text, '−6.666…e-13');
  assert.equal(positional(digitsOf(exactly(1234567), 4)).text, '1.234…e6');
  assert.equal(digitsOf(exactly(0), 4), null);
  assert.equal(firstWrong(digitsOf(exactly(0.1), 10), digitsOf(exactly(-0.1), 10)), 0);
  assert.equal(firstWrong(digitsOf(exactly(0.25), 10), digitsOf(exactly(0.25), 10)), null);
});

test('depth is what the projection makes of the distance, in each convention', () => {
  const { frustum } = initialState();
  for (const [buffer, depth] of [['gl', 'minus_one_to_one'], ['zero_to_one', 'zero_to_one'],
                                 ['reversed', 'reversed']]) {
    for (const change of [{}, { parallel: true }, { infiniteFar: true }]) {
      const f = { ...frustum, ...change, depth };
      for (const distance of [1, 1.5, 4, 9.75]) {
        const state = { ...initialState(), frustum: f };
        const at = { position: [0, 0, -distance, 0], attributes: [0, 0, 0, 0] };
        const [clip] = engine.project('double', { ...state, triangle: [at, at, at] });
        const [, , z, w] = clip.position;
        const found = depthOf(f, buffer, distance);
        assert.ok(Math.abs(found - z / w) < 1e-14, `${buffer} ${JSON.stringify(change)} ${distance}`);
      }
    }
  }
});

test('a step of the buffer is one float of it', () => {
  const { frustum } = initialState();
  assert.equal(floatSpacing(1), 2 ** -23);
  assert.equal(floatSpacing(0.75), 2 ** -24);
  assert.equal(floatSpacing(0), 2 ** -149);
  // The slope of n / d is n / d^2: at the distance 2 a step of 2^-25 in the reversed depth 4/9.
  assert.ok(Math.abs(resolutionOf(frustum, 'reversed', 2) - 2 ** -25 * 4 * 0.9) < 1e-15);
  // Far away the reversed buffer tells more apart than the others.
  for (const other of ['gl', 'zero_to_one', 'fixed24']) {
    assert.ok(resolutionOf(frustum, 'reversed', 9) < resolutionOf(frustum, other, 9), other);
  }
});
