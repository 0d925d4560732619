// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend of the views: what each colour is, with a switch for each, and the scene in words.

import type { Panel } from '../panel';
import { html } from '../panels/dom';
import type { Scene } from '../scene';
import { kLetters } from '../state';
import { mountHeader } from './header';
import { isDrawn, kLayerColours, kLayers, layerName, planeName, toggle } from './layers';
import type { Layer } from './layers';

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

// The scene in words, for those who do not see it and for those who want to check what they see.
function describe(scene: Scene): string {
  const answers = (['first', 'second', 'exact'] as const).map((layer) => layerName(layer, scene));
  return [...[0, 1, 2].map((i) => vertexWords(scene, i)), `${answers.join('; ')}.`].join(' ');
}

function layerSwitch(layer: Layer): { element: HTMLElement; name: HTMLElement } {
  const name = html('span');
  const pressed = () => String(isDrawn(layer));
  const element = html('button', {
    type: 'button', class: 'layer', 'data-layer': layer, 'aria-pressed': pressed(),
    style: `--own: var(--${kLayerColours[layer]})`,
    click: () => {
      toggle(layer);
      element.setAttribute('aria-pressed', pressed());
    },
  }, html('i'), name);
  return { element, name };
}

export const kLegend: Panel = {
  id: 'legend',
  title: 'What is drawn',
  mount(host: HTMLElement) {
    mountHeader();
    const switches = kLayers.map((layer) => ({ layer, ...layerSwitch(layer) }));
    const words = html('p', { class: 'words', role: 'status' });
    const behind = html('span', { class: 'behind' }, html('i'), 'behind the eye, w < 0');
    host.append(html('div', { class: 'layers' }, ...switches.map((s) => s.element), behind), words);
    let timer = 0;
    return (scene: Scene) => {
      for (const { layer, name } of switches) name.textContent = layerName(layer, scene);
      // It keeps its room: nothing above the pictures moves while a vertex is dragged.
      const isBehind = scene.clip.some((v) => v.position[3] < 0);
      behind.style.visibility = isBehind ? 'visible' : 'hidden';
      window.clearTimeout(timer);
      timer = window.setTimeout(() => { words.textContent = describe(scene); },
                                words.textContent === '' ? 0 : kQuiet);
    };
  },
};
