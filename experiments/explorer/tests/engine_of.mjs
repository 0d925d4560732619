// SPDX-License-Identifier: GPL-3.0-or-later
//
// WebAssembly for tests: the engine, and the random questions that are linked to it there.
import { readFile } from 'node:fs/promises';

import { load } from './bundle.mjs';

const { engine } = await load('engine');
export const { Engine, kAttributes, kDepths } = engine;

// The exports of a file of WebAssembly, without the class around them.
export async function exportsOf(file) {
  const module = await WebAssembly.compile(await readFile(file));
  const unreachable = () => { throw new Error('the engine called the system'); };
  const system = Object.fromEntries(WebAssembly.Module.imports(module)
    .map(({ name }) => [name, unreachable]));
  const { exports } = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: system });
  exports._initialize?.();
  return exports;
}

// The text that ends with a 0 there.
export function textAt(wasm, at) {
  const bytes = new Uint8Array(wasm.memory.buffer, at);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

const kSettingNumbers = 16; // tests/questions.hpp

// The random question of that number as engine.ts takes it.
export function questionOf(wasm, number) {
  const at = wasm.clipscope_ask(number);
  const [parallel, left, right, bottom, top, near, far, infinite, shearX, shearY, depth, clampNear,
    clampFar, clipDistances, open, isClip] = new Float64Array(wasm.memory.buffer, at, kSettingNumbers);
  const numbers = Array.from(new Float64Array(wasm.memory.buffer, wasm.clipscope_numbers(),
                                              3 * (4 + kAttributes)));
  const vertex = (i) => {
    const own = numbers.slice(i * (4 + kAttributes), (i + 1) * (4 + kAttributes));
    return { position: own.slice(0, 4), attributes: own.slice(4) };
  };
  const sides = { left: (open & 1) !== 0, right: (open & 2) !== 0, bottom: (open & 4) !== 0,
                  top: (open & 8) !== 0 };
  return {
    frustum: { parallel: parallel !== 0, left, right, bottom, top, near, far,
               infiniteFar: infinite !== 0, shearX, shearY, depth: kDepths[depth] },
    volume: { clampNear: clampNear !== 0, clampFar: clampFar !== 0, clipDistances,
              openSides: sides },
    space: isClip !== 0 ? 'clip' : 'view',
    triangle: [vertex(0), vertex(1), vertex(2)],
  };
}
