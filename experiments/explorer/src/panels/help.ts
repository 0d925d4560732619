// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keyboard shortcuts, and the dialog that lists them.

import { linkOf } from '../link';
import type { Page, Panel } from '../panel';
import { button, html } from './dom';
import { copyText } from './share';
import { stepBy } from './steps';

interface Shortcut { keys: string[]; text: string; act: () => void }

// The tour knows which lesson the reader is in, also after the triangle was moved.
function turnLesson(to: 'before' | 'next') {
  document.querySelector<HTMLButtonElement>(`[data-lesson=${to}]`)?.click();
}

function shortcutsOf({ store }: Page, instruments: readonly Panel[], openHelp: () => void,
                     say: (text: string) => void): Shortcut[] {
  const exchanged = (): [string, string] => [store.state.clippers[1], store.state.clippers[0]];
  return [
    { keys: ['?'], text: 'this help', act: openHelp },
    ...instruments.map(({ id, title }, i) => ({ keys: [String(i + 1)], text: `the panel “${title}”`,
                                     act: () => store.update({ instrument: id }) })),
    { keys: ['['], text: 'one plane back', act: () => stepBy(store, -1) },
    { keys: [']'], text: 'one plane further', act: () => stepBy(store, 1) },
    { keys: ['x'], text: 'exchange the two clippers',
      act: () => store.update({ clippers: exchanged() }) },
    { keys: ['f'], text: 'float or double', act: () =>
      store.update({ scalar: store.state.scalar === 'float' ? 'double' : 'float' }) },
    { keys: ['n'], text: 'next lesson', act: () => turnLesson('next') },
    { keys: ['p'], text: 'lesson before', act: () => turnLesson('before') },
    { keys: ['l'], text: 'copy a link', act: () => {
      const address = `${location.href.replace(/#.*$/, '')}#${linkOf(store.state)}`;
      void copyText(address, null).then(say);
    } },
  ];
}

// What the handles of the views listen to themselves.
const kHandleKeys: readonly [string, string][] = [
  ['Tab', 'from vertex to vertex, and on through the page'],
  ['arrow keys', 'move the vertex that has the focus'],
  ['Page Up, Page Down', 'move it in depth'],
  ['Shift with these', 'move it by one ulp'],
  ['arrow keys, + \u2212 0', 'turn, zoom and fit the picture that has the focus'],
];

const isTyping = (target: EventTarget | null) =>
  target instanceof HTMLElement &&
  (target.isContentEditable || /^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName));

// Adds a button with the help to the header, and listens to the shortcuts.
export function mountHelp(page: Page, instruments: readonly Panel[], header: HTMLElement) {
  const line = (keys: string, text: string) =>
    html('div', {}, html('dt', {}, html('kbd', {}, keys)), html('dd', {}, text));
  const status = html('span', { role: 'status', class: 'feedback' });
  const dialog = html('dialog', { 'aria-label': 'Keyboard' });
  const shortcuts = shortcutsOf(page, instruments, () => dialog.showModal(), (text) => {
    status.textContent = text;
    window.setTimeout(() => { status.textContent = ''; }, 2000);
  });
  dialog.append(
    html('h2', {}, 'Keyboard'),
    html('dl', {}, ...shortcuts.map(({ keys, text }) => line(keys.join(', '), text)),
         ...kHandleKeys.map(([keys, text]) => line(keys, text))),
    button('Close', () => dialog.close()));
  header.append(button('? Help', () => dialog.showModal(), { id: 'help-button' }), status, dialog);
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || isTyping(event.target) || dialog.open) return;
    const shortcut = shortcuts.find(({ keys }) => keys.includes(event.key));
    if (shortcut === undefined) return;
    event.preventDefault();
    shortcut.act();
  });
}
