// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the triangle, the polygon of the chosen step and the answers in any plot. What lies behind
// the eye (w < 0) is hatched.

import type { Vec4, Vertex } from '../engine';
import type { Scene } from '../scene';
import { isDrawn, kLayerColours, type Layer } from './layers';
import { cutPolygon, cutSegment, type Painter } from './painter';
import type { Canvas, Placed, Space } from './space';

function between(a: Placed, b: Placed, t: number): Placed {
  const at = a.at.map((value, i) => value + t * (b.at[i]! - value)) as Vec4;
  return { at, w: a.w + t * (b.w - a.w) };
}

// After the divide the points behind the eye have h < 0: the same points with all signs changed.
function positive(points: readonly Placed[]): Vec4[] {
  const isNegative = points.some((p) => p.at[3] < 0);
  return points.map(({ at }) => isNegative ? at.map((value) => -value) as Vec4 : at);
}

const before = (p: Placed) => p.w;
const behind = (p: Placed) => -p.w;

function fill(painter: Painter, polygon: readonly Placed[], colour: string, alpha: number) {
  painter.area(positive(cutPolygon(polygon, before, between)), { colour, alpha });
  painter.area(positive(cutPolygon(polygon, behind, between)),
               { colour, alpha: 2 * alpha, isHatched: true });
}

function strokes(painter: Painter, polygon: readonly Placed[], colour: string, width: number) {
  polygon.forEach((a, i) => {
    const edge = [a, polygon[(i + 1) % polygon.length]!] as const;
    const parts = [[before, []], [behind, [2, 4]]] as const;
    for (const [side, dash] of parts) {
      const part = cutSegment(edge, side, between);
      if (part !== null) painter.line(positive(part), { colour, width, dash: [...dash] });
    }
  });
}

function drawAnswer(space: Space, scene: Scene, { painter, colours }: Canvas, layer: Layer,
                    polygon: readonly Vertex[] | null, width: number, dash: number[]) {
  if (!isDrawn(layer) || polygon === null) return;
  const placed = space.placeAnswer(scene, polygon);
  if (placed === null) return;
  const colour = colours[kLayerColours[layer]];
  const points = placed.map((p) => p.at);
  // Dashes are seen on whatever is below them.
  if (dash.length > 0) painter.outline(points, { colour: colours.paper, width, alpha: 0.75 });
  painter.outline(points, { colour, width, dash });
  for (const point of points) painter.dot(point, width / 2 + 1, { colour });
}

export function drawFigure(space: Space, scene: Scene, canvas: Canvas) {
  const { painter, colours } = canvas;
  const triangle = space.triangle(scene);
  if (triangle !== null && isDrawn('input')) {
    fill(painter, triangle, colours.input, 0.1);
    strokes(painter, triangle, colours.input, 1.6);
  }
  const step = scene.steps[scene.state.step];
  if (step !== undefined && isDrawn('step')) {
    const placed = step.map((v) => space.place(scene, v.position));
    fill(painter, placed, colours.volume, 0.3);
    strokes(painter, placed, colours.volume, 1);
  }
  // Wide below narrow: where answers agree, all their colours are seen.
  const unit = painter.width < 300 ? 1.1 : 1.6;
  drawAnswer(space, scene, canvas, 'first', scene.answers[0].polygon, 3.4 * unit, []);
  drawAnswer(space, scene, canvas, 'second', scene.answers[1].polygon, 2 * unit, []);
  drawAnswer(space, scene, canvas, 'exact', scene.exact, unit, [6, 4]);
}
