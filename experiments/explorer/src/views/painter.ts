// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws homogeneous points, lines and polygons through a lens onto a canvas. Everything is cut at
// the border of the canvas before the divide, so that lines to points at infinity can be drawn and
// no coordinate is too large for the canvas.

import type { Vec4 } from '../engine';
import { dot, type Lens, type Vec3 } from './lens';

export interface Style {
  colour: string;
  width?: number;    // of lines, in pixels
  dash?: number[];
  alpha?: number;
  isHatched?: boolean; // areas
}

type Screen = Vec3; // X Y W

function mix<P extends number[]>(a: P, b: P, t: number): P {
  return a.map((value, i) => value + t * (b[i]! - value)) as P;
}

// What of a convex polygon is where `side` is not below 0.
export function cutPolygon<P>(polygon: readonly P[], side: (p: P) => number,
                              between: (a: P, b: P, t: number) => P): P[] {
  const rest: P[] = [];
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length]!;
    const from = side(a), to = side(b);
    if (from >= 0) rest.push(a);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) rest.push(between(a, b, from / (from - to)));
  });
  return rest;
}

// What of a segment is where `side` is not below 0; null: nothing.
export function cutSegment<P>([a, b]: readonly [P, P], side: (p: P) => number,
                              between: (a: P, b: P, t: number) => P): [P, P] | null {
  const from = side(a), to = side(b);
  if (from < 0 && to < 0) return null;
  const middle = () => between(a, b, from / (from - to));
  return [from < 0 ? middle() : a, to < 0 ? middle() : b];
}

export class Painter {
  width = 0;
  height = 0;
  private lens!: Lens;
  private readonly context: CanvasRenderingContext2D;
  private fontSize = 0;
  private readonly hatches = new Map<string, CanvasPattern>();

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext('2d')!;
  }

  resize(width: number, height: number) {
    // More pixels than two per CSS pixel cost time and are not seen.
    const ratio = Math.min(2, window.devicePixelRatio);
    this.width = width;
    this.height = height;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio); // which forgets the font
    this.fontSize = 0;
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  begin(lens: Lens) {
    this.lens = lens;
    this.context.clearRect(0, 0, this.width, this.height);
    this.context.lineJoin = 'round';
  }

  area(points: readonly Vec4[], style: Style) {
    let polygon = this.screen(points);
    for (const side of this.sides()) polygon = cutPolygon(polygon, side, mix);
    // A polygon through the point where the viewer is has a corner there, which is seen nowhere.
    polygon = polygon.filter((p) => p[2] > 0);
    if (polygon.length < 3) return;
    this.apply(style);
    this.context.beginPath();
    for (const [x, y, w] of polygon) this.context.lineTo(x / w, y / w);
    this.context.fill();
  }

  line(points: readonly Vec4[], style: Style) {
    const screen = this.screen(points);
    this.apply(style);
    this.context.beginPath();
    let end: Screen | null = null;
    screen.slice(1).forEach((to, i) => {
      let part: [Screen, Screen] | null = [screen[i]!, to];
      for (const side of this.sides()) part &&= cutSegment(part, side, mix);
      if (part === null || part.some((p) => !(p[2] > 0))) return;
      const [[x, y, w], last] = part;
      if (part[0] !== end) this.context.moveTo(x / w, y / w);
      this.context.lineTo(last[0] / last[2], last[1] / last[2]);
      end = last;
    });
    this.context.stroke();
  }

  outline(points: readonly Vec4[], style: Style) {
    if (points.length > 1) this.line([...points, points[0]!], style);
  }

  // A dot of so many pixels.
  dot(point: Vec4, radius: number, style: Style) {
    const at = this.pixel(point);
    if (at === null) return;
    this.apply(style);
    this.context.beginPath();
    this.context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
    this.context.fill();
  }

  // Text beside a point, with a border in the colour of the paper so that lines do not cross it.
  text(point: Vec4, text: string, style: Style & { paper: string; dx?: number; dy?: number;
                                                  align?: CanvasTextAlign; size?: number }) {
    const at = this.pixel(point);
    if (at === null) return;
    this.apply(style);
    this.setFont(style.size ?? 12);
    this.context.textAlign = style.align ?? 'left';
    this.context.textBaseline = 'middle';
    // All of the text is on the canvas.
    const width = this.context.measureText(text).width;
    const before = style.align === 'right' ? width : style.align === 'center' ? width / 2 : 0;
    const x = Math.max(before + 3, Math.min(this.width - (width - before) - 3,
                                            at.x + (style.dx ?? 0)));
    const y = Math.max(8, Math.min(this.height - 8, at.y + (style.dy ?? 0)));
    this.context.strokeStyle = style.paper;
    this.context.lineWidth = 3;
    this.context.strokeText(text, x, y);
    this.context.fillText(text, x, y);
  }

  // A font that is set is looked up, even if it is the same one.
  private setFont(size: number) {
    if (this.fontSize === size) return;
    this.fontSize = size;
    this.context.font = `${size}px system-ui, 'DejaVu Sans', sans-serif`;
  }

  private pixel(point: Vec4): { x: number; y: number } | null {
    const [screen] = this.screen([point]);
    if (screen === undefined || this.sides().some((side) => side(screen) < 0)) return null;
    const [x, y, w] = screen;
    return w > 0 ? { x: x / w, y: y / w } : null;
  }

  // X Y W of points, all scaled by one number so that none is out of range; none where one of them
  // is not finite.
  private screen(points: readonly Vec4[]): Screen[] {
    const largest = Math.max(...points.map((p) => Math.max(...p.map(Math.abs))));
    if (!(largest > 0) || largest === Infinity) return [];
    return points.map((p) => p.map((value) => value / largest) as Vec4)
      .map((p) => this.lens.rows.map((row) => dot(row, p)) as Screen);
  }

  // The four sides of the canvas and a margin. That they are all kept means that W >= 0.
  private sides(): ((p: Screen) => number)[] {
    const margin = 40;
    return [(p) => p[0] + margin * p[2], (p) => (this.width + margin) * p[2] - p[0],
            (p) => p[1] + margin * p[2], (p) => (this.height + margin) * p[2] - p[1]];
  }

  private apply(style: Style) {
    const c = this.context;
    c.globalAlpha = style.alpha ?? 1;
    c.strokeStyle = style.colour;
    c.fillStyle = style.isHatched ? this.hatch(style.colour) : style.colour;
    c.lineWidth = style.width ?? 1;
    c.lineCap = style.dash ? 'butt' : 'round';
    c.setLineDash(style.dash ?? []);
  }

  private hatch(colour: string): CanvasPattern {
    const known = this.hatches.get(colour);
    if (known !== undefined) return known;
    const tile = document.createElement('canvas');
    tile.width = tile.height = 7;
    const context = tile.getContext('2d')!;
    context.strokeStyle = colour;
    context.lineWidth = 1;
    context.beginPath();
    for (const x of [-7, 0, 7]) {
      context.moveTo(x - 1, 8);
      context.lineTo(x + 8, -1);
    }
    context.stroke();
    const pattern = context.createPattern(tile, 'repeat')!;
    this.hatches.set(colour, pattern);
    return pattern;
  }
}
