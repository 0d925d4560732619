// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tour in its order.

import { initialState } from '../state';
import type { Store } from '../state';
import { kFirstLessons } from './before_the_divide';
import type { Lesson } from './lesson';
import { kLastLessons } from './to_the_last_bit';

export type { Lesson } from './lesson';
export const kLessons: readonly Lesson[] = [...kFirstLessons, ...kLastLessons];

// What a state's source starts with where a lesson opened it.
export const kLessonSource = 'lesson/';

export function lessonOf(source: string): Lesson | null {
  return kLessons.find(({ id }) => kLessonSource + id === source) ?? null;
}

export function openLesson(store: Store, lesson: Lesson) {
  store.update({ ...initialState(), ...lesson.open, source: kLessonSource + lesson.id });
}
