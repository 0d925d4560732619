// SPDX-License-Identifier: GPL-3.0-or-later
//
// A field for one number, decimal or hex float, which says what is wrong with what was typed.

import type { Scalar } from '../engine';
import { shortest } from '../floats';
import { hexFloat, parseNumber } from '../number_text';
import { html } from '../panels/dom';

export interface NumberField {
  element: HTMLInputElement;
  show: (value: number, scalar: Scalar) => void;
}

// `change` takes a finite number and says whether it may be; `expected` is told where it may not.
export function numberField(label: string, change: (value: number) => boolean,
                            expected = 'a number'): NumberField {
  let shown = '';
  const complain = (message: string) => {
    element.setCustomValidity(message);
    element.toggleAttribute('aria-invalid', message !== '');
    if (message !== '') element.reportValidity();
  };
  const read = () => {
    if (element.value === shown) { complain(''); return; }
    const value = parseNumber(element.value);
    if (value === null) complain(`'${element.value}' is no number; write 0.1, 1e-5 or 0x1.8p-3`);
    else if (!Number.isFinite(value)) complain(`'${element.value}' is too large for a double`);
    else if (!change(value)) complain(`${label} is ${element.value}; it must be ${expected}`);
    else complain('');
  };
  const element = html('input', {
    type: 'text', inputmode: 'decimal', autocomplete: 'off', spellcheck: 'false', size: 9,
    'aria-label': label, change: read,
    input: () => complain(''),
    keydown: (event: Event) => {
      if ((event as KeyboardEvent).key !== 'Escape') return;
      element.value = shown;
      complain('');
    },
  });
  const show = (value: number, scalar: Scalar) => {
    const text = shortest(scalar, value);
    if (text === shown && element.value === shown) return;
    // What is being typed stays.
    const isTyped = element === document.activeElement && element.value !== shown;
    shown = text;
    if (isTyped && parseNumber(element.value) !== value) return;
    element.value = text;
    element.title = hexFloat(value);
  };
  return { element, show };
}
