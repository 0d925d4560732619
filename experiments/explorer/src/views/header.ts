// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of the page: the switch of colours, and the way past the views for the keyboard.

import { mountThemeSwitch } from './theme';

const element = (id: string) => document.getElementById(id)!;

export function mountHeader() {
  mountThemeSwitch(element('theme') as HTMLButtonElement);
  // No link: the fragment of the address is the state (follow_link.ts).
  element('skip').addEventListener('click', () => element('panels').focus());
}
