// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scene in words, for those who do not see it and for those who want to check what they see.

import type { Panel } from '../panel';
import { html } from '../panels/dom';
import type { Scene } from '../scene';
import { kLetters } from '../state';
import { layerName, planeName } from './layers';

const kQuiet = 900; // milliseconds without a change before a screen reader is told

function joined(words: readonly string[]): string {
  return words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`;
}

// One sentence about a vertex.
function vertexWords(scene: Scene, vertex: number): string {
  const w = scene.clip[vertex]!.position[3];
  const bits = scene.distances[vertex]!.outcode;
  const planes = scene.distances[vertex]!.byPlane.flatMap(
    (_, p) => (bits >> p & 1) !== 0 ? [planeName(p)] : []);
  const sides = planes.length === 0 ? 'is inside' : `is outside ${joined(planes)}`;
  const behind = w < 0 ? ' and behind the eye (w < 0)'
    : w === 0 ? ' and beside the eye (w = 0)' : '';
  return `${kLetters[vertex]} ${sides}${behind}.`;
}

function describe(scene: Scene): string {
  const answers = (['first', 'second', 'exact'] as const).map((layer) => layerName(layer, scene));
  return [...[0, 1, 2].map((i) => vertexWords(scene, i)), `${answers.join('; ')}.`].join(' ');
}

export const kWords: Panel = {
  id: 'words',
  title: 'The scene in words',
  mount(host: HTMLElement) {
    const words = html('p', { role: 'status' });
    host.append(words);
    let timer = 0;
    return (scene: Scene) => {
      window.clearTimeout(timer);
      timer = window.setTimeout(() => { words.textContent = describe(scene); },
                                words.textContent === '' ? 0 : kQuiet);
    };
  },
};
