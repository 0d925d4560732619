// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the views draw of a scene, and which of it the reader has put out.

import type { Scene } from '../scene';
import type { State } from '../state';
import { kPlanes } from '../engine';
import type { ColourName } from './theme';

export const kLayers = ['input', 'step', 'first', 'second', 'exact'] as const;
export type Layer = (typeof kLayers)[number];

export const kLayerColours: Record<Layer, ColourName> =
  { input: 'input', step: 'volume', first: 'first', second: 'second', exact: 'exact' };

const hidden = new Set<Layer>();
const listeners: (() => void)[] = [];

export function isDrawn(layer: Layer): boolean {
  return !hidden.has(layer);
}

export function toggle(layer: Layer) {
  if (!hidden.delete(layer)) hidden.add(layer);
  for (const listener of listeners) listener();
}

export function onLayers(listener: () => void) {
  listeners.push(listener);
}

export function planeName(plane: number): string {
  return kPlanes[plane] ?? `clip distance ${plane - kPlanes.length}`;
}

// The plane that has cut last, while there are planes that have not; null before and after that.
export function lastPlane({ step, order }: State): number | null {
  return step > 0 && step < order.length ? order[step - 1]! : null;
}

function stepName({ state }: Scene): string {
  if (state.step === 0) return 'before any plane';
  if (state.step >= state.order.length) return 'cut by all planes';
  return `cut by ${state.order.slice(0, state.step).map(planeName).join(', ')}`;
}

export function layerName(layer: Layer, scene: Scene): string {
  const answer = (i: 0 | 1) => {
    const { clipper, polygon } = scene.answers[i];
    const count = polygon === null ? 'takes no such question'
      : polygon.length === 0 ? 'nothing' : `${polygon.length} vertices`;
    return `${clipper.name}: ${count}`;
  };
  switch (layer) {
    case 'input': return 'triangle';
    case 'step': return stepName(scene);
    case 'first': return answer(0);
    case 'second': return answer(1);
    case 'exact':
      return scene.exact === null ? 'no exact answer' : `exact: ${scene.exact.length} vertices`;
  }
}
