// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clippers of spaces/ as WebAssembly (engine/engine.cpp): plain numbers in, plain numbers out.
// A float travels as the double of the same value, so that no bit is lost on the way.

export type Scalar = 'float' | 'double';
export type Space = 'view' | 'clip';
export type Depth = 'minus_one_to_one' | 'zero_to_one' | 'reversed';
export const kDepths: readonly Depth[] = ['minus_one_to_one', 'zero_to_one', 'reversed'];

// In the order of their bits in an outcode; clip distances follow.
export const kPlanes = ['left', 'right', 'bottom', 'top', 'near', 'far'] as const;
export type PlaneName = (typeof kPlanes)[number];
export const kMaxPlanes = 14;
export const kAttributes = 4;

export type Vec4 = [number, number, number, number];

// A vertex of the triangle or of a polygon: x y z w in clip space, x y z 1/w after the divide; w is
// not used in view space (0). Attributes are the true values at that point.
export interface Vertex {
  position: Vec4;
  attributes: number[];
}
export type Triangle = [Vertex, Vertex, Vertex];

export interface Frustum {
  parallel: boolean;
  left: number;
  right: number;
  bottom: number;
  top: number;
  near: number;
  far: number;
  infiniteFar: boolean;
  shearX: number;
  shearY: number;
  depth: Depth;
}

export interface Volume {
  clampNear: boolean;
  clampFar: boolean;
  clipDistances: number; // the first so many attributes
  openSides: { left: boolean; right: boolean; bottom: boolean; top: boolean };
}

export interface Clipper {
  index: number;
  name: string;
  summary: string;
  source: string;
  type: string;       // its name in C++
  clipSpace: boolean; // takes clip-space triangles
  double: boolean;    // exists in double
}

// What is to be clipped, against what: all that an answer depends on beside the clipper.
export interface Question {
  frustum: Frustum;
  volume: Volume;
  space: Space; // that the triangle's numbers are in
  triangle: Triangle;
}

export interface Distances {
  byPlane: number[]; // by plane, clip distances behind the six
  outcode: number;   // bit p is set where the vertex is outside plane p
}

interface Exports {
  memory: WebAssembly.Memory;
  _initialize?(): void;
  malloc(bytes: number): number;
  clipscope_numbers(): number;
  clipscope_results(): number;
  clipscope_clippers(): number;
  clipscope_set_frustum(...numbers: number[]): void;
  clipscope_set_volume(near: number, far: number, distances: number, open: number): void;
  clipscope_clip(clipper: number, isDouble: number, fromClip: number): number;
  clipscope_project(isDouble: number): void;
  clipscope_distances(isDouble: number, fromClip: number): void;
  clipscope_steps(isDouble: number, fromClip: number, planes: number, count: number): void;
}

const kVertexNumbers = 4 + kAttributes;

// The number rounded as the scalar says.
export function rounded(scalar: Scalar, x: number): number {
  return scalar === 'float' ? Math.fround(x) : x;
}

export class Engine {
  readonly clippers: readonly Clipper[];
  private readonly order: number; // where planes are written

  private constructor(private readonly wasm: Exports) {
    this.clippers = (JSON.parse(this.text(wasm.clipscope_clippers())) as Omit<Clipper, 'index'>[])
      .map((clipper, index) => ({ index, ...clipper }));
    this.order = wasm.malloc(kMaxPlanes);
  }

  // bytes: engine.wasm. Errors: those of WebAssembly.
  static async load(bytes: BufferSource): Promise<Engine> {
    // The C library's exits and writes, which no clipper reaches.
    const unreachable = () => { throw new Error('the clippers called the system'); };
    const system = { proc_exit: unreachable, fd_close: unreachable, fd_write: unreachable,
                     fd_seek: unreachable };
    const { instance } = await WebAssembly.instantiate(bytes, { wasi_snapshot_preview1: system });
    const wasm = instance.exports as unknown as Exports;
    wasm._initialize?.();
    return new Engine(wasm);
  }

  clipper(name: string): Clipper | undefined {
    return this.clippers.find((c) => c.name === name);
  }

  // The polygon in the canonical view volume, or null where the clipper does not take the question.
  clip(clipper: Clipper, scalar: Scalar, question: Question): Vertex[] | null {
    this.ask(scalar, question);
    const count = this.wasm.clipscope_clip(
      clipper.index, Number(scalar === 'double'), Number(question.space === 'clip'));
    return count < 0 ? null : this.vertices(0, count);
  }

  // The triangle in clip space, projected in the scalar where its numbers are in view space.
  project(scalar: Scalar, question: Question): Triangle {
    if (question.space === 'clip') return question.triangle;
    this.ask(scalar, question);
    this.wasm.clipscope_project(Number(scalar === 'double'));
    return this.vertices(0, 3) as Triangle;
  }

  distances(scalar: Scalar, question: Question): Distances[] {
    this.ask(scalar, question);
    this.wasm.clipscope_distances(Number(scalar === 'double'), Number(question.space === 'clip'));
    const numbers = this.results();
    return [0, 1, 2].map((i) => {
      const row = numbers.subarray(i * (kMaxPlanes + 1), (i + 1) * (kMaxPlanes + 1));
      const planes = kPlanes.length + question.volume.clipDistances;
      return { byPlane: Array.from(row.subarray(0, planes)), outcode: row[kMaxPlanes]! };
    });
  }

  // Sutherland and Hodgman in clip space, plane after plane in the order given: the triangle, then
  // the polygon after each plane.
  steps(scalar: Scalar, question: Question, planes: readonly number[]): Vertex[][] {
    this.ask(scalar, question);
    new Uint8Array(this.wasm.memory.buffer, this.order, planes.length).set(planes);
    this.wasm.clipscope_steps(Number(scalar === 'double'), Number(question.space === 'clip'),
                              this.order, planes.length);
    let at = 0;
    return Array.from({ length: planes.length + 1 }, () => {
      const count = this.results()[at]!;
      const polygon = this.vertices(at + 1, count);
      at += 1 + count * kVertexNumbers;
      return polygon;
    });
  }

  private ask(scalar: Scalar, { frustum: f, volume: v, space, triangle }: Question) {
    const r = (x: number) => rounded(scalar, x);
    this.wasm.clipscope_set_frustum(
      Number(f.parallel), r(f.left), r(f.right), r(f.bottom), r(f.top), r(f.near), r(f.far),
      Number(f.infiniteFar), r(f.shearX), r(f.shearY), kDepths.indexOf(f.depth));
    const open = v.openSides;
    this.wasm.clipscope_set_volume(
      Number(v.clampNear), Number(v.clampFar), v.clipDistances,
      Number(open.left) + 2 * Number(open.right) + 4 * Number(open.bottom) + 8 * Number(open.top));
    const numbers = new Float64Array(this.wasm.memory.buffer, this.wasm.clipscope_numbers(),
                                     3 * kVertexNumbers);
    triangle.forEach((vertex, i) => {
      numbers.set(vertex.position.map(r), i * kVertexNumbers);
      if (space === 'view') numbers[i * kVertexNumbers + 3] = 0;
      numbers.set(vertex.attributes.map(r), i * kVertexNumbers + 4);
    });
  }

  // Memory may have moved since the last call.
  private results(): Float64Array {
    const at = this.wasm.clipscope_results();
    return new Float64Array(this.wasm.memory.buffer, at,
                            Math.floor((this.wasm.memory.buffer.byteLength - at) / 8));
  }

  private vertices(from: number, count: number): Vertex[] {
    const numbers = this.results();
    return Array.from({ length: count }, (_, i) => {
      const v = Array.from(numbers.subarray(from + i * kVertexNumbers,
                                            from + (i + 1) * kVertexNumbers));
      return { position: v.slice(0, 4) as Vec4, attributes: v.slice(4) };
    });
  }

  private text(at: number): string {
    const bytes = new Uint8Array(this.wasm.memory.buffer, at);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }
}
