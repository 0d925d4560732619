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

interface Caption { element: HTMLElement; show: (scene: Scene) => void }

function captionOf(text: (scene: Scene) => string): Caption {
  const element = html('p', { class: 'caption' });
  const show = (scene: Scene) => {
    const wanted = text(scene);
    if (element.textContent !== wanted) element.textContent = wanted;
  };
  return { element, show };
}

function viewCaption({ state: { frustum } }: Scene): string {
  return frustum.parallel ? 'Parallel rays go down \u2212z through a box.'
    : 'The eye looks down \u2212z into the frustum.';
}

function canonicalCaption({ state: { frustum, space }, clip }: Scene): string {
  const sizes = clip.map((v) => v.position[3]);
  if (sizes.some((w) => w < 0) && sizes.some((w) => w > 0)) {
    return 'Edges through w = 0 go to infinity and come back.';
  }
  return frustum.parallel && space === 'view' ? 'w is 1: the divide changes nothing.'
    : 'After the divide by w: the frustum is a box.';
}

function single(id: string, title: string, text: (scene: Scene) => string, space: Space): Panel {
  return {
    id, title,
    mount(host: HTMLElement, page: Page) {
      const plot = new Plot(space, page), caption = captionOf(text);
      host.append(caption.element, plot.root);
      return (scene: Scene) => {
        caption.show(scene);
        plot.show(scene);
      };
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
    const caption = html('p', { class: 'caption' }, 'Before the divide: inside is |x|, |y| \u2264 w.');
    host.append(caption, part.element, grid);
    return (scene: Scene) => { for (const plot of plots) plot.show(scene); };
  },
};

export const kSpaces: readonly Panel[] = [
  single('view_space', 'View space', viewCaption, kViewSpace),
  kClipSpace,
  single('canonical_volume', 'Canonical view volume', canonicalCaption, kCanonicalSpace),
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
