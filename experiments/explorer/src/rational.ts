// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact numbers: rationals of big integers, made from the bits of doubles, and what a person wants
// to know of them: the nearest float, decimal digits, how many ulps a number is away.

import type { Scalar } from './engine';

// n/d with d > 0, not always in lowest terms.
export interface Rational { n: bigint; d: bigint }

// A format of numbers: bits of the significand, and the exponents of the smallest normal number's
// last bit and of the largest number's first bit.
interface Format { precision: number; least: number; most: number }
const kFormats: Record<Scalar, Format> = {
  float: { precision: 24, least: -149, most: 127 },
  double: { precision: 53, least: -1074, most: 1023 },
};

// 2^exponent times a whole number.
export interface Dyadic { significand: bigint; exponent: number }

const bits = new DataView(new ArrayBuffer(8));

// Pre-condition: x is finite.
export function dyadic(x: number): Dyadic {
  if (!Number.isFinite(x)) throw new RangeError(`${x} is no rational; a finite number is expected`);
  bits.setFloat64(0, x);
  const high = bits.getUint32(0);
  const field = (high >>> 20) & 0x7ff;
  const fraction = (BigInt(high & 0xfffff) << 32n) | BigInt(bits.getUint32(4));
  const magnitude = field === 0 ? fraction : fraction | (1n << 52n);
  const significand = high >>> 31 === 0 ? magnitude : -magnitude;
  return { significand, exponent: Math.max(field, 1) - 1075 };
}

// n 2^exponent / d. Pre-condition: d is not 0.
export function quotient(n: bigint, d: bigint, exponent = 0): Rational {
  const up = BigInt(Math.max(exponent, 0)), down = BigInt(Math.max(-exponent, 0));
  const sign = d < 0n ? -1n : 1n;
  return { n: (sign * n) << up, d: (sign * d) << down };
}

// Exactly this number. Pre-condition: x is finite.
export function exactly(x: number): Rational {
  const { significand, exponent } = dyadic(x);
  return quotient(significand, 1n, exponent);
}

export function magnitude(x: bigint): bigint {
  return x < 0n ? -x : x;
}

// Whole numbers over one power of two: value i is values[i] 2^exponent. Pre-condition: all finite.
export function overOnePower(numbers: readonly number[]): { values: bigint[]; exponent: number } {
  const parts = numbers.map(dyadic);
  const exponent = Math.min(...parts.map((p) => (p.significand === 0n ? 0 : p.exponent)));
  const values = parts.map((p) =>
    p.significand === 0n ? 0n : p.significand << BigInt(p.exponent - exponent));
  return { values, exponent };
}

function bitLength(x: bigint): number {
  const hex = magnitude(x).toString(16);
  return 4 * (hex.length - 1) + 32 - Math.clz32(parseInt(hex[0]!, 16));
}

// The exponent of the last bit of the format's numbers around r.
function lastBit({ n, d }: Rational, { precision, least }: Format): number {
  if (n === 0n) return least;
  let first = bitLength(n) - bitLength(d); // 2^(first - 1) < |r| < 2^(first + 1)
  const [a, b] = first >= 0 ? [magnitude(n), d << BigInt(first)] : [magnitude(n) << BigInt(-first), d];
  if (a < b) --first;
  return Math.max(first - precision + 1, least);
}

// The whole number nearest to n/d, ties to even. Pre-condition: n >= 0.
function nearestWhole(n: bigint, d: bigint): bigint {
  const floor = n / d, twice = 2n * (n - floor * d);
  return twice > d || (twice === d && (floor & 1n) === 1n) ? floor + 1n : floor;
}

// significand 2^exponent for a significand of at most 53 bits: exact where it is a double at all.
function scaled(significand: bigint, exponent: number): number {
  const half = Math.trunc(exponent / 2);
  return Number(significand) * 2 ** half * 2 ** (exponent - half);
}

// The number of the scalar nearest to r, ties to even; 0 has no sign.
export function nearest(r: Rational, scalar: Scalar): number {
  const format = kFormats[scalar];
  const exponent = lastBit(r, format);
  const { n, d } = quotient(magnitude(r.n), r.d, -exponent);
  const significand = nearestWhole(n, d);
  const first = exponent + bitLength(significand) - 1;
  const value = first > format.most ? Infinity : scaled(significand, exponent);
  return r.n < 0n ? -value : value;
}

// The decimal expansion up to so many digits after the point, cut off there, never rounded.
export function decimal(r: Rational, digits: number): string {
  const places = BigInt(digits);
  const text = (magnitude(r.n) * 10n ** places / r.d).toString().padStart(digits + 1, '0');
  const whole = text.slice(0, text.length - digits), rest = text.slice(text.length - digits);
  return `${r.n < 0n ? '-' : ''}${whole}${digits > 0 ? '.' : ''}${rest}`;
}

// value - r in units of the last bit that the scalar's numbers have around r. Pre-condition: the
// value is finite.
export function ulpsFrom(value: number, r: Rational, scalar: Scalar): number {
  const v = exactly(value);
  const difference = { n: v.n * r.d - r.n * v.d, d: v.d * r.d };
  return nearest(quotient(difference.n, difference.d, -lastBit(r, kFormats[scalar])), 'double');
}
