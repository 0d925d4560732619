// SPDX-License-Identifier: GPL-3.0-or-later
//
// Significant decimal digits of exact numbers, and where an approximation first departs from them
// (as experiments/report/decimal has it).

import type { Scalar } from './engine';
import type { Rational } from './exact';

// Enough to tell the scalar's numbers apart.
export const kDigits: Record<Scalar, number> = { float: 10, double: 19 };

// d.ddd 10^exponent, cut off, never rounded.
export interface Digits { isNegative: boolean; digits: string; exponent: number; isAll: boolean }

const magnitude = (x: bigint) => (x < 0n ? -x : x);

// r times 10^power as a quotient.
function shifted({ n, d }: Rational, power: number): Rational {
  const factor = 10n ** BigInt(Math.abs(power));
  return power < 0 ? { n: magnitude(n), d: d * factor } : { n: magnitude(n) * factor, d };
}

// null for 0.
export function digitsOf(r: Rational, count: number): Digits | null {
  if (r.n === 0n) return null;
  let exponent = magnitude(r.n).toString().length - r.d.toString().length;
  const one = shifted(r, -exponent);
  if (one.n < one.d) --exponent;
  const { n, d } = shifted(r, count - 1 - exponent);
  const whole = n / d;
  return { isNegative: r.n < 0n, digits: whole.toString(), exponent, isAll: whole * d === n };
}

// The place of the first digit that differs; null if none does. Another sign or power of ten makes
// the first one wrong.
export function firstWrong(found: Digits | null, exact: Digits | null): number | null {
  if (found === null || exact === null) return found === exact ? null : 0;
  if (found.isNegative !== exact.isNegative || found.exponent !== exact.exponent) return 0;
  const at = [...found.digits].findIndex((digit, i) => digit !== exact.digits[i]);
  return at < 0 ? null : at;
}

// The number as text, and where each of its digits is in it.
export function positional(number: Digits | null): { text: string; places: number[] } {
  if (number === null) return { text: '0', places: [0] };
  const { isNegative, digits, exponent } = number;
  let text = isNegative ? '−' : '';
  const places: number[] = [];
  const put = (digit: string) => {
    places.push(text.length);
    text += digit;
  };
  const isPlain = exponent >= -5 && exponent < digits.length;
  if (isPlain && exponent < 0) text += `0.${'0'.repeat(-exponent - 1)}`;
  const point = isPlain ? exponent : 0; // digits before the point, less one
  [...digits].forEach((digit, i) => {
    put(digit);
    if (i === point && i + 1 < digits.length) text += '.';
  });
  const end = number.isAll ? '' : '…';
  return { text: isPlain ? text + end : `${text}${end}e${exponent}`, places };
}
