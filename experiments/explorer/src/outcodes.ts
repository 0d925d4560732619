// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outcodes of the triangle: a bit for each plane that cuts.

import type { Scene } from './scene';
import { planesThatCut } from './state';

// Of each vertex, what is common to all three, and what any has.
export interface Codes { each: number[]; all: number; any: number }

export function codesOf(scene: Scene): Codes {
  const mask = planesThatCut(scene.state.volume).reduce((bits, p) => bits | (1 << p), 0);
  const each = scene.distances.map(({ outcode }) => outcode & mask);
  return { each, all: each.reduce((a, b) => a & b), any: each.reduce((a, b) => a | b) };
}
