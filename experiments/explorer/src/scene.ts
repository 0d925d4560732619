// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is derived from a state, once per change: the triangle in all three spaces, its distances,
// the answers of both clippers, the exact one and the steps from plane to plane.

import type { Clipper, Distances, Engine, Triangle, Vertex } from './engine';
import type { State } from './state';
import { isInvertible, toView } from './projection';

export interface Answer {
  clipper: Clipper;
  polygon: Vertex[] | null; // null: the clipper does not take the question
}

export interface Scene {
  state: State;
  clip: Triangle;         // in clip space
  view: Triangle | null;  // null where no point of view space has these clip coordinates
  ndc: (Vertex | null)[]; // after the divide; null where w is 0
  distances: Distances[];
  answers: [Answer, Answer];
  exact: Vertex[] | null; // barycentric/correctly_rounded in float
  steps: Vertex[][];      // clip space, before the first plane and after each
}

const kExact = 'barycentric/correctly_rounded';

export function divided({ position: [x, y, z, w], attributes }: Vertex): Vertex | null {
  return w === 0 ? null : { position: [x / w, y / w, z / w, 1 / w], attributes };
}

// Errors: throws where the state names a clipper that there is not.
export function sceneOf(engine: Engine, state: State): Scene {
  const named = (name: string): Clipper => {
    const clipper = engine.clipper(name);
    if (clipper === undefined) throw new Error(`there is no clipper '${name}'`);
    return clipper;
  };
  const answer = (name: string): Answer => {
    const clipper = named(name);
    return { clipper, polygon: engine.clip(clipper, state.scalar, state) };
  };
  const clip = engine.project(state.scalar, state);
  const view = state.space === 'view' ? state.triangle
    : isInvertible(state.frustum) ? toView(state.frustum, clip) : null;
  return {
    state, clip, view,
    ndc: clip.map(divided),
    distances: engine.distances(state.scalar, state),
    answers: [answer(state.clippers[0]), answer(state.clippers[1])],
    exact: engine.clip(named(kExact), 'float', state),
    steps: engine.steps(state.scalar, state, state.order),
  };
}
