// SPDX-License-Identifier: GPL-3.0-or-later
//
// The next numbers of a scalar to both sides of one.

import type { Scalar } from '../engine';

const bits = new DataView(new ArrayBuffer(8));

// The float or double that is `steps` (1 or -1) further from 0. Pre-condition: x is not 0.
function further(x: number, scalar: Scalar, steps: 1 | -1): number {
  if (scalar === 'float') {
    bits.setFloat32(0, x);
    bits.setInt32(0, bits.getInt32(0) + steps);
    return bits.getFloat32(0);
  }
  bits.setFloat64(0, x);
  bits.setBigInt64(0, bits.getBigInt64(0) + BigInt(steps));
  return bits.getFloat64(0);
}

const kLeast: Record<Scalar, number> = { float: 2 ** -149, double: 2 ** -1074 };

// Pre-condition: x is a finite number of the scalar.
export function neighbours(x: number, scalar: Scalar): { below: number; above: number } {
  if (x === 0) return { below: -kLeast[scalar], above: kLeast[scalar] };
  const away = further(x, scalar, 1), toward = further(x, scalar, -1);
  return x > 0 ? { below: toward, above: away } : { below: away, above: toward };
}
