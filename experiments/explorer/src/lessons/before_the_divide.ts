// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first six lessons: from dropping triangles to the order of the planes.

import { kPlanes } from '../engine';
import type { Scene } from '../scene';
import { codesOf } from '../outcodes';
import { clipTriangle, viewTriangle } from './lesson';
import type { Lesson } from './lesson';

const kNear = kPlanes.indexOf('near');

const isFirst = ({ state }: Scene, clipper: string) => state.clippers[0] === clipper;

const drop: Lesson = {
  id: 'drop',
  title: 'Drop the triangle',
  text: [
    'The simplest clipper does not cut. It drops a triangle as soon as one corner is outside: that ' +
    'is whole/any_outside, the first clipper here.',
    'The picture then has a hole at its border: the second clipper shows what should be seen. ' +
    'Dropping only what is outside as a whole fills the hole, but lets triangles reach far out of ' +
    'the picture, and behind the eye.'],
  open: { ...viewTriangle([-0.5, -1, -2], [3.5, 0, -2.5], [-0.5, 1.5, -2]),
          clippers: ['whole/any_outside', 'homogeneous/sutherland_hodgman'], selected: 1 },
  task: 'drag B into the volume, until the first clipper draws the triangle.',
  isDone: (scene) => isFirst(scene, 'whole/any_outside') && (scene.answers[0].polygon ?? []).length > 0,
  done: 'The whole triangle appears at once, as it vanished at once: that is the popping of early ' +
        'games.',
};

const kPointFour: [number, number, number, number] = [-1, -1, 0.5, 2];

// A keeps its place on the screen while its w changes.
function isSamePoint({ state, clip }: Scene): boolean {
  const [x, y, , w] = clip[0].position;
  const isNear = (a: number, b: number) => Math.abs(a - b) <= 0.05;
  return state.space === 'clip' && w > 0 && Math.abs(w - kPointFour[3]) > 0.4 &&
         isNear(x / w, kPointFour[0] / kPointFour[3]) && isNear(y / w, kPointFour[1] / kPointFour[3]);
}

const four: Lesson = {
  id: 'four_numbers',
  title: 'Four numbers for a point',
  text: [
    'A projection turns x y z into x y z w. The point on the screen is x/w, y/w: all of (1, 1, 0, 2), ' +
    '(2, 2, 0, 4) and (3, 3, 0, 6) are one point, a ray from the origin in four dimensions.',
    'The volume is a pyramid there: −w ≤ x ≤ w, −w ≤ y ≤ w and likewise for z. Each slice shows it ' +
    'as a wedge. Cutting is a matter of adding and comparing; nothing is divided.'],
  open: { ...clipTriangle(kPointFour, [3, -0.5, 0, 2], [0, 3, 1, 3]), instrument: 'outcodes',
          clippers: ['homogeneous/sutherland_hodgman', 'barycentric/correctly_rounded'] },
  task: 'double all four numbers of A (under Numbers), or drag A outward along its ray in both ' +
        'slices, so that it stays where it is on the screen.',
  isDone: isSamePoint,
  done: 'The corner did not move on the screen, but its w did. Only the ratios are the point; the ' +
        'size of w matters for what lies between two points.',
};

const outcodes: Lesson = {
  id: 'outcodes',
  title: 'Three bits are enough',
  text: [
    'The sign of w − x says on which side of the right plane a corner is. One bit for each plane ' +
    'makes an outcode of six bits.',
    'If no corner has a bit, all is inside. If all three have the same bit, nothing is. Most ' +
    'triangles of a scene are settled so, and the others say which planes must cut.'],
  open: { ...viewTriangle([0.5, -1, -2], [4, -0.5, -3], [3.5, 2, -2.5]), instrument: 'outcodes',
          clippers: ['homogeneous/sutherland_hodgman', 'textbook'] },
  task: 'drag A to the right, until all three corners share a bit.',
  isDone: (scene) => codesOf(scene).all !== 0,
  done: 'One bit is common to all: rejected, and no intersection was ever computed.',
};

const divide: Lesson = {
  id: 'after_the_divide',
  title: 'Why not after the divide?',
  text: [
    'After the divide the volume is a plain box, and cutting looks easy. The corners come out right: ' +
    'straight lines stay straight.',
    'But what the corners carry does not. A colour that grows evenly along an edge in space does not ' +
    'grow evenly on the screen, so cvv/naive, the first clipper, gives the new corners wrong ' +
    'attributes: compare its checkerboard with that of the exact answer.'],
  open: { ...viewTriangle([-0.5, -1, -1.5], [14, -1, -8], [-0.5, 3, -3]),
          clippers: ['cvv/naive', 'homogeneous/sutherland_hodgman'], instrument: 'attributes' },
  task: 'choose cvv/perspective as the first clipper. It interpolates a/w and 1/w instead.',
  isDone: (scene) => isFirst(scene, 'cvv/perspective'),
  done: 'The attributes agree again. It costs a division for each new corner, and w must be kept ' +
        'after all.',
};

const behind: Lesson = {
  id: 'behind_the_eye',
  title: 'What w ≤ 0 does',
  text: [
    'Corner C is behind the eye, where w is negative. Dividing by it mirrors the point through the ' +
    'eye: what was below comes out above.',
    'The edge from A to C really runs through infinity on the screen. cvv/naive joins the wrong ' +
    'ends and draws something that is not there. No repair is possible after the divide: whether a ' +
    'point was in front or behind is lost.'],
  open: { ...viewTriangle([-1, -0.5, -3], [1, -0.5, -3], [0.5, -1, 2]),
          clippers: ['cvv/naive', 'homogeneous/sutherland_hodgman'], selected: 2 },
  task: 'drag C forward through w = 0, until all of the triangle is in front of the eye.',
  isDone: ({ clip }) => clip.every(({ position }) => position[3] > 0),
  done: 'As soon as w > 0 everywhere, both clippers see the same polygon. Hence the cut comes ' +
        'before the divide.',
};

const nearFirst: Lesson = {
  id: 'near_first',
  title: 'Why near first is not needed',
  text: [
    'Many books cut by the near plane first, so that no w ≤ 0 is left for the others. Is that ' +
    'needed?',
    'In clip space it is not. A point with w < 0 can’t have both x ≥ −w and x ≤ w: the left and the ' +
    'right plane alone remove all that is behind the eye. Any order gives the same polygon, up to ' +
    'rounding.'],
  open: { ...viewTriangle([-1, -0.5, -3], [1.5, -0.5, -3], [0.5, -1, 2]), instrument: 'steps',
          order: [4, 5, 0, 1, 2, 3], step: 0,
          clippers: ['homogeneous/sutherland_hodgman', 'homogeneous/near_last'] },
  task: 'put the near plane last, then step through all planes and watch w in the table.',
  isDone: ({ state }) => state.order.at(-1) === kNear && state.step === state.order.length,
  done: 'After left and right no w < 0 was left but by rounding, and the near plane found little to ' +
        'do. The order is a matter of speed, not of correctness.',
};

export const kFirstLessons: readonly Lesson[] = [drop, four, outcodes, divide, behind, nearFirst];
