// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the page says of its vertices, what the mathematics says of them, and hands that drag them.
import assert from 'node:assert/strict';

import { frames } from './browser.mjs';

export const kSpaces = ['view', 'xyw', 'xw', 'yw', 'zw', 'canonical'];
const near = 1, far = 10; // of the page when it is opened; its sides are at -1 and 1
const kDepthNames = { minus_one_to_one: [-1, 1], zero_to_one: [0, 1], reversed: [1, 0] };

// --- What the page says -------------------------------------------------------------------------

export const handle = (page, space, letter) => page.locator(`[data-space=${space}] .vertex`)
  .nth('ABC'.indexOf(letter));
export const field = (page, name, letter) => page.getByLabel(`${name} of ${letter}`, { exact: true });

export async function numbersOf(page, letter, names = 'xyz') {
  const texts = await Promise.all([...names].map((n) => field(page, n, letter).inputValue()));
  return texts.map(Number);
}

export const pictureOf = (page, space) => page.locator(`[data-space=${space}] canvas`)
  .evaluate((canvas) => canvas.toDataURL());

export async function write(page, name, letter, text) {
  await field(page, name, letter).fill(text);
  await field(page, name, letter).press('Enter');
  await frames(page);
}

export const textOf = (page, space, letter) =>
  handle(page, space, letter).getAttribute('aria-valuetext');

// The coordinates that a space says of a vertex, with four digits.
export async function saidOf(page, space, letter) {
  const text = await textOf(page, space, letter);
  return [...text.matchAll(/([xyzw]) (\u2212?[\d.e+\u2212]+)/g)]
    .map(([, , digits]) => Number(digits.replaceAll('\u2212', '-')));
}

export function assertClose(said, expected) {
  assert.equal(said.length, expected.length);
  expected.forEach((value, i) => {
    // Four digits are said; floats of the clippers have seven.
    assert.ok(Math.abs(said[i] - value) <= 6e-4 * Math.abs(value) + 1e-6,
              `said ${said}, expected ${expected}`);
  });
}

// --- The mathematics ----------------------------------------------------------------------------

export function toClip([x, y, z], depth = 'minus_one_to_one') {
  const [low, high] = kDepthNames[depth];
  // In [0, 1] at first: far (-z - near) / (far - near).
  const unit = far * (-z - near) / (far - near);
  return [near * x, near * y, low * -z + (high - low) * unit, -z];
}

export const divided = ([x, y, z, w]) => [x / w, y / w, z / w];

export async function assertAgreement(page, letter, depth) {
  const view = await numbersOf(page, letter);
  const clip = toClip(view, depth);
  assertClose(await saidOf(page, 'view', letter), view);
  for (const space of ['xyw', 'xw', 'yw', 'zw']) {
    assertClose(await saidOf(page, space, letter), clip);
  }
  if (clip[3] !== 0) assertClose(await saidOf(page, 'canonical', letter), divided(clip));
}

// --- Hands --------------------------------------------------------------------------------------

export async function middleOf(locator) {
  const { x, y, width, height } = await locator.boundingBox();
  return { x: x + width / 2, y: y + height / 2 };
}

export async function drag(page, space, letter, dx, dy, { steps = 8, key = null } = {}) {
  const from = await middleOf(handle(page, space, letter));
  if (key !== null) await page.keyboard.down(key);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + dx, from.y + dy, { steps });
  await page.mouse.up();
  if (key !== null) await page.keyboard.up(key);
  await frames(page);
  return { x: from.x + dx, y: from.y + dy };
}

export async function assertUnder(page, space, letter, pointer, pixels = 3) {
  const at = await middleOf(handle(page, space, letter));
  assert.ok(Math.hypot(at.x - pointer.x, at.y - pointer.y) <= pixels,
            `${letter} is at ${at.x}, ${at.y}, the pointer at ${pointer.x}, ${pointer.y}`);
}
