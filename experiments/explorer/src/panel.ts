// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a part of the page is: it is mounted once into a host element and shown every scene.

import type { HardCase } from './catalogue';
import type { Engine } from './engine';
import type { Scene } from './scene';
import type { Store } from './state';

export interface Page {
  engine: Engine;
  store: Store;
  catalogue: readonly HardCase[];
}

// Fills the host and returns what shows a scene there. The host is a <section> with a heading.
export interface Panel {
  id: string;    // of the section
  title: string; // of its heading
  mount(host: HTMLElement, page: Page): (scene: Scene) => void;
}
