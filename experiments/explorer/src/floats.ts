// SPDX-License-Identifier: GPL-3.0-or-later
//
// Floats as people round them: to decimals that are short enough to read.

import { rounded, type Scalar } from './engine';

// The smallest of 1, 2 and 5 times a power of ten that is not below x (x > 0).
export function niceStep(x: number): number {
  const exponent = Math.floor(Math.log10(x));
  const mantissa = [1, 2, 5, 10].find((m) => Number(`${m}e${exponent}`) >= x * (1 - 1e-9)) ?? 10;
  return Number(`${mantissa}e${exponent}`);
}

// The multiple of a nice step that is nearest, without the digits that a product would add.
export function toStep(x: number, step: number): number {
  const count = Math.round(x / step);
  if (Math.abs(count) > 1e15) return x;
  const [mantissa, exponent] = step.toExponential().split('e');
  return Number(`${count * Number(mantissa)}e${exponent}`) + 0; // + 0: no -0
}

// For reading, not for calculating: so many significant digits, without zeros at the end.
export function short(x: number, digits = 4): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? 'NaN' : x < 0 ? '\u2212\u221e' : '\u221e';
  if (Object.is(x, -0)) return '\u22120';
  return String(Number(x.toPrecision(digits))).replaceAll('-', '\u2212');
}

// The shortest decimal that the scalar rounds to the same number.
export function shortest(scalar: Scalar, x: number): string {
  if (scalar === 'double' || Math.fround(x) !== x) return String(x);
  for (let digits = 1; digits < 9; ++digits) {
    const text = x.toPrecision(digits);
    if (rounded(scalar, Number(text)) === x) return String(Number(text));
  }
  return String(Number(x.toPrecision(9)));
}
