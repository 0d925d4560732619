// SPDX-License-Identifier: GPL-3.0-or-later
//
// A state as the fragment of the page's address, and back: a link shows the same bits to everybody.
//
//   #v1&space=clip&depth=gl&a=-2,0,0,3&b=4,0,0,-3&c=-2,0.5,0,3&clippers=cvv/naive,textbook
//
// `v1` comes first, then NAME=VALUE in any order, each once. What is left out is as on the page when
// it is opened; of a, b and c all are given or none. Names and values are those of the program's
// options where it has such an option. Numbers are decimals or hex floats (-0x1.8p-2); each is read
// as a double, and rounded to float where `scalar` says so. Text is percent-encoded.
//
//   space=view|clip            what the vertices' numbers are
//   frustum=L,R,B,T,N,F        perspective, sides measured on the near plane; F may be inf
//   ortho=L,R,B,T,N,F          parallel projection, in place of frustum
//   shear=X,Y                  oblique parallel projection
//   depth=gl|zero_to_one|reversed
//   depth-clamp=near|far|both
//   clip-distances=N           the first N attributes are clip distances
//   half-open=SIDE,...         of left, right, bottom and top
//   a=, b=, c=X,Y,Z[,W][;A,..] a vertex, W in clip space only, then up to four attributes
//   scalar=float|double
//   clippers=NAME,NAME         the two that are compared
//   order=PLANE,...            of left, right, bottom, top, near, far and clip distances 0, 1, ...;
//                              planes that are left out follow
//   step=N                     how many planes of the order have cut
//   selected=a|b|c             the vertex that keys move
//   magnified=N                the vertex of the first answer under the magnifier
//   zoom=N                     it shows 2^-N of the whole screen
//   show=PANEL                 the panel that is open
//   source=TEXT                what the triangle is
import { kAttributes, kPlanes } from './engine';
import type { Depth, Frustum, Triangle, Vec4, Vertex, Volume } from './engine';
import { numberText, parseNumber } from './number_text';
import { isInvertible } from './projection';
import { initialState, kMostZoom } from './state';
import type { State } from './state';

export class LinkError extends Error {}

// What a link may name.
export interface Names {
  clippers: readonly string[];
  panels: readonly string[];
}

export const kDepthNames: Record<Depth, string> = {
  minus_one_to_one: 'gl', zero_to_one: 'zero_to_one', reversed: 'reversed',
};
const kVersion = 'v1';
const kVertexNames = ['a', 'b', 'c'] as const;
const kSides = ['left', 'right', 'bottom', 'top'] as const;

// --- Writing ------------------------------------------------------------------------------------

const list = (numbers: readonly number[]) => numbers.map(numberText).join(',');

function frustumItems(f: Frustum): string[] {
  const far = f.infiniteFar ? 'inf' : numberText(f.far);
  const items = [`${f.parallel ? 'ortho' : 'frustum'}=` +
                 `${list([f.left, f.right, f.bottom, f.top, f.near])},${far}`];
  if (f.shearX !== 0 || f.shearY !== 0) items.push(`shear=${list([f.shearX, f.shearY])}`);
  return [...items, `depth=${kDepthNames[f.depth]}`];
}

function volumeItems(v: Volume): string[] {
  const items: string[] = [];
  if (v.clampNear || v.clampFar) {
    items.push(`depth-clamp=${!v.clampFar ? 'near' : !v.clampNear ? 'far' : 'both'}`);
  }
  if (v.clipDistances > 0) items.push(`clip-distances=${v.clipDistances}`);
  const open = kSides.filter((side) => v.openSides[side]);
  return open.length > 0 ? [...items, `half-open=${open.join(',')}`] : items;
}

const planeText = (plane: number) => kPlanes[plane] ?? String(plane - kPlanes.length);

function vertexText(space: State['space'], { position, attributes }: Vertex): string {
  return `${list(position.slice(0, space === 'view' ? 3 : 4))};${list(attributes)}`;
}

// The fragment without its '#'.
export function linkOf(s: State): string {
  const items = [
    kVersion, `space=${s.space}`, ...frustumItems(s.frustum), ...volumeItems(s.volume),
    ...s.triangle.map((v, i) => `${kVertexNames[i]}=${vertexText(s.space, v)}`),
    `scalar=${s.scalar}`, `clippers=${s.clippers.join(',')}`,
    `order=${s.order.map(planeText).join(',')}`, `step=${s.step}`,
    `selected=${kVertexNames[s.selected]}`, `show=${s.instrument}`,
  ];
  if (s.magnified !== null) items.push(`magnified=${s.magnified}`);
  if (s.zoom !== 0) items.push(`zoom=${s.zoom}`);
  if (s.source !== '') items.push(`source=${encodeURIComponent(s.source)}`);
  return items.join('&');
}

// --- Reading ------------------------------------------------------------------------------------

const given = (text: string) => `'${text}' was given`;

class Reader {
  private readonly items = new Map<string, string>();

  constructor(fragment: string) {
    const [version, ...items] = fragment.split('&');
    if (version !== kVersion) {
      throw new LinkError(`the link starts with '${version}'; expected '${kVersion}'`);
    }
    for (const item of items) {
      const at = item.indexOf('=');
      if (at < 1) throw new LinkError(`${given(item)}; expected NAME=VALUE`);
      const name = item.slice(0, at);
      if (this.items.has(name)) throw new LinkError(`${name}: it was given twice; expected once`);
      this.items.set(name, this.decoded(name, item.slice(at + 1)));
    }
  }

  take(name: string): string | null {
    const text = this.items.get(name) ?? null;
    this.items.delete(name);
    return text;
  }

  // What nobody took is not part of the format.
  finish() {
    for (const name of this.items.keys()) throw new LinkError(`${name}: a link has no such part`);
  }

  // One of the names; `otherwise` where there is no such part.
  oneOf<T extends string>(name: string, names: readonly T[], otherwise: T): T {
    const text = this.take(name);
    if (text === null) return otherwise;
    const found = names.find((n) => n === text);
    if (found !== undefined) return found;
    throw new LinkError(`${name}: ${given(text)}; expected ${names.slice(0, -1).join(', ')} or ` +
                        names.at(-1));
  }

  count(name: string, most: number): number | null {
    const text = this.take(name);
    if (text === null) return null;
    if (/^\d+$/.test(text) && Number(text) <= most) return Number(text);
    throw new LinkError(`${name}: ${given(text)}; expected a whole number from 0 to ${most}`);
  }

  private decoded(name: string, text: string): string {
    try {
      return decodeURIComponent(text);
    } catch {
      throw new LinkError(`${name}: ${given(text)}; expected percent-encoded text`);
    }
  }
}

function numberOf(name: string, word: string): number {
  const x = parseNumber(word);
  if (x !== null && Number.isFinite(x)) return x;
  throw new LinkError(`${name}: ${given(word)}; expected a finite number such as -0.25 or -0x1p-2`);
}

function numbersOf(name: string, text: string, count: number, what: string): number[] {
  const words = text.split(',');
  if (words.length !== count) {
    throw new LinkError(`${name}: ${words.length} numbers were given; expected ${count}: ${what}`);
  }
  return words.map((word) => numberOf(name, word));
}

function readFrustum(reader: Reader, otherwise: Frustum): Frustum {
  const depth = reader.oneOf('depth', Object.values(kDepthNames), kDepthNames[otherwise.depth]);
  const perspective = reader.take('frustum'), parallel = reader.take('ortho');
  const shear = reader.take('shear');
  if (perspective !== null && parallel !== null) {
    throw new LinkError('frustum and ortho were given; expected one of them');
  }
  if (shear !== null && parallel === null) throw new LinkError('shear: it goes with ortho');
  const r: Frustum = {
    ...otherwise,
    depth: (Object.keys(kDepthNames) as Depth[]).find((d) => kDepthNames[d] === depth)!,
  };
  const text = perspective ?? parallel;
  if (text === null) return r;
  const name = parallel === null ? 'frustum' : 'ortho';
  r.parallel = parallel !== null;
  r.infiniteFar = text.endsWith(',inf');
  [r.left, r.right, r.bottom, r.top, r.near, r.far] =
    numbersOf(name, text.replace(/,inf$/, ',0'), 6, 'L,R,B,T,N,F') as
      [number, number, number, number, number, number];
  [r.shearX, r.shearY] =
    (shear === null ? [0, 0] : numbersOf('shear', shear, 2, 'X,Y')) as [number, number];
  // A link does not say which far plane there was before; the page wants one to go back to.
  if (r.infiniteFar) r.far = 10 * r.near;
  if (isInvertible(r)) return r;
  throw new LinkError(`${name}: it encloses no volume; expected left < right, bottom < top, ` +
                      'near < far, and in perspective 0 < near, else a finite far');
}

function readVolume(reader: Reader): Volume {
  const clamp = reader.oneOf('depth-clamp', ['', 'near', 'far', 'both'], '');
  const open = reader.take('half-open')?.split(',') ?? [];
  for (const side of open) {
    if (kSides.some((s) => s === side)) continue;
    throw new LinkError(`half-open: ${given(side)}; expected some of ${kSides.join(', ')}`);
  }
  const isOpen = (side: string) => open.includes(side);
  return {
    clampNear: clamp === 'near' || clamp === 'both', clampFar: clamp === 'far' || clamp === 'both',
    clipDistances: reader.count('clip-distances', kAttributes) ?? 0,
    openSides: { left: isOpen('left'), right: isOpen('right'), bottom: isOpen('bottom'),
                 top: isOpen('top') },
  };
}

function readVertex(name: string, text: string, space: State['space'], otherwise: Vertex): Vertex {
  const [place, attributes, ...rest] = text.split(';');
  if (rest.length > 0) throw new LinkError(`${name}: ${given(text)}; expected one ';' at most`);
  const isView = space === 'view';
  const position = numbersOf(name, place!, isView ? 3 : 4, isView ? 'X,Y,Z' : 'X,Y,Z,W');
  if (isView) position.push(0);
  const values = attributes === undefined
    ? otherwise.attributes : attributes.split(',').map((word) => numberOf(name, word));
  if (values.length > kAttributes) {
    throw new LinkError(`${name}: ${values.length} attributes were given; expected ` +
                        `${kAttributes} at most`);
  }
  const missing = Array<number>(kAttributes - values.length).fill(0);
  return { position: position as Vec4, attributes: [...values, ...missing] };
}

function readTriangle(reader: Reader, start: State): Pick<State, 'space' | 'triangle'> {
  const space = reader.oneOf('space', ['view', 'clip'], start.space);
  const texts = kVertexNames.map((name) => reader.take(name));
  const missing = kVertexNames.filter((_, i) => texts[i] === null);
  if (missing.length === 3 && space === start.space) return { space, triangle: start.triangle };
  if (missing.length > 0) {
    const names = missing.join(', ').replace(/, (?=.$)/, ' and ');
    throw new LinkError(`${names} ${missing.length > 1 ? 'are' : 'is'} missing; expected a, b and c`);
  }
  const triangle = texts.map((text, i) =>
    readVertex(kVertexNames[i]!, text!, space, start.triangle[i]!)) as Triangle;
  return { space, triangle };
}

function readClippers(reader: Reader, otherwise: [string, string], names: readonly string[]) {
  const text = reader.take('clippers');
  if (text === null) return otherwise;
  const chosen = text.split(',');
  if (chosen.length !== 2) throw new LinkError(`clippers: ${given(text)}; expected two names`);
  for (const name of chosen) {
    if (!names.includes(name)) throw new LinkError(`clippers: there is no clipper '${name}'`);
  }
  return chosen as [string, string];
}

function readOrder(reader: Reader, otherwise: number[], clipDistances: number): number[] {
  const text = reader.take('order');
  if (text === null) return otherwise;
  if (text === '') return [];
  const planes = kPlanes.length + clipDistances;
  const order = text.split(',').map((word) => {
    const plane = Array.from({ length: planes }, (_, p) => p).find((p) => planeText(p) === word);
    if (plane !== undefined) return plane;
    throw new LinkError(`order: ${given(word)}; expected planes of ${kPlanes.join(', ')}` +
                        (clipDistances > 0 ? ` and clip distances below ${clipDistances}` : ''));
  });
  if (new Set(order).size === order.length) return order;
  throw new LinkError(`order: ${given(text)}; expected each plane once`);
}

// The state of a fragment without its '#'. Errors: LinkError.
export function stateOfLink(fragment: string, names: Names): State {
  const start = initialState();
  const reader = new Reader(fragment);
  const volume = readVolume(reader);
  const order = readOrder(reader, start.order, volume.clipDistances);
  const state: State = {
    ...readTriangle(reader, start),
    frustum: readFrustum(reader, start.frustum),
    volume, order,
    scalar: reader.oneOf('scalar', ['float', 'double'], start.scalar),
    clippers: readClippers(reader, start.clippers, names.clippers),
    step: reader.count('step', order.length) ?? order.length,
    selected: kVertexNames.indexOf(reader.oneOf('selected', kVertexNames, 'a')),
    magnified: reader.count('magnified', 99),
    zoom: reader.count('zoom', kMostZoom) ?? start.zoom,
    instrument: reader.oneOf('show', names.panels, start.instrument),
    source: reader.take('source') ?? '',
  };
  reader.finish();
  return state;
}
