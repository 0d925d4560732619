// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a lesson is made of, and short ways to write its triangle.

import type { Triangle, Vec4 } from '../engine';
import type { Scene } from '../scene';
import type { State } from '../state';

export interface Lesson {
  id: string;
  title: string;
  text: string[];            // paragraphs
  open: Partial<State>;      // what differs from the page as it is opened
  task: string;              // what the reader is asked to try
  isDone(scene: Scene): boolean;
  done: string;              // what it showed
}

type Point = [number, number, number];

// Attributes (0, 0), (1, 0) and (0, 1), for the checkerboard.
function withBoard(positions: [Vec4, Vec4, Vec4]): Triangle {
  const corners = [[0, 0], [1, 0], [0, 1]] as const;
  return positions.map((position, i) =>
    ({ position, attributes: [...corners[i]!, 0, 0] })) as Triangle;
}

export function viewTriangle(a: Point, b: Point, c: Point): Pick<State, 'space' | 'triangle'> {
  return { space: 'view', triangle: withBoard([[...a, 0], [...b, 0], [...c, 0]]) };
}

export function clipTriangle(a: Vec4, b: Vec4, c: Vec4): Pick<State, 'space' | 'triangle'> {
  return { space: 'clip', triangle: withBoard([a, b, c]) };
}
