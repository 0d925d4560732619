// SPDX-License-Identifier: GPL-3.0-or-later
//
// Floats as people write, step and round them: hexadecimal text, neighbours one ulp away, decimals
// that are short enough to read.

import type { Scalar } from './engine';

const kHex = /^([+-]?)0x([0-9a-f]*)\.?([0-9a-f]*)(?:p([+-]?\d+))?$/i;
const kDecimal = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

// The finite number that a text names, decimal or as a hex float (0x1.8p3); null where it names none.
export function numberOf(text: string): number | null {
  const trimmed = text.trim().replace('\u2212', '-');
  if (kDecimal.test(trimmed)) return finite(Number(trimmed));
  const [, sign, whole, fraction, exponent] = kHex.exec(trimmed) ?? [];
  if (whole === undefined || fraction === undefined || whole + fraction === '') return null;
  // Up to 13 digits (52 bits) are read exactly; a double has no more after its first one.
  const digits = (whole + fraction).replace(/^0+(?=.)/, '');
  if (digits.replace(/0+$/, '').length > 14) return null;
  const value = Number('0x' + digits) * 2 ** (Number(exponent ?? 0) - 4 * fraction.length);
  return finite(sign === '-' ? -value : value);
}

function finite(x: number): number | null {
  return Number.isFinite(x) ? x : null;
}

// The next number of the scalar above or below; the largest stays where it is.
export function neighbour(scalar: Scalar, x: number, isUp: boolean): number {
  const bits = new DataView(new ArrayBuffer(8));
  const read = () => scalar === 'float' ? bits.getFloat32(0) : bits.getFloat64(0);
  if (scalar === 'float') bits.setFloat32(0, x);
  else bits.setFloat64(0, x);
  const isAway = read() === 0 || (read() > 0) === isUp; // from zero
  if (scalar === 'float') {
    const start = read() === 0 ? (isUp ? 0 : 0x80000000) : bits.getUint32(0);
    bits.setUint32(0, start + (isAway ? 1 : -1));
  } else {
    const start = read() === 0 ? (isUp ? 0n : 1n << 63n) : bits.getBigUint64(0);
    bits.setBigUint64(0, start + (isAway ? 1n : -1n));
  }
  return Number.isFinite(read()) ? read() : x;
}

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

// For reading, not for calculating: four significant digits.
export function short(x: number): string {
  return String(Number(x.toPrecision(4))).replace('-', '\u2212');
}
