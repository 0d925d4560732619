// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words and numbers as the panels print them.

import { kPlanes } from '../engine';
import type { Depth } from '../engine';
import { short as toDigits } from '../floats';

// As tables have it: numbers that differ a little shall differ there.
export const short = (x: number, digits = 6) => toDigits(x, digits);

export function counted(count: number, one: string, many: string): string {
  return `${count} ${count === 1 ? one : many}`;
}

// "a", "a and b", "a, b and c".
export function listed(words: readonly string[]): string {
  if (words.length < 2) return words[0] ?? '';
  return `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`;
}

export function planeName(plane: number): string {
  return kPlanes[plane] ?? `distance ${plane - kPlanes.length}`;
}

// "the left plane", "the left and near planes", "clip distance 0".
export function planeWords(planes: readonly number[]): string {
  const sides = planes.filter((p) => p < kPlanes.length).map(planeName);
  const distances = planes.filter((p) => p >= kPlanes.length).map((p) => `clip ${planeName(p)}`);
  const side = sides.length > 0 ? [`the ${listed(sides)} plane${sides.length > 1 ? 's' : ''}`] : [];
  return listed([...side, ...distances]);
}

// What is at least 0 inside of the plane in clip space.
export function planeForm(depth: Depth, plane: number): string {
  const near = { minus_one_to_one: 'w + z', zero_to_one: 'z', reversed: 'w − z' };
  const far = { minus_one_to_one: 'w − z', zero_to_one: 'w − z', reversed: 'z' };
  switch (kPlanes[plane]) {
    case 'left': return 'w + x';
    case 'right': return 'w − x';
    case 'bottom': return 'w + y';
    case 'top': return 'w − y';
    case 'near': return near[depth];
    case 'far': return far[depth];
    default: return `a${plane - kPlanes.length}`;
  }
}
