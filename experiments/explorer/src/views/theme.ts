// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page's colours as a canvas needs them, and the switch between dark and light.

const kNames = ['paper', 'ink', 'faint', 'line', 'raised', 'input', 'volume', 'first', 'second',
                'exact', 'focus'] as const;
export type ColourName = (typeof kNames)[number];
export type Colours = Record<ColourName, string>;

type Listener = () => void;
const listeners: Listener[] = [];
const wishes = ['system', 'light', 'dark'] as const;
const dark = window.matchMedia('(prefers-color-scheme: dark)');
let wish: (typeof wishes)[number] = 'system';
let known: Colours | null = null;

export function colours(): Colours {
  return known ??= read();
}

export function onColours(listener: Listener) {
  listeners.push(listener);
}

function changed() {
  known = null;
  for (const listener of listeners) listener();
}

// The style sheet knows colours by what the reader has set; an element that uses one knows which.
function read(): Colours {
  const probe = document.createElement('span');
  document.body.append(probe);
  const entries = kNames.map((name) => {
    probe.style.color = `var(--${name})`;
    return [name, getComputedStyle(probe).color] as const;
  });
  probe.remove();
  return Object.fromEntries(entries) as Colours;
}

// Makes a button go through system, light and dark.
export function mountThemeSwitch(button: HTMLButtonElement) {
  const label = () => { button.textContent = `Colours: ${wish}`; };
  button.addEventListener('click', () => {
    wish = wishes[(wishes.indexOf(wish) + 1) % wishes.length]!;
    document.documentElement.style.colorScheme = wish === 'system' ? '' : wish;
    label();
    changed();
  });
  dark.addEventListener('change', changed);
  label();
}
