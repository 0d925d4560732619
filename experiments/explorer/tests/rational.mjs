// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/rational.mjs: exact numbers (src/rational.ts) against what can be checked by hand, and
// against the rounding of the machine.
import assert from 'node:assert/strict';
import test from 'node:test';

import { load } from './bundle.mjs';

const { rational: { decimal, exactly, nearest, quotient, ulpsFrom } } = await load('rational');
const ratio = (n, d) => quotient(BigInt(n), BigInt(d));

test('a double is taken by its bits', () => {
  assert.deepEqual(exactly(0.75), { n: 3n << 51n, d: 1n << 53n });
  assert.deepEqual(exactly(-0), { n: 0n, d: 1n << 1074n });
  for (const x of [0.1, -1e300, 5e-324, 2 ** -1022, Number.MAX_VALUE, -3]) {
    assert.equal(nearest(exactly(x), 'double'), x);
  }
  assert.throws(() => exactly(NaN), /NaN is no rational/);
});

test('the nearest number is the one that the machine divides to, ties to even', () => {
  for (let n = -40; n <= 40; ++n) {
    for (let d = 1; d <= 40; ++d) {
      assert.equal(nearest(ratio(n, d), 'double'), n / d + 0);
      assert.equal(nearest(ratio(n, d), 'float'), Math.fround(n / d) + 0);
    }
  }
  assert.equal(nearest(ratio(2 ** 24 + 1, 1), 'float'), 2 ** 24);
  assert.equal(nearest(ratio(2 ** 24 + 3, 1), 'float'), 2 ** 24 + 4);
});

test('it is rounded once where subnormal numbers begin, and infinite where none is near', () => {
  assert.equal(nearest(quotient(1n, 1n, -150), 'float'), 0);
  assert.equal(nearest(quotient(3n, 1n, -151), 'float'), 2 ** -149);
  assert.equal(nearest(quotient((1n << 24n) - 1n, 1n, -150), 'float'), 2 ** -126);
  assert.equal(nearest(quotient((1n << 25n) - 1n, 1n, 103), 'float'), Infinity);
  assert.equal(nearest(quotient(-((1n << 26n) - 3n), 1n, 102), 'float'), -((2 - 2 ** -23) * 2 ** 127));
  assert.equal(nearest(quotient(1n, 1n, -1075), 'double'), 0);
  assert.equal(nearest(quotient(3n, 1n, -1076), 'double'), 5e-324);
});

test('decimals are cut off, not rounded', () => {
  assert.equal(decimal(ratio(2, 3), 5), '0.66666');
  assert.equal(decimal(ratio(-2, 3), 3), '-0.666');
  assert.equal(decimal(ratio(1999, 1000), 0), '1');
  assert.equal(decimal(exactly(0.1), 30), '0.100000000000000005551115123125');
  assert.equal(decimal(ratio(-1, 1000), 2), '-0.00');
});

test('ulps are those of the exact value', () => {
  assert.equal(ulpsFrom(1, ratio(1, 1), 'float'), 0);
  assert.equal(ulpsFrom(1 + 2 ** -23, ratio(1, 1), 'float'), 1);
  assert.equal(ulpsFrom(1 - 2 ** -24, ratio(1, 1), 'float'), -0.5);
  assert.equal(ulpsFrom(1, quotient(1n, 1n, -200), 'float'), 2 ** 149);
  assert.equal(ulpsFrom(2 ** -149, ratio(0, 1), 'float'), 1);
  assert.equal(ulpsFrom(1 / 3, ratio(1, 3), 'double'), nearest(ratio(-1, 3), 'double'));
});
