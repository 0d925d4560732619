// SPDX-License-Identifier: GPL-3.0-or-later
//
// The three spaces as parts of the page, side by side.

import type { Page, Panel } from '../panel';
import { choice, html } from '../panels/dom';
import type { Scene } from '../scene';
import { kCanonicalSpace } from './canonical_space';
import { Plot } from './plot';
import { kPyramid } from './pyramid';
import { kSlices } from './slices';
import type { Space } from './space';
import { kViewSpace } from './view_space';

const caption = (text: string) => html('p', { class: 'caption' }, text);

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

const kClipSpace: Panel = {
  id: 'clip_space',
  title: 'Clip space',
  mount(host: HTMLElement, page: Page) {
    const plots = kClipPlots.map(({ space }) => new Plot(space, page));
    const grid = html('div', { class: 'plots' }, ...plots.map((plot) => plot.root));
    const show = (chosen: string) => {
      grid.classList.toggle('one', chosen !== 'all');
      for (const { root } of plots) root.classList.toggle('chosen', root.dataset.space === chosen);
    };
    const options = kClipPlots.map(({ name, space }) => [space.id, name] as const);
    const part = choice('Part of clip space', [['all', 'all'], ...options], show);
    part.show('all');
    host.append(
      caption('Before the divide: inside is |x| \u2264 w, |y| \u2264 w.'),
      part.element, grid);
    return (scene: Scene) => { for (const plot of plots) plot.show(scene); };
  },
};

export const kSpaces: readonly Panel[] = [
  single('view_space', 'View space', 'The eye looks down \u2212z into the frustum.', kViewSpace),
  kClipSpace,
  single('canonical_volume', 'Canonical view volume',
         'After the divide by w: the frustum has become a box.', kCanonicalSpace),
];

// On a narrow screen one space is shown at a time.
export const kTabs: Panel = {
  id: 'tabs',
  title: 'Space that is shown',
  mount(host: HTMLElement) {
    const short = (title: string) => title === 'Canonical view volume' ? 'After the divide' : title;
    const show = (id: string) => { document.body.dataset.space = id; };
    const options = kSpaces.map(({ id, title }) => [id, short(title)] as const);
    const tabs = choice('Space that is shown', options, show);
    tabs.show(kSpaces[0]!.id);
    show(kSpaces[0]!.id);
    host.append(tabs.element);
    return () => {};
  },
};
