// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a plot looks at its points: a lens takes a homogeneous point (x y z h, h >= 0; h = 0 is at
// infinity) to the screen, X / W and Y / W in pixels, and takes pixels back to points.

import type { Vec4 } from '../engine';

export type Vec3 = [number, number, number];
export interface Pixel { x: number; y: number }
export interface Axis { index: 0 | 1 | 2; sign: 1 | -1 }

export interface Lens {
  // X, Y and W of a point are its products with these rows.
  readonly rows: readonly [Vec4, Vec4, Vec4];
  readonly eye: Vec3 | null; // null: seen from infinity
  resize(width: number, height: number): void;
  // The point at a pixel, in the plane parallel to the screen through another point.
  pointAt(pixel: Pixel, through: Vec3): Vec3;
  // The point at a pixel where one coordinate has a value; null where the plane is seen edge on.
  pointOn(pixel: Pixel, axis: number, value: number): Vec3 | null;
  // The point moved away from the viewer by as much as so many pixels are long there.
  deeper(point: Vec3, pixels: number): Vec3;
  // The axes of the plot that lie nearest to the screen's right, up and away.
  axes(): { right: Axis; up: Axis; away: Axis | null };
  pixelSize(point: Vec3): number;
  turn(dx: number, dy: number): void; // by a drag of so many pixels
  zoom(factor: number, at: Pixel): void;
  fit(points: readonly Vec3[]): void; // also forgets turns
}

export function dot(row: Vec4, [x, y, z, h]: Vec4): number {
  return row[0] * x + row[1] * y + row[2] * z + row[3] * h;
}

export function project(lens: Lens, point: Vec4): Pixel & { w: number } {
  const [x, y, w] = lens.rows.map((row) => dot(row, point)) as Vec3;
  return { x: x / w, y: y / w, w };
}

const plus = (a: Vec3, b: Vec3, t: number): Vec3 =>
  [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
const inner = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// A perspective camera that turns around a target.
export class OrbitLens implements Lens {
  rows: [Vec4, Vec4, Vec4] = [[0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1]];
  private width = 1;
  private height = 1;
  private yaw = 0;
  private pitch = 0;
  private distance = 5;
  private target: Vec3 = [0, 0, 0];

  constructor(private readonly start: { yaw: number; pitch: number }) {
    this.yaw = start.yaw;
    this.pitch = start.pitch;
  }

  get eye(): Vec3 {
    return plus(this.target, this.forward, -this.distance);
  }

  resize(width: number, height: number) {
    this.width = width;
    this.height = height;
    this.update();
  }

  pointAt(pixel: Pixel, through: Vec3): Vec3 {
    return plus(this.eye, this.ray(pixel), this.depthOf(through));
  }

  pointOn(pixel: Pixel, axis: number, value: number): Vec3 | null {
    const ray = this.ray(pixel);
    const t = (value - this.eye[axis]!) / ray[axis]!;
    if (!(t > 0) || Math.abs(this.forward[axis]!) < 0.15) return null;
    const point = plus(this.eye, ray, t);
    point[axis] = value;
    return point;
  }

  deeper(point: Vec3, pixels: number): Vec3 {
    return plus(point, this.forward, pixels * this.pixelSize(point));
  }

  axes() {
    const nearest = (v: Vec3, taken: number[]): Axis => {
      const left = ([0, 1, 2] as const).filter((i) => !taken.includes(i));
      const index = left.reduce((a, b) => Math.abs(v[b]!) > Math.abs(v[a]!) ? b : a);
      return { index, sign: v[index]! < 0 ? -1 : 1 };
    };
    const right = nearest(this.right, []);
    const up = nearest(this.up, [right.index]);
    return { right, up, away: nearest(this.forward, [right.index, up.index]) };
  }

  pixelSize(point: Vec3): number {
    return this.depthOf(point) / this.focal;
  }

  turn(dx: number, dy: number) {
    this.yaw -= dx * 0.008;
    this.pitch = Math.max(-1.55, Math.min(1.55, this.pitch + dy * 0.008));
    this.update();
  }

  zoom(factor: number) {
    this.distance = Math.max(1e-12, Math.min(1e12, this.distance / factor));
    this.update();
  }

  fit(points: readonly Vec3[]) {
    ({ yaw: this.yaw, pitch: this.pitch } = this.start);
    const range = (i: number) => points.map((p) => p[i]!);
    const low = [0, 1, 2].map((i) => Math.min(...range(i))) as Vec3;
    const high = [0, 1, 2].map((i) => Math.max(...range(i))) as Vec3;
    this.target = [0, 1, 2].map((i) => (low[i]! + high[i]!) / 2) as Vec3;
    this.distance = 2.5 * Math.max(1e-6, Math.hypot(...plus(high, low, -1)));
    // The image of the points is centred and scaled to the plot; each round comes nearer to that.
    for (let round = 0; round < 12; ++round) this.centre(points);
    this.update();
  }

  private centre(points: readonly Vec3[]) {
    const seen = points.map((p) => plus(p, this.eye, -1)).map((p) => {
      const depth = Math.max(inner(p, this.forward), 1e-3 * this.distance);
      return { x: inner(p, this.right) / depth, y: inner(p, this.up) / depth };
    });
    const extent = (values: number[]) => {
      const low = Math.min(...values), high = Math.max(...values);
      return { middle: (low + high) / 2, half: (high - low) / 2 };
    };
    const x = extent(seen.map((p) => p.x)), y = extent(seen.map((p) => p.y));
    this.target = plus(plus(this.target, this.right, x.middle * this.distance), this.up,
                       y.middle * this.distance);
    const margin = 34; // for labels, in pixels
    const room = (size: number) => Math.max(size / 2 - margin, size / 4) / this.focal;
    this.distance *= Math.max(x.half / room(this.width), y.half / room(this.height), 0.2);
  }

  // Towards a pixel, as long as to be 1 along the view axis.
  private ray(pixel: Pixel): Vec3 {
    const x = (pixel.x - this.width / 2) / this.focal;
    const y = (this.height / 2 - pixel.y) / this.focal;
    return plus(plus(this.forward, this.right, x), this.up, y);
  }

  // Along the view axis; of points beside or behind the viewer that of the target.
  private depthOf(point: Vec3): number {
    const depth = inner(plus(point, this.eye, -1), this.forward);
    return depth > 0.02 * this.distance ? depth : this.distance;
  }

  private get focal(): number {
    return 1.7 * Math.min(this.width, this.height);
  }

  private get forward(): Vec3 {
    const c = Math.cos(this.pitch);
    return [-Math.sin(this.yaw) * c, -Math.sin(this.pitch), -Math.cos(this.yaw) * c];
  }

  private get right(): Vec3 {
    return [Math.cos(this.yaw), 0, -Math.sin(this.yaw)];
  }

  private get up(): Vec3 {
    const s = Math.sin(this.pitch);
    return [-Math.sin(this.yaw) * s, Math.cos(this.pitch), -Math.cos(this.yaw) * s];
  }

  private update() {
    const eye = this.eye;
    const row = (v: Vec3): Vec4 => [...v, -inner(v, eye)];
    const right = row(this.right), up = row(this.up), depth = row(this.forward);
    const screen = (middle: number, own: Vec4, scale: number) =>
      own.map((value, i) => middle * depth[i]! + scale * value) as Vec4;
    this.rows = [screen(this.width / 2, right, this.focal),
                 screen(this.height / 2, up, -this.focal), depth];
  }
}

// Two coordinates, the first to the right and the second upwards; there is no third.
export class PlaneLens implements Lens {
  rows: [Vec4, Vec4, Vec4] = [[0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1]];
  readonly eye = null;
  private width = 1;
  private height = 1;
  private scale = 40; // pixels per unit
  private centre: [number, number] = [0, 0];

  resize(width: number, height: number) {
    this.width = width;
    this.height = height;
    this.update();
  }

  pointAt(pixel: Pixel): Vec3 {
    return [this.centre[0] + (pixel.x - this.width / 2) / this.scale,
            this.centre[1] - (pixel.y - this.height / 2) / this.scale, 0];
  }

  pointOn(): Vec3 | null {
    return null;
  }

  deeper(point: Vec3): Vec3 {
    return point;
  }

  axes() {
    return { right: { index: 0, sign: 1 } as Axis, up: { index: 1, sign: 1 } as Axis, away: null };
  }

  pixelSize(): number {
    return 1 / this.scale;
  }

  turn(dx: number, dy: number) {
    this.centre = [this.centre[0] - dx / this.scale, this.centre[1] + dy / this.scale];
    this.update();
  }

  zoom(factor: number, at: Pixel) {
    const before = this.pointAt(at);
    this.scale = Math.max(1e-12, Math.min(1e12, this.scale * factor));
    const after = this.pointAt(at);
    this.centre = [this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]];
    this.update();
  }

  fit(points: readonly Vec3[]) {
    const range = (i: number) => points.map((p) => p[i]!);
    const low = [0, 1].map((i) => Math.min(...range(i)));
    const high = [0, 1].map((i) => Math.max(...range(i)));
    this.centre = [(low[0]! + high[0]!) / 2, (low[1]! + high[1]!) / 2];
    const room = (size: number) => Math.max(size - 52, size / 2);
    this.scale = Math.min(room(this.width) / Math.max(high[0]! - low[0]!, 1e-9),
                          room(this.height) / Math.max(high[1]! - low[1]!, 1e-9));
    this.update();
  }

  private update() {
    const s = this.scale;
    this.rows = [[s, 0, 0, this.width / 2 - s * this.centre[0]],
                 [0, -s, 0, this.height / 2 + s * this.centre[1]], [0, 0, 0, 1]];
  }
}
