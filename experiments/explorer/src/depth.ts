// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a depth buffer keeps of the distance from the eye, by convention, and how far apart two
// distances must be to differ there.

import type { Frustum } from './engine';

export type Buffer = 'gl' | 'zero_to_one' | 'reversed' | 'fixed24';
export const kBuffers: readonly { id: Buffer; name: string }[] = [
  { id: 'gl', name: 'OpenGL [−1, 1], float' },
  { id: 'zero_to_one', name: '[0, 1], float' },
  { id: 'reversed', name: 'reversed [1, 0], float' },
  { id: 'fixed24', name: '[0, 1], 24 bits fixed' },
];

// The distance of neighbouring floats around x.
export function floatSpacing(x: number): number {
  const size = Math.abs(x);
  return size < 2 ** -126 ? 2 ** -149 : 2 ** (Math.floor(Math.log2(size)) - 23);
}

// 0 at the near plane, 1 at the far one.
function unitDepth(f: Frustum, distance: number): number {
  if (f.parallel) return (distance - f.near) / (f.far - f.near);
  if (f.infiniteFar) return 1 - f.near / distance;
  return f.far / (f.far - f.near) * (1 - f.near / distance);
}

// The same from the far plane, where 1 - unitDepth would lose all digits.
function reversedDepth(f: Frustum, distance: number): number {
  if (f.parallel) return (f.far - distance) / (f.far - f.near);
  if (f.infiniteFar) return f.near / distance;
  return f.near / distance * ((f.far - distance) / (f.far - f.near));
}

// d unitDepth / d distance.
function slope(f: Frustum, distance: number): number {
  if (f.parallel) return 1 / (f.far - f.near);
  const ratio = f.infiniteFar ? 1 : f.far / (f.far - f.near);
  return ratio * f.near / (distance * distance);
}

// In the volume's own range: OpenGL's from -1 to 1.
export function depthOf(f: Frustum, buffer: Buffer, distance: number): number {
  switch (buffer) {
    case 'gl': return unitDepth(f, distance) - reversedDepth(f, distance);
    case 'zero_to_one': case 'fixed24': return unitDepth(f, distance);
    case 'reversed': return reversedDepth(f, distance);
  }
}

// The difference of distances that is one step of the buffer. OpenGL's float depth is rounded
// twice: in [-1, 1], and where that is brought to [0, 1].
export function resolutionOf(f: Frustum, buffer: Buffer, distance: number): number {
  const depth = depthOf(f, buffer, distance);
  const step = {
    gl: () => Math.max(floatSpacing(depth) / 2, floatSpacing((depth + 1) / 2)),
    zero_to_one: () => floatSpacing(depth),
    reversed: () => floatSpacing(depth),
    fixed24: () => 1 / (2 ** 24 - 1),
  }[buffer]();
  return step / slope(f, distance);
}

// The distances that the plots show: of an infinite view so much that the rest is beyond all use.
export function distanceRange(f: Frustum): [number, number] {
  return [f.near, f.infiniteFar ? f.near * 10000 : f.far];
}
