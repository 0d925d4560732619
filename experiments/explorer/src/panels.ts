// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the page in the order in which they stand there.

import type { Panel } from './panel';
import { kGuide, kInstruments } from './panels/groups';
import { kLegend } from './views/legend';
import { kSpaces, kTabs } from './views/spaces';
import { kWords } from './views/words';

// The three spaces side by side, their legend above them and the scene in words below.
export const kViews: readonly Panel[] = [kTabs, kLegend, ...kSpaces, kWords];

// Below them.
export const kPanels: readonly Panel[] = [kGuide, kInstruments];
