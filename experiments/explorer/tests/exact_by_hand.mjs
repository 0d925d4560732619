// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/exact_by_hand.mjs: exact polygons (src/exact.ts) that can be checked with a pencil.
import assert from 'node:assert/strict';
import test from 'node:test';

import { load } from './bundle.mjs';

const { exact: { decimal, exactPolygon } } = await load('exact');

const kFrustum = { parallel: false, left: -1, right: 1, bottom: -1, top: 1, near: 1, far: 10,
                   infiniteFar: false, shearX: 0, shearY: 0, depth: 'minus_one_to_one' };
const kVolume = { clampNear: false, clampFar: false, clipDistances: 0,
                  openSides: { left: false, right: false, bottom: false, top: false } };

function question(space, positions, { frustum = {}, volume = {}, attributes = [[1], [0], [0]] } = {}) {
  return { space, frustum: { ...kFrustum, ...frustum }, volume: { ...kVolume, ...volume },
           triangle: positions.map((p, i) => ({ position: [...p, 0, 0].slice(0, 4),
                                                attributes: attributes[i] })) };
}

// In lowest terms, "2/3".
function fraction({ n, d }) {
  let [a, b] = [n < 0n ? -n : n, d];
  while (b !== 0n) [a, b] = [b, a % b];
  return d === a ? `${n / a}` : `${n / a}/${d / a}`;
}
const positions = (polygon) => polygon.map((v) => v.position.map(fraction).join(' ')).sort();

test('an edge from w = 3 to w = -3 is cut where x = w', () => {
  const polygon = exactPolygon(question('clip', [[-2, 0, 0, 3], [4, 0, 0, -3], [-2, 0.5, 0, 3]]), 'float');
  assert.deepEqual(positions(polygon),
                   ['-2/3 0 0 1/3', '-2/3 1/6 0 1/3', '1 0 0 2', '1 7/12 0 2'].sort());
  // 1 at a, 0 at b and c; the edge from a is cut 5/12 of its length from a.
  assert.deepEqual(polygon.map((v) => fraction(v.attributes[0])).sort(), ['0', '0', '1', '7/12']);
});

test('a vertex beside the eye needs no divide: the near plane cuts both its edges in their middle', () => {
  const polygon = exactPolygon(question('view', [[1, 1, 0], [0, 0, -2], [1, 0, -2]]), 'double');
  assert.deepEqual(positions(polygon),
                   ['1/2 1/2 -1 1', '1 1/2 -1 1', '0 0 1/9 1/2', '1/2 0 1/9 1/2'].sort());
});

test('the depth conventions tell of the same points', () => {
  const at = [[0, 0, -1], [0.5, 0, -2], [0, 1, -10]];
  const depths = (frustum) => exactPolygon(question('view', at, { frustum }), 'float')
    .map((v) => fraction(v.position[2]));
  assert.deepEqual(depths({ depth: 'minus_one_to_one' }), ['-1', '1/9', '1']);
  assert.deepEqual(depths({ depth: 'zero_to_one' }), ['0', '5/9', '1']);
  assert.deepEqual(depths({ depth: 'reversed' }), ['1', '4/9', '0']);
  assert.deepEqual(depths({ depth: 'minus_one_to_one', infiniteFar: true }), ['-1', '0', '4/5']);
  assert.deepEqual(depths({ depth: 'zero_to_one', infiniteFar: true }), ['0', '1/2', '9/10']);
  assert.deepEqual(depths({ depth: 'reversed', infiniteFar: true }), ['1', '1/2', '1/10']);
});

test('a parallel projection shears by z and divides by nothing', () => {
  const at = [[0, 0, -1], [1, 0, -2], [0, 1, -3]];
  const frustum = { parallel: true, left: -4, right: 4, bottom: -2, top: 2, near: 1, far: 5,
                    shearX: 0.5, shearY: -0.25 };
  assert.deepEqual(positions(exactPolygon(question('view', at, { frustum }), 'float')),
                   ['-1/8 1/8 -1 1', '0 1/4 -1/2 1', '-3/8 7/8 0 1'].sort());
});

test('clamped planes do not cut, clip distances do', () => {
  const behind = [[0, 0, -3, 1], [0.5, 0, 0, 1], [0, 0.5, 3, 1]];
  const z = (volume) => exactPolygon(question('clip', behind, { volume }), 'float')
    .map((v) => fraction(v.position[2])).sort();
  assert.deepEqual(z({ clampNear: true, clampFar: true }), ['-3', '0', '3']);
  assert.deepEqual(z({ clampNear: true }), ['-3', '0', '1', '1']);
  const cut = question('clip', [[0, 0, 0, 1], [1, 0, 0, 1], [0, 1, 0, 1]],
                       { volume: { clipDistances: 1 }, attributes: [[1], [-1], [-3]] });
  assert.deepEqual(positions(exactPolygon(cut, 'float')), ['0 0 0 1', '1/2 0 0 1', '0 1/4 0 1'].sort());
});

test('a triangle in an open side is not owned; one that reaches in is', () => {
  const right = { openSides: { ...kVolume.openSides, right: true } };
  const inSide = [[1, 0, 0, 1], [1, 0.5, 0, 1], [1, 0, 0.5, 1]];
  assert.equal(exactPolygon(question('clip', inSide), 'float').length, 3);
  assert.equal(exactPolygon(question('clip', inSide, { volume: right }), 'float').length, 0);
  const across = [[0, 0, 0, 1], [2, 0, 0, 1], [0, 0.5, 0, 1]];
  assert.equal(exactPolygon(question('clip', across, { volume: right }), 'float').length, 4);
});

test('an edge in a plane, seen from outside, is nothing, and so is (0, 0, 0, 0)', () => {
  const touching = [[1, 0, 0, 1], [1, 0.5, 0, 1], [2, 0, 0, 1]];
  assert.deepEqual(exactPolygon(question('clip', touching), 'float'), []);
  const atZero = [[0, 0, 0, 0], [0.5, 0, 0, 1], [0, 0.5, 0, 1]];
  assert.deepEqual(exactPolygon(question('clip', atZero), 'float'), []);
});

test('the numbers are those of the scalar, and there is no answer where one is not finite', () => {
  const third = [[1 / 3, 0, 0, 1], [0, 0, 0, 1], [0, 0.5, 0, 1]];
  const x = (scalar) => decimal(exactPolygon(question('clip', third), scalar)[0].position[0], 12);
  assert.equal(x('float'), '0.333333343267');
  assert.equal(x('double'), '0.333333333333');
  assert.equal(exactPolygon(question('clip', [[NaN, 0, 0, 1], ...third.slice(1)]), 'float'), null);
  assert.equal(exactPolygon(question('clip', [[1e39, 0, 0, 1], ...third.slice(1)]), 'float'), null);
  const inverted = question('view', [[0, 0, -2], [1, 0, -2], [0, 1, -2]], { frustum: { near: 0 } });
  assert.equal(exactPolygon(inverted, 'float'), null);
});
