// SPDX-License-Identifier: GPL-3.0-or-later
//
// From pixels and keys to the numbers of a vertex: where a dragged vertex comes to stand, rounded
// to numbers that are short enough to read at this scale.

import { rounded, type Vec4 } from '../engine';
import { niceStep, toStep } from '../floats';
import { neighbours } from '../panels/neighbours';
import type { Scene } from '../scene';
import type { State } from '../state';
import type { Axis, Lens, Pixel, Vec3 } from './lens';
import { pointOf, type Space } from './space';

const kLargest = 1e30; // of a number; squares of floats go on being finite some way

// A vertex in the hand: what it was when it was taken, and where.
export interface Held {
  vertex: number;
  numbers: Vec4;
  point: Vec3;
  pixel: Pixel;          // of the pointer, at that time
  grab: Pixel;           // from the vertex's pixel to the pointer
  isAlongAxis: boolean;  // moves along the view axis
}

export interface Moved { numbers: Vec4; point: Vec3 }

export function withVertex(state: State, vertex: number, numbers: Vec4): Partial<State> {
  const triangle = [...state.triangle] as State['triangle'];
  triangle[vertex] = { ...triangle[vertex]!, position: numbers };
  return { triangle, selected: vertex };
}

function pointUnder(space: Space, lens: Lens, held: Held, pixel: Pixel): Vec3 {
  if (held.isAlongAxis) return lens.deeper(held.point, held.pixel.y - pixel.y);
  const at = { x: pixel.x - held.grab.x, y: pixel.y - held.grab.y };
  const axis = space.kept;
  if (axis === null) return lens.pointAt(at, held.point);
  const point = lens.pointOn(at, axis, held.point[axis]) ?? lens.pointAt(at, held.point);
  point[axis] = held.point[axis];
  return point;
}

// How much the numbers change when the pointer moves by so many pixels.
function sensitivity(space: Space, scene: Scene, lens: Lens, held: Held, pixel: Pixel,
                     pixels: number): number {
  const at = (dx: number, dy: number) => space.move(
    scene, held.numbers,
    pointUnder(space, lens, held, { x: pixel.x + dx, y: pixel.y + dy }), held.point);
  const here = at(0, 0);
  const changes = [at(pixels, 0), at(0, pixels)].flatMap(
    (there) => here?.map((value, i) => Math.abs(value - (there?.[i] ?? NaN))) ?? []);
  return Math.max(...changes.filter(Number.isFinite));
}

// Numbers that a move has changed become multiples of the step, the others stay to the last bit.
function tidy(numbers: Vec4, before: Vec4, step: number | null): Vec4 | null {
  if (!numbers.every((value) => Math.abs(value) <= kLargest)) return null;
  return numbers.map((value, i) => {
    const old = before[i]!;
    if (Math.abs(value - old) <= 1e-9 * Math.max(Math.abs(old), step ?? 0)) return old;
    return step === null ? value : toStep(value, step);
  }) as Vec4;
}

// Where the vertex stands with the pointer at a pixel; null where it cannot.
export function dragged(space: Space, scene: Scene, lens: Lens, held: Held, pixel: Pixel,
                        isRounded: boolean): Moved | null {
  const point = pointUnder(space, lens, held, pixel);
  const numbers = space.move(scene, held.numbers, point, held.point);
  if (numbers === null) return null;
  const change = isRounded ? sensitivity(space, scene, lens, held, pixel, 1) : 0;
  const tidied = tidy(numbers, held.numbers, change > 0 ? niceStep(change) : null);
  return tidied === null ? null : { numbers: tidied, point };
}

const kKeys: Record<string, { direction: 'right' | 'up' | 'away'; sign: 1 | -1 }> = {
  ArrowRight: { direction: 'right', sign: 1 }, ArrowLeft: { direction: 'right', sign: -1 },
  ArrowUp: { direction: 'up', sign: 1 }, ArrowDown: { direction: 'up', sign: -1 },
  PageUp: { direction: 'away', sign: 1 }, PageDown: { direction: 'away', sign: -1 },
};

function axisOf(lens: Lens, key: string): Axis | null {
  const meaning = kKeys[key];
  const axis = meaning && lens.axes()[meaning.direction];
  return axis ? { index: axis.index, sign: axis.sign === meaning.sign ? 1 : -1 } : null;
}

// One number to its neighbour in the scalar, the one that lies along the key's axis.
function finely(space: Space, state: State, held: Vec4, axis: Axis): Vec4 {
  const { index, sign } = space.component(axis.index, state);
  const numbers: Vec4 = [...held];
  const { below, above } = neighbours(rounded(state.scalar, numbers[index]!), state.scalar);
  const next = axis.sign === sign ? above : below;
  if (Number.isFinite(next)) numbers[index] = next;
  return numbers;
}

// What a key makes of a vertex: undefined where the key moves nothing, null where it cannot move.
export function nudged(space: Space, scene: Scene, lens: Lens, vertex: number, key: string,
                       isFine: boolean): Vec4 | null | undefined {
  const axis = axisOf(lens, key);
  if (axis === null) return undefined;
  const numbers = scene.state.triangle[vertex]!.position;
  if (isFine) return finely(space, scene.state, numbers, axis);
  const point = pointOf(space, scene, vertex);
  if (point === null) return null;
  const step = niceStep(6 * lens.pixelSize(point));
  const to: Vec3 = [...point];
  // The next multiple of the step in this direction.
  const count = axis.sign * to[axis.index]! / step;
  to[axis.index] = toStep(axis.sign * step * Math.floor(count + 1 + 1e-6), step);
  const moved = space.move(scene, numbers, to, point);
  if (moved === null) return null;
  const change = Math.max(...moved.map((value, i) => Math.abs(value - numbers[i]!)));
  return tidy(moved, numbers, change > 0 ? niceStep(change / 100) : null);
}
