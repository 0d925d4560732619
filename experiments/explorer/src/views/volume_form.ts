// SPDX-License-Identifier: GPL-3.0-or-later
//
// The form of the view volume: its sides, near and far, the convention of depth, what is clamped or
// left open, and clip distances.

import { kAttributes, kDepths, type Depth, type Frustum, type Volume } from '../engine';
import type { Page } from '../panel';
import { html } from '../panels/dom';
import { isInvertible } from '../projection';
import type { State } from '../state';
import { short, toStep } from '../floats';
import { numberField } from './number_field';

type Part = { element: HTMLElement; show: (state: State) => void };
type FrustumNumber = 'left' | 'right' | 'bottom' | 'top' | 'near' | 'far' | 'shearX' | 'shearY';

// Sliders of near and far have the powers of ten as their steps.
interface Scale { low: number; high: number; step: number; isLog: boolean }
const kSide: Scale = { low: -4, high: 4, step: 0.05, isLog: false };
const kScales: Record<FrustumNumber, Scale> = {
  left: kSide, right: kSide, bottom: kSide, top: kSide, shearX: kSide, shearY: kSide,
  near: { low: -3, high: 2, step: 0.05, isLog: true },
  far: { low: -1, high: 5, step: 0.05, isLog: true },
};

function toValue(scale: Scale, at: number): number {
  return scale.isLog ? Number((10 ** at).toPrecision(2)) : toStep(at, scale.step);
}

function changed(page: Page, change: Partial<Frustum>): boolean {
  const frustum = { ...page.store.state.frustum, ...change };
  if (!isInvertible(frustum)) return false;
  page.store.update({ frustum });
  return true;
}

const kExpected: Record<FrustumNumber, string> = {
  left: 'less than right', right: 'more than left', bottom: 'less than top',
  top: 'more than bottom', near: 'less than far, and more than 0 in perspective',
  far: 'more than near', shearX: 'a number', shearY: 'a number',
};

function frustumNumber(page: Page, name: FrustumNumber, label: string): Part {
  const scale = kScales[name];
  const change = (value: number) => changed(page, { [name]: value });
  const field = numberField(label, change, kExpected[name]);
  const slider = html('input', {
    type: 'range', min: scale.low, max: scale.high, step: scale.step,
    'aria-label': `${label}, slider`,
    input: () => {
      // Where the volume would turn inside out the slider goes back.
      if (!change(toValue(scale, Number(slider.value)))) show(page.store.state);
    },
  });
  const element = html('div', { class: 'row' }, html('span', {}, label), slider, field.element);
  const show = ({ frustum, scalar }: State) => {
    const value = frustum[name];
    field.show(value, scalar);
    const at = String(scale.isLog ? Math.log10(Math.max(value, 1e-30)) : value);
    if (toValue(scale, Number(slider.value)) !== value) slider.value = at;
    slider.setAttribute('aria-valuetext', short(value));
    const isOff = (name === 'far' && frustum.infiniteFar) ||
                  (name.startsWith('shear') && !frustum.parallel);
    slider.disabled = field.element.disabled = isOff;
    element.hidden = name.startsWith('shear') && !frustum.parallel;
  };
  return { element, show };
}

// `set` returns what forbids it, or nothing.
function check(page: Page, label: string, isOn: (state: State) => boolean,
               set: (on: boolean) => string, isOff: (state: State) => boolean = () => false): Part {
  const change = () => {
    input.setCustomValidity(set(input.checked));
    input.reportValidity();
    show(page.store.state);
  };
  const input = html('input', { type: 'checkbox', change });
  const element = html('label', { class: 'check' }, input, label);
  const show = (state: State) => {
    input.checked = isOn(state);
    input.disabled = isOff(state);
  };
  return { element, show };
}

function select<T extends string>(label: string, options: readonly (readonly [T, string])[],
                                  value: (state: State) => T, set: (value: T) => void): Part {
  const input = html('select', { 'aria-label': label, change: () => set(input.value as T) },
                     ...options.map(([own, text]) => html('option', { value: own }, text)));
  const element = html('label', { class: 'row' }, html('span', {}, label), input);
  return { element, show: (state) => { input.value = value(state); } };
}

const kDepthTexts: Record<Depth, string> = {
  minus_one_to_one: '\u22121 to 1 (OpenGL)', zero_to_one: '0 to 1 (Direct3D, Vulkan)',
  reversed: '1 to 0 (reversed)',
};

function setVolume(page: Page, change: Partial<Volume>): '' {
  page.store.update({ volume: { ...page.store.state.volume, ...change } });
  return '';
}

function depthParts(page: Page): Part[] {
  const counts = Array.from({ length: kAttributes + 1 }, (_, i) => [String(i), String(i)] as const);
  return [
    select<Depth>('depth', kDepths.map((d) => [d, kDepthTexts[d]] as const),
                  (s) => s.frustum.depth, (depth) => changed(page, { depth })),
    select('clip distances', counts, (s) => String(s.volume.clipDistances),
           (count) => setVolume(page, { clipDistances: Number(count) })),
    check(page, 'parallel projection', (s) => s.frustum.parallel, (parallel) =>
      changed(page, { parallel, infiniteFar: false }) ? ''
        : 'near must be more than 0 in perspective, and far more than near'),
    check(page, 'far plane at infinity', (s) => s.frustum.infiniteFar, (infiniteFar) =>
      changed(page, { infiniteFar }) ? '' : 'far must be more than near',
          (s) => s.frustum.parallel),
    check(page, 'clamp depth at near', (s) => s.volume.clampNear,
          (clampNear) => setVolume(page, { clampNear })),
    check(page, 'clamp depth at far', (s) => s.volume.clampFar,
          (clampFar) => setVolume(page, { clampFar })),
  ];
}

function openSides(page: Page): Part {
  const sides = ['left', 'right', 'bottom', 'top'] as const;
  const parts = sides.map((side) => check(page, side, (s) => s.volume.openSides[side], (on) =>
    setVolume(page, { openSides: { ...page.store.state.volume.openSides, [side]: on } })));
  const element = html('fieldset', { class: 'open_sides' }, html('legend', {}, 'half-open sides'),
                       ...parts.map((p) => p.element));
  return { element, show: (state) => { for (const part of parts) part.show(state); } };
}

export function volumeForm(page: Page): Part {
  const number = (name: FrustumNumber, label: string = name) => frustumNumber(page, name, label);
  const sizes = [number('left'), number('right'), number('bottom'), number('top'), number('near'),
                 number('far'), number('shearX', 'shear of x'), number('shearY', 'shear of y')];
  const rest = [...depthParts(page), openSides(page)];
  const element = html('div', { class: 'volume' },
    html('div', { class: 'sizes', role: 'group', 'aria-label': 'View volume' },
         ...sizes.map((p) => p.element)),
    html('div', { class: 'rest', role: 'group', 'aria-label': 'Depth and planes' },
         ...rest.map((p) => p.element)));
  const parts = [...sizes, ...rest];
  return { element, show: (state) => { for (const part of parts) part.show(state); } };
}
