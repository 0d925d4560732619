// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend of the views: what each colour is, with a switch for each, and the scene in words.

import type { Panel } from '../panel';
import type { Scene } from '../scene';
import { isDrawn, kLayerColours, kLayers, layerName, planeName, toggle, type Layer } from './layers';
import { kLetters } from './plot';
import { kSpaces } from './spaces';

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
  const behind = w < 0 ? ' and behind the eye (w < 0)' : w === 0 ? ' and at the eye\u2019s depth (w = 0)' : '';
  return `${kLetters[vertex]} ${sides}${behind}.`;
}

// The scene in words, for those who do not see it and for those who want to check what they see.
export function describe(scene: Scene): string {
  const answers = (['first', 'second', 'exact'] as const).map((layer) => layerName(layer, scene));
  return [...[0, 1, 2].map((i) => vertexWords(scene, i)), `${answers.join('; ')}.`].join(' ');
}

function layerSwitch(layer: Layer): { button: HTMLButtonElement; name: HTMLElement } {
  const button = document.createElement('button');
  const name = document.createElement('span');
  button.type = 'button';
  button.className = `layer ${layer}`;
  button.style.setProperty('--own', `var(--${kLayerColours[layer]})`);
  button.append(document.createElement('i'), name);
  button.setAttribute('aria-pressed', String(isDrawn(layer)));
  button.addEventListener('click', () => {
    toggle(layer);
    button.setAttribute('aria-pressed', String(isDrawn(layer)));
  });
  return { button, name };
}

// On a narrow screen one space is shown at a time.
function spaceTabs(): HTMLElement {
  const nav = document.createElement('div');
  nav.className = 'choice tabs';
  nav.setAttribute('role', 'group');
  nav.setAttribute('aria-label', 'Space that is shown');
  const buttons = kSpaces.map(({ id, title }) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = title.replace('Canonical view volume', 'After the divide');
    button.addEventListener('click', () => choose(id));
    return { id, button };
  });
  const choose = (chosen: string) => {
    document.body.dataset.space = chosen;
    for (const { id, button } of buttons) button.setAttribute('aria-pressed', String(id === chosen));
  };
  nav.append(...buttons.map((b) => b.button));
  choose(kSpaces[0]!.id);
  return nav;
}

export const kLegend: Panel = {
  id: 'legend',
  title: 'What is drawn',
  mount(host: HTMLElement) {
    const switches = kLayers.map((layer) => ({ layer, ...layerSwitch(layer) }));
    const row = document.createElement('div');
    row.className = 'layers';
    row.append(...switches.map((s) => s.button));
    const words = document.createElement('p');
    words.className = 'words';
    words.setAttribute('role', 'status');
    host.append(spaceTabs(), row, words);
    let timer = 0;
    return (scene: Scene) => {
      for (const { layer, name } of switches) {
        name.textContent = layerName(layer, scene);
      }
      window.clearTimeout(timer);
      timer = window.setTimeout(() => { words.textContent = describe(scene); },
                                words.textContent === '' ? 0 : kQuiet);
    };
  },
};
