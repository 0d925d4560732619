// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend of the views: what each colour is, with a switch for each.

import type { Panel } from '../panel';
import { html } from '../panels/dom';
import type { Scene } from '../scene';
import { mountHeader } from './header';
import { isDrawn, kLayerColours, kLayers, layerName, toggle } from './layers';
import type { Layer } from './layers';

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
    const behind = html('span', { class: 'behind' }, html('i'), 'behind the eye, w < 0');
    host.append(html('div', { class: 'layers' }, ...switches.map((s) => s.element), behind));
    return (scene: Scene) => {
      for (const { layer, name } of switches) name.textContent = layerName(layer, scene);
      // It keeps its room: nothing above the pictures moves while a vertex is dragged.
      const isBehind = scene.clip.some((v) => v.position[3] < 0);
      behind.style.visibility = isBehind ? 'visible' : 'hidden';
    };
  },
};
