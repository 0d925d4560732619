// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hard cases that the page offers: the triangles of tests/corpus and what the user added when
// the page was built (engine/catalogue.cpp writes them).

import type { Question } from './engine';
import { embedded } from './embedded';

export interface HardCase {
  name: string;     // "theme/name"
  source: string;   // where it was met
  why: string;      // what makes it hard
  expected: string; // what comes out in exact arithmetic: "clipped 5", "accepted 3", "rejected"
  question: Question;
}

// In the order of the files, theme by theme.
export async function loadCatalogue(): Promise<readonly HardCase[]> {
  return JSON.parse(new TextDecoder().decode(await embedded('catalogue'))) as HardCase[];
}
