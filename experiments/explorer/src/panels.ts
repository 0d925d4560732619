// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the page in the order in which they stand there.

import type { Panel } from './panel';
import { kGuide, kInstruments } from './panels/groups';

// Side by side: the three spaces.
export const kViews: readonly Panel[] = [];

// Below them.
export const kPanels: readonly Panel[] = [kGuide, kInstruments];
