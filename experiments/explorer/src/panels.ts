// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the page in the order in which they stand there.

import type { Panel } from './panel';
import { kGuide, kInstruments } from './panels/groups';
import { kLegend } from './views/legend';
import { kSpaces, kTabs } from './views/spaces';

// The three spaces side by side, their legend above them.
export const kViews: readonly Panel[] = [kTabs, kLegend, ...kSpaces];

// Below them.
export const kPanels: readonly Panel[] = [kGuide, kInstruments];
