// SPDX-License-Identifier: GPL-3.0-or-later
//
// The panels below the views in two groups: what guides the reader, and what looks at the triangle.

import { kLessonSource } from '../lessons/lessons';
import type { Panel } from '../panel';
import type { Scene } from '../scene';
import { kNumbers } from '../views/numbers';
import { kAttributesPanel } from './attributes';
import { kCasesPanel } from './cases';
import { kClippersPanel } from './clippers';
import { kDepthPanel } from './depth';
import { kDigitsPanel } from './digits';
import { kMagnifierPanel } from './magnifier';
import { kOutcodesPanel } from './outcodes';
import { kSharePanel } from './share';
import { kStepsPanel } from './steps';
import { tabbed } from './tabs';
import type { TabChoice } from './tabs';
import { kTourPanel } from './tour';

// The tour, unless a case was opened or the reader chose otherwise.
function guideChoice(): TabChoice {
  let open = kTourPanel.id;
  let source = '';
  return {
    of: ({ state }: Scene) => {
      if (state.source !== source) {
        source = state.source;
        if (source !== '') open = source.startsWith(kLessonSource) ? kTourPanel.id : kCasesPanel.id;
      }
      return open;
    },
    choose: ({ store }, id) => {
      open = id;
      store.update({});
    },
  };
}

export const kInstrumentPanels: readonly Panel[] = [
  kNumbers, kClippersPanel, kOutcodesPanel, kStepsPanel, kDigitsPanel, kMagnifierPanel,
  kAttributesPanel, kDepthPanel, kSharePanel,
];

export const kGuide: Panel =
  tabbed('guide', 'Guide', [kTourPanel, kCasesPanel], guideChoice());
export const kInstruments: Panel = tabbed('instruments', 'Instruments', kInstrumentPanels, {
  of: ({ state }) => state.instrument,
  choose: ({ store }, id) => store.update({ instrument: id }),
});
