// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/views.mjs PAGE.html: a vertex that is dragged in one space, by pointer, finger or key,
// moves in the others as the mathematics says.
import assert from 'node:assert/strict';
import test from 'node:test';

import { frames, withPage } from './browser.mjs';
import {
  assertAgreement, assertClose, assertUnder, divided, drag, field, handle, kSpaces, middleOf,
  numbersOf, pictureOf, saidOf, textOf, toClip, write,
} from './hands.mjs';

const [file] = process.argv.slice(2);
assert.ok(file, 'usage: node tests/views.mjs PAGE.html');
const onPage = (body, options = {}) =>
  withPage(file, { fragment: '#v1&show=numbers', ...options }, body);

test('views: all three spaces show the triangle of the start', onPage(async (page) => {
  for (const letter of 'ABC') await assertAgreement(page, letter);
  for (const space of kSpaces) assert.ok(await handle(page, space, 'A').isVisible());
}));

for (const space of ['view', 'xyw', 'xw', 'yw', 'canonical']) {
  test(`views: a vertex dragged in ${space} stays under the pointer, the others follow`,
       onPage(async (page) => {
    const before = await Promise.all([...'ABC'].map((letter) => numbersOf(page, letter)));
    const pointer = await drag(page, space, 'B', -22, -17);
    assert.notDeepEqual(await numbersOf(page, 'B'), before[1]);
    await assertUnder(page, space, 'B', pointer);
    assert.deepEqual(await numbersOf(page, 'A'), before[0]);
    assert.deepEqual(await numbersOf(page, 'C'), before[2]);
    for (const letter of 'ABC') await assertAgreement(page, letter);
  }));
}

test('views: a drag in z-w stays on the line of view space', onPage(async (page) => {
  const [x, y, z] = await numbersOf(page, 'B');
  await drag(page, 'zw', 'B', -20, 0);
  const [newX, newY, newZ] = await numbersOf(page, 'B');
  assert.deepEqual([newX, newY], [x, y]); // near is 1: x and y are those of clip space
  assert.ok(newZ > z, `z went from ${z} to ${newZ}`);
  await assertAgreement(page, 'B');
}));

test('views: a drag after the divide keeps w to the last bit', onPage(async (page) => {
  await write(page, 'z', 'B', '-0x1.921fb6p+1');
  await drag(page, 'canonical', 'B', -31, 12);
  assert.equal(Math.fround((await numbersOf(page, 'B'))[2]), Math.fround(-3.1415927410125732));
}));

test('views: a drag through w = 0 goes on behind the eye', onPage(async (page) => {
  const scale = 12; // steps: a vertex is seen on its way
  const seen = [];
  for (let i = 0; i < scale; ++i) {
    await drag(page, 'xw', 'B', 0, 6);
    const [, , z] = await numbersOf(page, 'B');
    seen.push(-z);
    await assertAgreement(page, 'B');
  }
  assert.ok(seen[0] > 0 && seen.at(-1) < 0, `w was ${seen}`);
  assert.match(await textOf(page, 'canonical', 'B'), /behind the eye/);
}));

test('views: at w = 0 there is no point after the divide', onPage(async (page) => {
  await write(page, 'z', 'B', '0');
  assert.match(await textOf(page, 'canonical', 'B'), /at infinity/);
  assert.ok(!await handle(page, 'canonical', 'B').isVisible());
  await assertAgreement(page, 'B');
  await drag(page, 'view', 'B', 5, 9);
  await assertAgreement(page, 'A');
}));

test('views: with shift a vertex goes along the view axis', onPage(async (page) => {
  const before = await numbersOf(page, 'C');
  await drag(page, 'view', 'C', 3, -40, { key: 'Shift' });
  const after = await numbersOf(page, 'C');
  const yaw = 0.8, pitch = 0.3; // of the page when it is opened
  const flat = Math.cos(pitch);
  const axis = [-Math.sin(yaw) * flat, -Math.sin(pitch), -Math.cos(yaw) * flat];
  const moved = after.map((value, i) => value - before[i]);
  const length = Math.hypot(...moved);
  assert.ok(length > 0.5, `moved by ${moved}`);
  // Rounded to steps of a pixel, 1 / 40 of the way.
  moved.forEach((value, i) => assert.ok(Math.abs(value / length - axis[i]) < 0.05, `${moved}`));
}));

test('views: a vertex does not jump when shift is let go', onPage(async (page) => {
  const { x, y } = await middleOf(handle(page, 'view', 'C'));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.keyboard.down('Shift');
  await page.mouse.move(x, y - 60, { steps: 6 });
  await frames(page);
  const before = await numbersOf(page, 'C');
  await page.keyboard.up('Shift');
  await page.mouse.move(x + 1, y - 60);
  await frames(page);
  await page.mouse.up();
  const moved = (await numbersOf(page, 'C')).map((value, i) => value - before[i]);
  assert.ok(Math.hypot(...moved) < 0.2, `moved by ${moved}`); // a pixel is 0.05 there
}));

test('views: dragged numbers are short, with alt they are not rounded', onPage(async (page) => {
  await drag(page, 'view', 'A', 33, 21);
  const texts = async () => Promise.all([...'xyz'].map((n) => field(page, n, 'A').inputValue()));
  for (const text of await texts()) assert.ok(text.length <= 5, text);
  await drag(page, 'view', 'A', 10, 4, { key: 'Alt' });
  assert.ok((await texts()).some((text) => text.length > 8), String(await texts()));
}));

test('numbers: the triangle is converted once and back to the same floats', onPage(async (page) => {
  const view = await Promise.all([...'ABC'].map((letter) => numbersOf(page, letter)));
  await page.getByText('clip space', { exact: true }).click();
  await frames(page);
  for (const [i, letter] of [...'ABC'].entries()) {
    const clip = toClip(view[i]);
    (await numbersOf(page, letter, 'xyzw')).forEach((value, k) =>
      assert.ok(Math.abs(value - clip[k]) <= 2 ** -21 * Math.abs(clip[k]) , `${value}, ${clip}`));
  }
  await page.getByText('view space', { exact: true }).click();
  await frames(page);
  const back = await Promise.all([...'ABC'].map((letter) => numbersOf(page, letter)));
  assert.deepEqual(back, view);
}));

test('views: in clip space all four numbers are free', onPage(async (page) => {
  await page.getByText('clip space', { exact: true }).click();
  await frames(page);
  const before = await numbersOf(page, 'C', 'xyzw');
  await drag(page, 'zw', 'C', -30, 0);
  const after = await numbersOf(page, 'C', 'xyzw');
  assert.ok(after[2] < before[2]);
  assert.deepEqual([after[0], after[1], after[3]], [before[0], before[1], before[3]]);
  for (const space of ['xyw', 'zw']) assertClose(await saidOf(page, space, 'C'), after);
  assertClose(await saidOf(page, 'canonical', 'C'), divided(after));
  await page.getByText(/are of no point in this view space/).waitFor();
}));

test('views: in clip space a drag in view space keeps what z has of its own', onPage(async (page) => {
  await page.getByText('clip space', { exact: true }).click();
  await frames(page);
  const own = async () => {
    const [x, y, z, w] = await numbersOf(page, 'B', 'xyzw');
    return z - toClip([x, y, -w])[2];
  };
  await write(page, 'z', 'B', '1');
  const before = await own();
  assert.ok(Math.abs(before) > 1);
  const pointer = await drag(page, 'view', 'B', -25, -30);
  await assertUnder(page, 'view', 'B', pointer);
  assert.ok(Math.abs(await own() - before) < 0.1, `${before} became ${await own()}`); // 2 pixels
  const [x, y, z, w] = await numbersOf(page, 'B', 'xyzw');
  assertClose(await saidOf(page, 'view', 'B'), [x, y, -w]);
  assertClose(await saidOf(page, 'canonical', 'B'), divided([x, y, z, w]));
}));

test('views: keys move a vertex by steps and by ulps', onPage(async (page) => {
  const key = async (space, letter, name) => {
    await handle(page, space, letter).focus();
    await page.keyboard.press(name);
    await frames(page);
    return numbersOf(page, letter);
  };
  const [x, y, z] = await numbersOf(page, 'C');
  const [upX, upY, upZ] = await key('view', 'C', 'ArrowUp');
  assert.deepEqual([upX, upZ], [x, z]);
  assert.ok(upY > y);
  assert.deepEqual(await key('view', 'C', 'ArrowDown'), [x, y, z]);
  const moved = await key('xw', 'C', 'ArrowRight');
  assert.ok(moved[0] > x && moved[2] === z);
  await assertAgreement(page, 'C');
  const [, before] = await numbersOf(page, 'C');
  const [, fine] = await key('yw', 'C', 'Shift+ArrowRight');
  assert.equal(Math.fround(fine), 5 + 2 ** -21); // the float after 5
  assert.equal(before, 5);
}));

test('views: a plot turns and zooms without moving the triangle', onPage(async (page) => {
  const before = await numbersOf(page, 'A');
  const canvas = page.locator('[data-space=view] canvas');
  const start = await middleOf(handle(page, 'view', 'B'));
  const { x, y } = await middleOf(canvas);
  await page.mouse.move(x + 100, y + 150);
  await page.mouse.down();
  await page.mouse.move(x + 160, y + 130, { steps: 5 });
  await page.mouse.up();
  await frames(page);
  const turned = await middleOf(handle(page, 'view', 'B'));
  assert.ok(Math.hypot(turned.x - start.x, turned.y - start.y) > 10);
  await page.mouse.wheel(0, -300);
  await frames(page);
  const zoomed = await middleOf(handle(page, 'view', 'B'));
  assert.ok(Math.hypot(zoomed.x - turned.x, zoomed.y - turned.y) > 3);
  await page.mouse.dblclick(x + 150, y + 150);
  await frames(page);
  const fitted = await middleOf(handle(page, 'view', 'B'));
  assert.ok(Math.hypot(fitted.x - start.x, fitted.y - start.y) < 1);
  assert.deepEqual(await numbersOf(page, 'A'), before);
}));

test('views: what is turned stays so when the window changes its size', onPage(async (page) => {
  const { x, y } = await middleOf(page.locator('[data-space=canonical] canvas'));
  const fitted = await middleOf(handle(page, 'canonical', 'C'));
  await page.mouse.move(x, y + 120);
  await page.mouse.down();
  await page.mouse.move(x + 70, y + 120, { steps: 4 });
  await page.mouse.up();
  await frames(page);
  const turned = await middleOf(handle(page, 'canonical', 'C'));
  await page.setViewportSize({ width: 1300, height: 800 });
  await frames(page);
  await page.setViewportSize({ width: 1400, height: 900 });
  await frames(page);
  await assertUnder(page, 'canonical', 'C', turned, 1);
  assert.ok(Math.hypot(fitted.x - turned.x, fitted.y - turned.y) > 10);
}));

test('numbers: a switch that would leave no volume goes back and says why', onPage(async (page) => {
  const parallel = page.getByLabel('parallel projection', { exact: true });
  await parallel.check();
  await page.getByLabel('near', { exact: true }).fill('0');
  await page.keyboard.press('Enter');
  await parallel.click();
  await frames(page);
  assert.ok(await parallel.isChecked());
  assert.match(await parallel.evaluate((input) => input.validationMessage), /more than 0/);
}));

test('numbers: a field takes hex floats and says what is wrong', onPage(async (page) => {
  await write(page, 'x', 'A', '-0x1.8p+1');
  assert.deepEqual((await numbersOf(page, 'A'))[0], -3);
  await write(page, 'x', 'A', 'three');
  const message = await field(page, 'x', 'A').evaluate((input) => input.validationMessage);
  assert.match(message, /'three' is no number/);
  assertClose(await saidOf(page, 'view', 'A'), [-3, -2, -5]);
  await page.getByLabel('near', { exact: true }).fill('20');
  await page.getByLabel('near', { exact: true }).press('Enter');
  assert.match(await page.getByLabel('near', { exact: true }).evaluate((i) => i.validationMessage),
               /must be less than far/);
}));

for (const depth of ['zero_to_one', 'reversed']) {
  test(`views: the convention ${depth} gives its depths`, onPage(async (page) => {
    await page.getByLabel('depth', { exact: true }).selectOption(depth);
    await frames(page);
    for (const letter of 'ABC') await assertAgreement(page, letter, depth);
    await drag(page, 'canonical', 'A', 14, 9);
    await assertAgreement(page, 'A', depth);
  }));
}

test('views: any number is drawn without an error', onPage(async (page) => {
  for (const text of ['1e30', '-1e30', '1e-40', '-0', '3e38', '0x1p-1074', '1e300']) {
    await write(page, 'x', 'B', text);
    await write(page, 'z', 'B', text);
    for (const space of kSpaces) {
      const style = await handle(page, space, 'B').getAttribute('style');
      assert.doesNotMatch(style, /NaN|Infinity/);
    }
  }
  for (const box of ['far plane at infinity', 'clamp depth at near', 'parallel projection']) {
    await page.getByLabel(box, { exact: true }).check();
    await frames(page);
  }
}));

// Volumes of all kinds, triangles in both spaces.
const kLinks = [
  '#v1&show=numbers&depth=reversed&frustum=-1,1,-1,1,0.1,inf&a=-3,-1,-10&b=5,-1,2&c=0,2,-8',
  '#v1&show=numbers&ortho=-2,2,-1.5,1.5,0,6&shear=0.2,-0.1&a=-3,-1,-1&b=2.5,-1,-4&c=0,2,-8',
  '#v1&show=numbers&space=clip&a=-2,0,0,3&b=4,0,0,-3&c=-2,0.5,0,0',
];

for (const [number, fragment] of kLinks.entries()) {
  test(`views: any drag gives finite numbers, volume ${number}`, onPage(async (page) => {
    let seed = 7 + number;
    const random = (size) => {
      seed = (1103515245 * seed + 12345) % 2 ** 31;
      return seed / 2 ** 31 * size;
    };
    const names = fragment.includes('space=clip') ? 'xyzw' : 'xyz';
    const start = await Promise.all([...'ABC'].map((letter) => numbersOf(page, letter, names)));
    for (let i = 0; i < 18; ++i) {
      const space = kSpaces[i % 6], letter = 'ABC'[Math.floor(random(3))];
      if (!await handle(page, space, letter).isVisible()) continue;
      const key = [null, 'Shift', 'Alt'][Math.floor(random(3))];
      await drag(page, space, letter, random(160) - 80, random(160) - 80, { steps: 3, key });
    }
    const end = await Promise.all([...'ABC'].map((letter) => numbersOf(page, letter, names)));
    assert.ok(end.flat().every((value) => Number.isFinite(value)), `${end}`);
    end.forEach((numbers, i) => assert.notDeepEqual(numbers, start[i]));
  }, { fragment }));
}

test('views: every layer can be put out', onPage(async (page) => {
  for (const layer of ['input', 'step', 'first', 'second', 'exact']) {
    const before = await pictureOf(page, 'canonical');
    await page.locator(`[data-layer=${layer}]`).click();
    await frames(page);
    assert.notEqual(await pictureOf(page, 'canonical'), before, `${layer} is not drawn`);
    assert.equal(await page.locator(`[data-layer=${layer}]`).getAttribute('aria-pressed'), 'false');
  }
}));

test('views: dark and light have their own colours, in pictures as well', async () => {
  const pictures = [], papers = [];
  for (const colorScheme of ['light', 'dark']) {
    await onPage(async (page) => {
      const paper = () =>
        page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      pictures.push(await pictureOf(page, 'view'));
      papers.push(await paper());
      await page.locator('#theme').click(); // light
      await page.locator('#theme').click(); // dark
      await frames(page);
      assert.equal(await paper(), 'rgb(20, 23, 26)');
    }, { colorScheme })();
  }
  assert.notEqual(pictures[0], pictures[1]);
  assert.notEqual(papers[0], papers[1]);
});

test('views: two fingers zoom', onPage(async (page) => {
  const { x, y } = await middleOf(page.locator('[data-space=view] canvas'));
  const touch = await page.context().newCDPSession(page);
  const send = (type, ...points) => touch.send('Input.dispatchTouchEvent', {
    type, touchPoints: points.map(([dx, dy], id) => ({ x: x + dx, y: y + dy, id })) });
  const apart = async () => {
    const [a, b] = await Promise.all([...'BC'].map((l) => middleOf(handle(page, 'view', l))));
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  const before = await apart();
  await send('touchStart', [-60, 120]);
  await send('touchStart', [-60, 120], [60, 120]);
  await send('touchMove', [-90, 120], [90, 120]);
  await send('touchEnd');
  await frames(page);
  const ratio = await apart() / before;
  assert.ok(Math.abs(ratio - 1.5) < 0.1, `the picture grew by ${ratio}`);
}, { hasTouch: true }));

test('views: the keyboard reaches every vertex, and what is behind the views at once',
     onPage(async (page) => {
  const focused = () => page.evaluate(() => document.activeElement.getAttribute('aria-label') ??
                                            document.activeElement.id);
  await page.keyboard.press('Tab');
  assert.equal(await focused(), 'skip');
  const seen = new Set();
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press('Tab');
    seen.add(await focused());
  }
  const names = ['view space', 'clip space, x y w', 'clip space, x and w', 'clip space, y and w',
                 'clip space, z and w', 'the canonical view volume'];
  for (const name of names) {
    for (const letter of 'ABC') assert.ok(seen.has(`${letter} in ${name}`), `${letter}, ${name}`);
  }
  await page.locator('#skip').focus();
  await page.keyboard.press('Enter');
  assert.equal(await focused(), 'panels');
  assert.equal(await page.locator('#link-error').count(), 0);
}));

test('numbers: an attribute that is a clip distance cuts', onPage(async (page) => {
  await page.getByLabel('clip distances', { exact: true }).selectOption('1');
  await page.getByText('Attributes', { exact: true }).click();
  for (const letter of 'ABC') {
    await page.getByLabel(`attribute 0 of ${letter}`, { exact: true }).fill('-1');
    await page.keyboard.press('Enter');
  }
  await page.getByText('exact: 0 vertices').waitFor();
  await page.getByText(/A is outside clip distance 0/).waitFor();
}));

test('views: a phone shows one space, keeps it in sight and takes fingers', onPage(async (page) => {
  for (const space of ['clip_space', 'canonical_volume', 'view_space']) {
    await page.locator(`#tabs label:has([value=${space}])`).tap();
    await frames(page);
    for (const other of ['view_space', 'clip_space', 'canonical_volume']) {
      assert.equal(await page.locator(`#${other}`).isVisible(), other === space);
    }
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  }
  const before = await numbersOf(page, 'B');
  const { x, y } = await middleOf(handle(page, 'view', 'B'));
  const touch = await page.context().newCDPSession(page);
  const send = (type, touchPoints) =>
    touch.send('Input.dispatchTouchEvent', { type, touchPoints });
  await send('touchStart', [{ x, y }]);
  for (let i = 1; i <= 6; ++i) await send('touchMove', [{ x: x - 5 * i, y: y - 4 * i }]);
  await send('touchEnd', []);
  await frames(page);
  assert.notDeepEqual(await numbersOf(page, 'B'), before);
  await assertUnder(page, 'view', 'B', { x: x - 30, y: y - 24 });
  await page.evaluate(() => window.scrollTo(0, 10000));
  await frames(page);
  assert.ok((await page.locator('#view_space .plot').boundingBox()).y >= 0);
}, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }));
