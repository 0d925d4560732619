// SPDX-License-Identifier: GPL-3.0-or-later
//
// The last four lessons: from an epsilon to the correctly rounded vertex.

import { wRatio } from '../checkerboard';
import { viewTriangle } from './lesson';
import type { Lesson } from './lesson';

// The frustum of a view with its near plane 2^-20 from the eye.
const kNearest = 2 ** -20;

const epsilon: Lesson = {
  id: 'epsilon',
  title: 'What an ε in w costs',
  text: [
    'Who fears a division by 0 cuts by w ≥ ε first; 1e-5 is often read. It is harmless as long as ' +
    'nothing that one sees is nearer to the eye than that.',
    'Here the near plane is about 1e-6 in front of the eye, and corner C about 5e-6. The first ' +
    'clipper cuts at w = 1e-5: that is nothing in space, but on the screen a good part of the ' +
    'triangle is missing at its tip.'],
  open: { ...viewTriangle([-3, -3, -3], [3, -3, -3], [0, 0, -5 * kNearest]),
          frustum: { parallel: false, left: -kNearest, right: kNearest, bottom: -kNearest,
                     top: kNearest, near: kNearest, far: 10, infiniteFar: false, shearX: 0,
                     shearY: 0, depth: 'minus_one_to_one' },
          clippers: ['homogeneous/w_first_1e-5', 'barycentric/correctly_rounded'] },
  task: 'choose homogeneous/w_first_0 as the first clipper: the same with ε = 0.',
  isDone: ({ state }) => state.clippers[0] === 'homogeneous/w_first_0',
  done: 'The tip is back, and nothing was divided by 0: the six planes leave w > 0 but in the eye ' +
        'itself. The ε guards against nothing, and has a price.',
};

const perspective: Lesson = {
  id: 'perspective',
  title: 'When perspective correction matters',
  text: [
    'The left board is interpolated as space demands, the middle one straight on the screen. The ' +
    'ratio r of the largest to the smallest w decides how far apart they are: along an edge by at ' +
    'most (√r − 1) / (√r + 1).',
    'For r = 2 that is 17 % of the edge, for r = 1.01 it is 0.25 %. A distant triangle needs no ' +
    'correction.'],
  open: { ...viewTriangle([-1, -1, -1.25], [1, -1, -1.25], [0, 1, -9]), instrument: 'attributes',
          clippers: ['homogeneous/sutherland_hodgman', 'cvv/naive'], selected: 2 },
  task: 'drag C towards the eye, until r is below 1.2.',
  isDone: (scene) => {
    const ratio = wRatio(scene.exact ?? []);
    return ratio !== null && ratio < 1.2;
  },
  done: 'Both boards are alike now: less than 5 % of an edge lies between them. A renderer that ' +
        'knows r may leave the correction out.',
};

const kB: [number, number, number] = [3.1, -0.7, -2.3], kC: [number, number, number] = [0.3, 2.9, -4.7];

const watertight: Lesson = {
  id: 'watertight',
  title: 'Two neighbours, one edge',
  text: [
    'Two triangles of a mesh share an edge, and walk it in opposite directions. If a new corner is ' +
    'computed from the first end to the second, each of them gets other bits: a crack of an ulp, ' +
    'through which the background shines.',
    'textbook, the first clipper, does that. The second computes each corner from the end that is ' +
    'nearer to the plane, whichever comes first.'],
  open: { ...viewTriangle([-2.1, -1.3, -3.9], kB, kC), instrument: 'digits', magnified: 2,
          clippers: ['textbook', 'homogeneous/sutherland_hodgman'] },
  task: 'press “Walk round the other way” and compare the digits of both clippers.',
  isDone: ({ state }) => state.space === 'view' &&
    kB.every((x, k) => state.triangle[2].position[k] === x) &&
    kC.every((x, k) => state.triangle[1].position[k] === x),
  done: 'The last digits of the first answer changed, those of the second did not: it is watertight.',
};

const rounded: Lesson = {
  id: 'correctly_rounded',
  title: 'What a correctly rounded vertex is',
  text: [
    'The exact corner is a fraction that hardly ever is a float. The floats around it form a grid; ' +
    'the best possible answer is the crossing that is nearest.',
    'barycentric/correctly_rounded, the second clipper, always gives that one: each corner is ' +
    'computed from the three original ones, with as many digits as the decision needs. It follows ' +
    'that it depends on nothing else: not on the order of corners, nor on that of planes.'],
  open: { ...viewTriangle([-2.1, -1.3, -3.9], kB, kC), instrument: 'magnifier', magnified: 2,
          clippers: ['view/sutherland_hodgman', 'barycentric/correctly_rounded'] },
  task: 'zoom in to single ulps. Which of the two is in the square?',
  isDone: ({ state }) => state.instrument === 'magnifier' && state.zoom >= 20,
  done: 'The first answer is some crossings away, which nobody sees; the second can’t be bettered.',
};

export const kLastLessons: readonly Lesson[] = [epsilon, perspective, watertight, rounded];
