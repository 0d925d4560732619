// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the page shows, as one value, and the store that tells everybody when it changes. What is
// derived from it (scene.ts) is not in it; what a link keeps (link.ts) is all of it.

import { kPlanes } from './engine';
import type { Question, Scalar, Volume } from './engine';

// The names of the triangle's vertices.
export const kLetters = ['A', 'B', 'C'] as const;

export interface State extends Question {
  scalar: Scalar;
  clippers: [string, string]; // by name: the two that are laid over each other
  order: number[];            // of all planes that cut, step by step
  step: number;               // 0: the whole triangle; order.length: after all planes
  selected: number;           // the vertex of the triangle that keys move: 0, 1 or 2
  magnified: number | null;   // the vertex of the first answer under the magnifier
  zoom: number;               // of the magnifier: it shows 2^-zoom of the whole screen
  instrument: string;         // the panel that is open
  source: string;             // what the triangle is: a hard case's or a lesson's name, or ''
}

// Below it the doubles next to 1 are some ten pixels apart.
export const kMostZoom = 58;

export function initialState(): State {
  return {
    frustum: { parallel: false, left: -1, right: 1, bottom: -1, top: 1, near: 1, far: 10,
               infiniteFar: false, shearX: 0, shearY: 0, depth: 'minus_one_to_one' },
    volume: { clampNear: false, clampFar: false, clipDistances: 0,
              openSides: { left: false, right: false, bottom: false, top: false } },
    space: 'view',
    triangle: [
      { position: [-3, -2, -5, 0], attributes: [0, 0, 0, 0] },
      { position: [6, -1, -4, 0], attributes: [1, 0, 0, 0] },
      { position: [-1, 5, -8, 0], attributes: [0, 1, 0, 0] },
    ],
    scalar: 'float',
    clippers: ['homogeneous/sutherland_hodgman', 'cvv/naive'],
    order: [4, 5, 0, 1, 2, 3],
    step: 6,
    selected: 0,
    magnified: null,
    zoom: 0,
    instrument: 'clippers',
    source: '',
  };
}

export function planesThatCut(volume: Volume): number[] {
  const cuts = (plane: number) => !(kPlanes[plane] === 'near' && volume.clampNear) &&
                                  !(kPlanes[plane] === 'far' && volume.clampFar);
  return Array.from({ length: kPlanes.length + volume.clipDistances }, (_, p) => p).filter(cuts);
}

// As a step: that after all planes, however many there are.
export const kAllPlanes = kPlanes.length + 8;

// The state with an order of just the planes that cut: those that have come to be are last. Where
// all planes had cut, all do.
function withPlanes(state: State): State {
  const planes = planesThatCut(state.volume);
  const order = state.order.filter((p) => planes.includes(p));
  order.push(...planes.filter((p) => !order.includes(p)));
  const isSame = order.length === state.order.length && order.every((p, i) => p === state.order[i]);
  const step = state.step >= state.order.length ? order.length : Math.min(state.step, order.length);
  return isSame && step === state.step ? state : { ...state, order, step };
}

type Listener = (state: State, before: State) => void;

// One for the page. Listeners are called once per change, all changes of a frame together.
export class Store {
  private listeners: Listener[] = [];
  private shown: State;
  private isWaiting = false;

  constructor(private current: State) {
    this.shown = current;
  }

  get state(): State {
    return this.current;
  }

  // Changes some of it. Values are replaced, never changed in place; the order follows the volume.
  update(change: Partial<State>) {
    this.current = withPlanes({ ...this.current, ...change });
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => this.show());
  }

  subscribe(listener: Listener) {
    this.listeners.push(listener);
    listener(this.current, this.current);
  }

  private show() {
    this.isWaiting = false;
    const before = this.shown;
    this.shown = this.current;
    for (const listener of this.listeners) listener(this.current, before);
  }
}
