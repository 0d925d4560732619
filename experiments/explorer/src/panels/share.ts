// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is on the page as a link, as a command of the program, as a case of the corpus and as C++.

import { corpusCase, cppProgram, explainCommand } from '../copy';
import type { Copied } from '../copy';
import { linkOf } from '../link';
import type { Panel } from '../panel';
import type { Scene } from '../scene';
import { button, choice, html } from './dom';

type Kind = 'link' | 'explain' | 'corpus' | 'cpp';

const kKinds: readonly (readonly [Kind, string])[] = [
  ['link', 'link'], ['explain', 'clipscope explain'], ['corpus', 'case of the corpus'], ['cpp', 'C++'],
];

const kNotes: Record<Kind, string> = {
  link: 'The address of this page keeps all of it, to the bit.',
  explain: 'Run it in a shell: the program says the same of this triangle, and more.',
  corpus: 'For a file of your own, or for tests/corpus. The program checks it when it reads it.',
  cpp: 'A program that clips this triangle by the first clipper and prints the polygon. CLIPSCOPE ' +
       'is where the project is.',
};

// The page's address with the state as its fragment.
export const addressOf = (scene: Scene) =>
  `${location.href.replace(/#.*$/, '')}#${linkOf(scene.state)}`;

function copied(kind: Kind, scene: Scene): Copied {
  const { clipper, polygon } = scene.answers[0];
  switch (kind) {
    case 'link': return { text: addressOf(scene) };
    case 'explain': return explainCommand(scene.state, clipper, polygon !== null);
    case 'corpus': return corpusCase(scene.state);
    case 'cpp': return cppProgram(scene.state, clipper, polygon !== null);
  }
}

// Copies the text; where the browser does not let a page do that, the reader can.
export async function copyText(text: string, source: HTMLElement | null): Promise<string> {
  try {
    await navigator.clipboard.writeText(text);
    return 'Copied.';
  } catch {
    if (source !== null) getSelection()?.selectAllChildren(source);
    return 'The browser does not allow it. The text is selected: press Ctrl+C.';
  }
}

function mount(host: HTMLElement) {
  let kind: Kind = 'link';
  let shown: Scene | null = null;
  const kinds = choice<Kind>('Copy as', kKinds, (value) => {
    kind = value;
    if (shown !== null) show(shown);
  });
  const text = html('pre', { tabindex: 0, 'aria-label': 'What is copied' });
  const feedback = html('span', { role: 'status', class: 'feedback' });
  const copy = button('Copy', async () => {
    feedback.textContent = await copyText(text.textContent ?? '', text);
  }, { class: 'main' });
  const note = html('p', { class: 'note' });
  const show = (scene: Scene) => {
    shown = scene;
    kinds.show(kind);
    const result = copied(kind, scene);
    const isThere = 'text' in result;
    const wanted = isThere ? result.text : result.reason;
    if (text.textContent !== wanted) {
      text.textContent = wanted;
      feedback.textContent = '';
    }
    text.classList.toggle('reason', !isThere);
    copy.disabled = !isThere;
    note.textContent = kNotes[kind];
  };
  host.append(html('div', { class: 'controls' }, kinds.element), note, text,
              html('div', { class: 'controls' }, copy, feedback));
  return show;
}

export const kSharePanel: Panel = { id: 'share', title: 'Copy', mount };
