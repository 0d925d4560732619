// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text from which the same bits are read again: decimals where they are short, else hex
// floats as C's %a writes them.

const kShort = 8; // characters

// Such as -0x1.8p-2; subnormal numbers have a leading 1, too.
export function hexFloat(x: number): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? 'nan' : x < 0 ? '-inf' : 'inf';
  const sign = x < 0 || Object.is(x, -0) ? '-' : '';
  if (x === 0) return `${sign}0x0p+0`;
  // 2^54 brings a subnormal number to a normal one without rounding.
  const isSubnormal = Math.abs(x) < 2 ** -1022;
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, isSubnormal ? x * 2 ** 54 : x);
  const exponent = ((bits.getUint16(0) >> 4) & 0x7ff) - 1023 - (isSubnormal ? 54 : 0);
  const fraction = (bits.getBigUint64(0) & ((1n << 52n) - 1n)).toString(16).padStart(13, '0')
    .replace(/0+$/, '');
  return `${sign}0x1${fraction && '.'}${fraction}p${exponent < 0 ? '' : '+'}${exponent}`;
}

// Either way parseNumber reads the same bits.
export function numberText(x: number): string {
  const decimal = Object.is(x, -0) ? '-0' : String(x);
  return Number.isFinite(x) && decimal.length <= kShort ? decimal : hexFloat(x);
}

const kDecimal = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const kHex = /^([+-]?)0x([0-9a-f]*)(?:\.([0-9a-f]*))?(?:p([+-]?\d+))?$/i;

// The number nearest to a decimal or hex float; null where the text is none. Not finite where the
// number is too large.
export function parseNumber(text: string): number | null {
  const word = text.trim();
  if (kDecimal.test(word)) return Number(word);
  const hex = kHex.exec(word);
  if (hex === null) return null;
  const [, sign, whole = '', fraction = '', power = '0'] = hex;
  if (whole + fraction === '') return null;
  const digits = Number(BigInt(`0x${whole}${fraction}`));
  // In two steps, for a power of two alone may underflow where the number does not.
  const exponent = Math.max(-4000, Math.min(4000, Number(power) - 4 * fraction.length));
  const half = Math.trunc(exponent / 2);
  const size = digits * 2 ** half * 2 ** (exponent - half);
  return sign === '-' ? -size : size;
}
