// SPDX-License-Identifier: GPL-3.0-or-later
//
// x, y and w of clip space in three dimensions: the sides are a pyramid, |x| <= w and |y| <= w, with
// its apex at the origin. w goes where -z does in view space.

import type { Vec4 } from '../engine';
import type { Scene } from '../scene';
import type { State } from '../state';
import { drawAxes, kMarked } from './box';
import { along, finite, inClip, moved, shownBy } from './clip_space';
import { lastPlane } from './layers';
import { OrbitLens, type Vec3 } from './lens';
import type { Canvas, Space } from './space';
import { shownDepth } from './view_space';

// Where all points of view space with a certain w or z are, by name.
function crossSections({ space, frustum: f }: State): [string, number][] {
  if (space === 'clip') return [];
  if (f.parallel) return [['w = 1', 1]];
  return f.infiniteFar ? [['near', f.near]] : [['near', f.near], ['far', f.far]];
}

function drawPyramid(scene: Scene, canvas: Canvas) {
  const { painter, lens, colours } = canvas;
  const [x, y, z] = lens.eye!;
  const w = -z;
  const outside = [w + x, w - x, w + y, w - y].map((d) => d < 0);
  const corner = (i: number, size: number): Vec4 =>
    [(i & 1) !== 0 ? size : -size, (i & 2) !== 0 ? size : -size, -size, 1];
  const square = (size: number): Vec4[] => [0, 1, 3, 2].map((i) => corner(i, size));
  const apex: Vec4 = [0, 0, 0, 1];
  const colour = colours.volume;
  // The pyramid has no end; what is drawn of it has.
  const end = 1.2 * shownDepth(scene);
  const marked = lastPlane(scene.state);
  [[0, 2], [1, 3], [0, 1], [2, 3]].forEach(([a, b], plane) =>
    painter.area([apex, corner(a!, end), corner(b!, end)],
                 { colour, alpha: plane === marked ? kMarked : 0.06 }));
  for (let i = 0; i < 4; ++i) {
    const isSeen = outside[i & 1]! || outside[2 + (i >> 1)]!;
    painter.line([apex, corner(i, end)], { colour, width: isSeen ? 1.4 : 1,
                                           dash: isSeen ? [] : [3, 4] });
  }
  for (const [name, size] of crossSections(scene.state)) {
    painter.outline(square(size), { colour, width: 1.2 });
    painter.text(square(size)[3]!, name,
                 { colour, paper: colours.paper, dx: -5, dy: -7, align: 'right' });
  }
  drawAxes(canvas, [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['w', [0, 0, -1]]]);
  painter.dot(apex, 3, { colour: colours.faint });
}

export const kPyramid: Space = {
  id: 'xyw',
  label: 'clip space, x y w',
  makeLens: () => new OrbitLens({ yaw: 0.8, pitch: 0.3 }),
  ...shownBy(([x, y, , w]) => [x, y, -w, 1]),
  drawVolume: drawPyramid,
  landmarks(scene: Scene) {
    const size = shownDepth(scene);
    const ends = [0, 1, 2, 3].map((i): Vec3 =>
      [(i & 1) !== 0 ? size : -size, (i & 2) !== 0 ? size : -size, -size]);
    return finite([[0, 0, 0], ...ends,
                   ...scene.clip.map(({ position: [x, y, , w] }): Vec3 => [x, y, -w])]);
  },
  move(scene: Scene, held: Vec4, [x, y, z]: Vec3) {
    return moved(scene, [x, y, inClip(scene, held)[2], -z]);
  },
  component(axis: 0 | 1 | 2, state: State) {
    if (axis !== 2) return { index: axis, sign: 1 };
    const { index, sign } = along('w', state);
    return { index, sign: sign === 1 ? -1 : 1 };
  },
};
