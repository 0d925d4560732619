// SPDX-License-Identifier: GPL-3.0-or-later
//
// The three spaces as parts of the page, side by side.

import type { Page, Panel } from '../panel';
import type { Scene } from '../scene';
import { kCanonicalSpace } from './canonical_space';
import { kPyramid, kSlices } from './clip_space';
import { Plot } from './plot';
import type { Space } from './space';
import { kViewSpace } from './view_space';

function caption(text: string): HTMLElement {
  const p = document.createElement('p');
  p.className = 'caption';
  p.textContent = text;
  return p;
}

function single(id: string, title: string, text: string, space: Space): Panel {
  return {
    id, title,
    mount(host: HTMLElement, page: Page) {
      const plot = new Plot(space, page);
      host.append(caption(text), plot.root);
      return (scene: Scene) => plot.show(scene);
    },
  };
}

const kClipPlots: readonly { name: string; space: Space }[] = [
  { name: 'x y w', space: kPyramid },
  { name: 'x\u2013w', space: kSlices[0]! },
  { name: 'y\u2013w', space: kSlices[1]! },
  { name: 'z\u2013w', space: kSlices[2]! },
];

// Buttons that choose one of several; the chosen one is pressed.
function choice(label: string, names: readonly string[], choose: (index: number) => void): HTMLElement {
  const group = document.createElement('div');
  group.className = 'choice';
  group.setAttribute('role', 'group');
  group.setAttribute('aria-label', label);
  const buttons = names.map((name, i) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = name;
    button.addEventListener('click', () => press(i));
    return button;
  });
  const press = (index: number) => {
    buttons.forEach((b, i) => b.setAttribute('aria-pressed', String(i === index)));
    choose(index);
  };
  group.append(...buttons);
  press(0);
  return group;
}

const kClipSpace: Panel = {
  id: 'clip_space',
  title: 'Clip space',
  mount(host: HTMLElement, page: Page) {
    const plots = kClipPlots.map(({ space }) => new Plot(space, page));
    const grid = document.createElement('div');
    grid.className = 'plots';
    grid.append(...plots.map((plot) => plot.root));
    const show = (index: number) => { // 0: all of them
      grid.classList.toggle('one', index > 0);
      plots.forEach((plot, i) => plot.root.classList.toggle('chosen', i === index - 1));
    };
    host.append(
      caption('Four numbers before the divide: inside is where \u2212w \u2264 x, y, z \u2264 w.'),
      choice('Which part of clip space', ['all', ...kClipPlots.map((p) => p.name)], show), grid);
    return (scene: Scene) => { for (const plot of plots) plot.show(scene); };
  },
};

export const kSpaces: readonly Panel[] = [
  single('view_space', 'View space', 'The eye looks down \u2212z into the frustum.', kViewSpace),
  kClipSpace,
  single('canonical_volume', 'Canonical view volume',
         'After the divide by w: the frustum has become a box.', kCanonicalSpace),
];
