// SPDX-License-Identifier: GPL-3.0-or-later
//
// Attributes as a checkerboard on the polygon as the screen shows it: with perspective correction,
// without it, and how far the two are apart.

import { fieldsOf, largestDifference, largestParameterError, wRatio } from '../checkerboard';
import type { Field, Fields } from '../checkerboard';
import type { Vertex } from '../engine';
import type { Panel } from '../panel';
import type { Scene } from '../scene';
import { colours, onColours } from '../views/theme';
import type { ColourName } from '../views/theme';
import { choice, html } from './dom';
import { short } from './text';

const kSize = 240;   // pixels of a picture
const kTexels = 64;  // of the texture, to a side
const kChecks = 8;   // of the board, to a side

type Colour = readonly [number, number, number];
type Shade = (i: number) => number; // of pixel i, packed; 0: nothing is there

// As the browser writes it: rgb(1, 2, 3).
function colourOf(name: ColourName): Colour {
  const [r = 0, g = 0, b = 0] = (colours()[name].match(/[\d.]+/g) ?? []).map(Number);
  return [r, g, b];
}

// As an image holds them, the red first: the first byte is the lowest.
const packed = (r: number, g: number, b: number) => (255 << 24) | (b << 16) | (g << 8) | r;

function paint(canvas: HTMLCanvasElement, shade: Shade) {
  const context = canvas.getContext('2d')!;
  const image = context.createImageData(kSize, kSize);
  const pixels = new Int32Array(image.data.buffer);
  for (let i = 0; i < pixels.length; ++i) pixels[i] = shade(i);
  context.putImageData(image, 0, 0);
}

function board({ u, v }: Field, dark: Colour, light: Colour): Shade {
  const odd = packed(...dark), even = packed(...light);
  return (i) => {
    if (Number.isNaN(u[i]! + v[i]!)) return 0;
    return (Math.floor(u[i]! * kChecks) + Math.floor(v[i]! * kChecks)) % 2 === 0 ? even : odd;
  };
}

function differences({ correct, affine }: Fields, most: number, none: Colour, full: Colour): Shade {
  const scale = most > 0 ? 1 / most : 0;
  return (i) => {
    const d = Math.max(Math.abs(correct.u[i]! - affine.u[i]!),
                       Math.abs(correct.v[i]! - affine.v[i]!));
    if (Number.isNaN(d)) return 0;
    const t = d * scale;
    return packed(none[0] + t * (full[0] - none[0]), none[1] + t * (full[1] - none[1]),
                  none[2] + t * (full[2] - none[2]));
  };
}

function picture(caption: string) {
  const canvas = html('canvas', { width: kSize, height: kSize });
  return { canvas, element: html('figure', { role: 'img', 'aria-label': caption }, canvas,
                                 html('figcaption', {}, caption)) };
}

function sentence(polygon: readonly Vertex[], most: number): string {
  if (polygon.length === 0) return 'There is no polygon to draw.';
  const ratio = wRatio(polygon);
  const apart = `At most ${short(most * kTexels, 3)} texels of ${kTexels} lie between the two.`;
  if (ratio === null) return `${apart} The answer has w ≤ 0 at some vertex.`;
  const error = largestParameterError(ratio);
  return `w_max / w_min = ${short(ratio, 4)}: along an edge the affine parameter is wrong by up to ` +
         `(√r − 1) / (√r + 1) = ${short(error, 3)}. ${apart}`;
}

type Which = 'exact' | 'first' | 'second';

export function polygonOf(scene: Scene, which: Which): Vertex[] {
  if (which === 'exact') return scene.exact ?? [];
  return scene.answers[which === 'first' ? 0 : 1].polygon ?? [];
}

function mount(host: HTMLElement) {
  let which: Which = 'first';
  let shown: Scene | null = null;
  const of = choice<Which>('Polygon of the',
    [['first', 'first answer'], ['second', 'second answer'], ['exact', 'exact answer']], (value) => {
      which = value;
      if (shown !== null) show(shown);
    });
  const correct = picture('perspective-correct'), affine = picture('affine, without correction');
  const difference = picture('difference');
  const text = html('p', { class: 'verdict' });
  const show = (scene: Scene) => {
    shown = scene;
    of.show(which);
    const polygon = polygonOf(scene, which).filter((v) => v.position.every(Number.isFinite));
    const fields = fieldsOf(polygon, kSize);
    const most = largestDifference(fields);
    const dark = colourOf(which), light = colourOf('paper');
    paint(correct.canvas, board(fields.correct, dark, light));
    paint(affine.canvas, board(fields.affine, dark, light));
    paint(difference.canvas, differences(fields, most, light, colourOf('ink')));
    text.textContent = sentence(polygon, most);
  };
  host.append(html('div', { class: 'controls' }, of.element), text,
    html('div', { class: 'pictures' }, correct.element, affine.element, difference.element),
    html('details', {}, html('summary', {}, 'What is drawn'),
      html('p', { class: 'note' },
        `The first two attributes as a board of ${kChecks} × ${kChecks} fields. Attributes are ` +
        'linear in space, not on the screen: there a/w and 1/w are linear, and their quotient is ' +
        'the attribute. The affine picture interpolates the attributes themselves, on the triangles ' +
        'into which the polygon is fanned, as early consoles did.')));
  onColours(() => {
    if (shown !== null) show(shown);
  });
  return show;
}

export const kAttributesPanel: Panel = { id: 'attributes', title: 'Perspective', mount };
