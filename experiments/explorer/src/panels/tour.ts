// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tour: ten short lessons, each with something to try, and a look at whether the reader did it.

import { kLessons, kLessonSource, lessonOf, openLesson } from '../lessons/lessons';
import type { Lesson } from '../lessons/lessons';
import type { Page, Panel } from '../panel';
import type { Scene } from '../scene';
import { button, html } from './dom';

// Formulas stay in one line.
const unbroken = (text: string) => text.replace(/ ([≤≥<>=]) /g, '\u00a0$1\u00a0');

function mount(host: HTMLElement, { store }: Page) {
  const done = new Set<string>();
  let current: Lesson | null = null;

  const open = (lesson: Lesson | undefined) => {
    if (lesson !== undefined) openLesson(store, lesson);
  };
  const by = (places: number) => {
    const at = current === null ? -1 : kLessons.indexOf(current);
    return kLessons[at + places];
  };
  const back = button('◀ Back', () => open(by(-1)), { 'data-lesson': 'before' });
  const again = button('↺ Start again', () => {
    if (current !== null) done.delete(current.id);
    open(current ?? undefined);
  });
  const next = button('Next ▶', () => open(by(1)), { class: 'main', 'data-lesson': 'next' });
  const heading = html('h3');
  const text = html('div', { class: 'lesson' });
  const task = html('p', { class: 'task', role: 'status', 'aria-live': 'polite' });
  const items = kLessons.map((lesson) => button(lesson.title, () => open(lesson)));
  const list = html('details', {}, html('summary', {}, 'All lessons'),
                    html('ol', { class: 'lessons' }, ...items.map((b) => html('li', {}, b))));
  host.append(heading, text, task, html('div', { class: 'controls' }, back, again, next), list);

  const showLesson = () => {
    heading.textContent = current === null ? 'Where should a triangle be clipped?'
      : `${kLessons.indexOf(current) + 1}. ${current.title}`;
    const paragraphs = current?.text ?? [
      'One triangle is shown in three spaces at once. Drag a corner in any of them, and the others ' +
      'follow.',
      'Ten short lessons walk from the simplest answer to the best one. Each ends with something to ' +
      'try, and notices when you did it.'];
    text.replaceChildren(...paragraphs.map((p) => html('p', {}, unbroken(p))));
    back.disabled = by(-1) === undefined;
    next.disabled = by(1) === undefined;
    next.textContent = current === null ? 'Start the tour ▶' : 'Next ▶';
    again.hidden = current === null;
    items.forEach((b, i) => b.setAttribute('aria-current', String(kLessons[i] === current)));
  };

  const showTask = (scene: Scene) => {
    if (current === null) return task.replaceChildren();
    // A link that opens the finished lesson counts, too.
    if (current.isDone(scene)) done.add(current.id);
    const isDone = done.has(current.id);
    task.classList.toggle('done', isDone);
    const wanted = isDone ? `✓ ${current.done}` : `Try it: ${current.task}`;
    if (task.textContent !== wanted) task.textContent = wanted;
    items.forEach((b, i) => b.classList.toggle('done', done.has(kLessons[i]!.id)));
  };

  let source: string | null = null;
  return (scene: Scene) => {
    if (scene.state.source !== source) {
      source = scene.state.source;
      if (source === '' || source.startsWith(kLessonSource)) {
        current = lessonOf(source) ?? (source === '' ? current : null);
      }
      showLesson();
    }
    showTask(scene);
  };
}

export const kTourPanel: Panel = { id: 'tour', title: 'Tour', mount };
