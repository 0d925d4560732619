// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/panels.mjs PAGE.html: the panels below the views, by real clicks and keys: every lesson
// is done, every hard case is opened, and nothing goes wrong on the page.
import assert from 'node:assert/strict';
import test from 'node:test';

import { frames, open, withPage } from './browser.mjs';

const [file] = process.argv.slice(2);
assert.ok(file, 'usage: node tests/panels.mjs PAGE.html');
const onPage = (body, options = {}) => withPage(file, options, body);

const kPanels = ['numbers', 'clippers', 'outcodes', 'steps', 'digits', 'magnifier', 'attributes', 'depth', 'share'];
const kPhone = { viewport: { width: 390, height: 844 }, hasTouch: true, colorScheme: 'dark' };

async function click(page, locator) {
  await (typeof locator === 'string' ? page.locator(locator) : locator).click();
  await frames(page);
}
const openPanel = (page, id) => click(page, `#${id}-tab`);
const named = (page, panel, name) =>
  page.locator(`#${panel}`).getByRole('button', { name, exact: true });
const textOf = (page, selector) => page.locator(selector).innerText();
const rowsOf = (page, panel) => page.locator(`#${panel} tbody tr`).evaluateAll((rows) =>
  rows.map((row) => [...row.cells].map((cell) => cell.innerText.trim())));

async function choose(page, label, clipper) {
  await openPanel(page, 'clippers');
  await page.getByLabel(label, { exact: true }).selectOption(clipper);
  await frames(page);
}

// Then the panel that was open is open again.
async function write(page, name, letter, text) {
  const open = await page.locator('#instruments [role=tab][aria-selected=true]').getAttribute('id');
  await openPanel(page, 'numbers');
  const field = page.getByLabel(`${name} of ${letter}`, { exact: true });
  await field.fill(text);
  await field.press('Enter');
  await frames(page);
  await click(page, `#${open}`);
}

// The address follows the state within half a second.
async function fragmentOf(page) {
  await page.waitForTimeout(600);
  return page.evaluate(() => location.hash);
}

// --- The tour -----------------------------------------------------------------------------------

// What the reader is asked to do, by the page's own fields and buttons.
const kTasks = [
  (page) => write(page, 'x', 'B', '1'),
  async (page) => {
    for (const [name, value] of [['x', '-2'], ['y', '-2'], ['z', '1'], ['w', '4']]) {
      await write(page, name, 'A', value);
    }
  },
  (page) => write(page, 'x', 'A', '3'),
  (page) => choose(page, 'First', 'cvv/perspective'),
  (page) => write(page, 'z', 'C', '-2'),
  async (page) => {
    await click(page, named(page, 'steps', 'near last'));
    for (let i = 0; i < 6; ++i) await click(page, named(page, 'steps', 'Next ▶'));
  },
  (page) => choose(page, 'First', 'homogeneous/w_first_0'),
  (page) => write(page, 'z', 'C', '-1.4'),
  (page) => click(page, named(page, 'digits', 'Walk round the other way')),
  (page) => click(page, named(page, 'magnifier', 'single ulps')),
];

test('every lesson is done as it says, and notices it', onPage(async (page) => {
  for (const [i, act] of kTasks.entries()) {
    await click(page, '[data-lesson=next]');
    assert.match(await textOf(page, '#tour h3'), new RegExp(`^${i + 1}\\. `));
    assert.match(await textOf(page, '#tour .task'), /^Try it: /, `lesson ${i + 1} at its start`);
    await act(page);
    assert.match(await textOf(page, '#tour .task'), /^✓ /, `lesson ${i + 1}`);
  }
  assert.ok(await page.locator('[data-lesson=next]').isDisabled());
  await click(page, '#tour summary');
  assert.equal(await page.locator('.lessons .done').count(), kTasks.length);
  await click(page, '[data-lesson=before]');
  assert.match(await textOf(page, '#tour h3'), /^9\. /);
  await click(page, page.getByRole('button', { name: '↺ Start again' }));
  assert.match(await textOf(page, '#tour .task'), /^Try it: /);
}));

// --- Hard cases ---------------------------------------------------------------------------------

test('every hard case opens, in all panels without an error', onPage(async (page) => {
  await openPanel(page, 'cases');
  const cases = page.locator('#cases .case');
  const count = await cases.count();
  assert.ok(count > 100, `${count} cases`);
  for (let i = 0; i < count; ++i) {
    await openPanel(page, kPanels[i % kPanels.length]);
    await cases.nth(i).click();
    await frames(page);
    const name = await cases.nth(i).locator('strong').innerText();
    assert.ok((await textOf(page, '#cases .verdict')).startsWith(name), name);
  }
}));

test('the search keeps the cases that have all its words', onPage(async (page) => {
  await openPanel(page, 'cases');
  const shown = () => page.locator('#cases .case:visible strong').allInnerTexts();
  const all = (await shown()).length;
  await page.getByLabel('Search').fill('two_behind W_SIGN');
  assert.deepEqual(await shown(), ['w_sign/two_behind']);
  await page.getByLabel('Search').fill('nothing has this');
  assert.deepEqual(await shown(), []);
  assert.match(await textOf(page, '#cases .note'), /^0 cases of /);
  await page.getByLabel('Search').fill('');
  assert.equal((await shown()).length, all);
}));

// --- Instruments --------------------------------------------------------------------------------

test('clippers: both answers are judged, also after an exchange and in double', onPage(async (page) => {
  await choose(page, 'First', 'whole/any_outside');
  await choose(page, 'Second', 'barycentric/correctly_rounded');
  const rows = await rowsOf(page, 'clippers');
  assert.equal(rows[0][0], 'whole/any_outside');
  assert.match(rows[0][2], /^missing/);
  assert.match(rows[1][2], /^exact: each coordinate is the nearest/);
  await click(page, named(page, 'clippers', '⇄ Exchange'));
  assert.deepEqual(await rowsOf(page, 'clippers'), [rows[1], rows[0], rows[2]]);
  await page.getByLabel('double', { exact: true }).check();
  assert.match((await rowsOf(page, 'clippers'))[0][2], /^not applicable/);
}));

test('outcodes: the table has every plane, and its verdict follows the vertices', onPage(async (page) => {
  await openPanel(page, 'outcodes');
  for (const letter of 'ABC') {
    await write(page, 'x', letter, '0');
    await write(page, 'y', letter, '0');
    await write(page, 'z', letter, '-5');
  }
  assert.match(await textOf(page, '#outcodes .verdict'), /^No bit is set/);
  for (const letter of 'ABC') await write(page, 'x', letter, '9');
  assert.match(await textOf(page, '#outcodes .verdict'), /outside of the right plane/);
  const rows = await rowsOf(page, 'outcodes');
  assert.deepEqual(rows.map((row) => row[0]), ['A', 'B', 'C', 'any', 'all']);
  assert.deepEqual(rows[4].slice(1), ['·', '1', '·', '·', '·', '·', '000010']);
  assert.equal(Number(rows[0][2].match(/[\d.]+/)[0]), 4);
}));

const stepText = (page) => textOf(page, '#steps .verdict');
const orderOf = (page) => page.locator('.chip span').allInnerTexts();

test('steps: forwards, back and by itself, in an order that keys, buttons and drags change',
  onPage(async (page) => {
    await openPanel(page, 'steps');
    await click(page, named(page, 'steps', 'Before the first cut'));
    assert.match(await stepText(page), /^Before the first cut/);
    await click(page, named(page, 'steps', 'Next ▶'));
    assert.match(await stepText(page), /^Step 1 of 6: the near plane/);
    await page.keyboard.press(']');
    await frames(page);
    assert.match(await stepText(page), /^Step 2 of 6/);
    await page.keyboard.press('[');
    await frames(page);
    assert.match(await stepText(page), /^Step 1 of 6/);

    await click(page, named(page, 'steps', 'near last'));
    assert.deepEqual(await orderOf(page), ['left', 'right', 'bottom', 'top', 'far', 'near']);
    await page.locator('[data-plane="1"]').focus();
    await page.keyboard.press('Shift+ArrowLeft');
    await frames(page);
    assert.deepEqual((await orderOf(page)).slice(0, 2), ['right', 'left']);
    assert.equal(await page.evaluate(() => document.activeElement.dataset.plane), '1');
    await click(page, named(page, 'steps', 'right: later'));
    assert.deepEqual((await orderOf(page)).slice(0, 2), ['left', 'right']);
    await page.locator('.chips li').nth(5).dragTo(page.locator('.chips li').nth(0));
    await frames(page);
    assert.equal((await orderOf(page))[0], 'near');

    await click(page, named(page, 'steps', '▶ Play'));
    await page.waitForFunction(() =>
      document.querySelector('#steps .verdict').textContent.startsWith('Step 6'), null, { timeout: 15000 });
    await page.waitForFunction(() =>
      [...document.querySelectorAll('#steps button')].some((b) => b.textContent === '▶ Play'));
  }));

test('digits: the first wrong digit of a naive answer is marked, that of the exact value is not there',
  onPage(async (page) => {
    await choose(page, 'First', 'textbook');
    await choose(page, 'Second', 'barycentric/correctly_rounded');
    await openPanel(page, 'digits');
    assert.ok(await page.locator('#digits mark').count() > 0);
    const rows = await rowsOf(page, 'digits');
    assert.deepEqual(rows.map((row) => row[0]), ['x', 'y', 'z', '1/w', 'a0', 'a1', 'a2', 'a3']);
    for (const row of rows) assert.ok(Number(row[4]) <= 0.5, row.join(' '));
    await page.getByLabel('with hex floats').check();
    assert.match((await rowsOf(page, 'digits'))[0][1], /-?0x1?/);
  }));

test('magnifier: from the whole screen to a grid of ulps', onPage(async (page) => {
  await openPanel(page, 'magnifier');
  assert.equal(await page.locator('.magnifier .grid line').count(), 0);
  await click(page, named(page, 'magnifier', 'single ulps'));
  assert.ok(await page.locator('.magnifier .grid line').count() > 4);
  assert.equal(await page.locator('.magnifier .cell').count(), 1);
  assert.match(await textOf(page, '#magnifier .verdict'), /ulps of x/);
  await page.getByLabel('Zoom', { exact: true }).fill('0');
  await frames(page);
  assert.match(await textOf(page, '#magnifier .verdict'), /4\.4 wide in NDC/);
}));

test('attributes: boards are drawn, and moving the triangle changes them', onPage(async (page) => {
  await openPanel(page, 'attributes');
  const pictures = () => page.locator('#attributes canvas').evaluateAll((all) =>
    all.map((canvas) => canvas.toDataURL()));
  const before = await pictures();
  assert.equal(new Set(before).size, 3);
  await write(page, 'z', 'C', '-2');
  const after = await pictures();
  after.forEach((picture, i) => assert.notEqual(picture, before[i]));
  await page.getByLabel('exact answer').check();
  assert.match(await textOf(page, '#attributes .verdict'), /^w_max \/ w_min = /);
}));

test('depth: a curve for each buffer, and the vertices in numbers', onPage(async (page) => {
  await openPanel(page, 'depth');
  assert.equal(await page.locator('#depth .curve').count(), 7);
  assert.ok(await page.locator('#depth .marks text').count() >= 2);
  await click(page, '#depth summary');
  assert.deepEqual((await rowsOf(page, 'depth')).map((row) => row[0]), ['A', 'B', 'C']);
}));

test('copy: the clipboard gets what is shown, and the page says so', onPage(async (page) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await openPanel(page, 'share');
  for (const kind of ['link', 'clipscope explain', 'case of the corpus', 'C++']) {
    await page.getByLabel(kind, { exact: true }).check();
    await frames(page);
    await click(page, named(page, 'share', 'Copy'));
    assert.equal(await textOf(page, '#share .feedback'), 'Copied.');
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    assert.equal(copied, await page.locator('#share pre').evaluate((pre) => pre.textContent));
  }
}));

// --- Links --------------------------------------------------------------------------------------

test('a link shows the same page', onPage(async (page) => {
  await click(page, '[data-lesson=next]');
  await choose(page, 'Second', 'textbook');
  await write(page, 'x', 'B', '0.1');
  await openPanel(page, 'outcodes');
  const fragment = await fragmentOf(page);
  assert.match(fragment, /^#v1&/);
  const again = await open(file, { fragment });
  assert.deepEqual(await rowsOf(again.page, 'outcodes'), await rowsOf(page, 'outcodes'));
  assert.equal(await again.page.getByLabel('Second', { exact: true }).inputValue(), 'textbook');
  assert.equal(await fragmentOf(again.page), fragment);
  assert.deepEqual(again.errors, []);
  await again.close();
}));

test('what is wrong in a link is said, and the next good link takes it away', onPage(async (page) => {
  assert.match(await textOf(page, '[role=alert]'), /space: 'ndc' was given; expected view or clip/);
  await page.evaluate(() => { location.hash = '#v1&show=depth'; });
  await page.waitForSelector('[role=alert]', { state: 'detached' });
  await page.waitForSelector('#depth:visible');
}, { fragment: '#v1&space=ndc' }));

// --- Without a mouse, on a phone, in little room ------------------------------------------------

test('shortcuts do what the help says', onPage(async (page) => {
  await page.keyboard.press('?');
  const keys = await page.locator('dialog kbd').allInnerTexts();
  for (const key of ['?', '1', '9', '[', ']', 'x', 'f', 'n', 'p', 'l']) assert.ok(keys.includes(key), key);
  await page.keyboard.press('Escape');
  for (const [i, id] of kPanels.entries()) {
    await page.keyboard.press(String(i + 1));
    await frames(page);
    assert.ok(await page.locator(`#${id}`).isVisible(), id);
  }
  await page.keyboard.press('n');
  await frames(page);
  assert.match(await textOf(page, '#tour h3'), /^1\. /);
  await openPanel(page, 'clippers');
  const first = page.getByLabel('First', { exact: true });
  const before = await first.inputValue();
  await page.locator('body').press('x');
  await frames(page);
  assert.notEqual(await first.inputValue(), before);
  // What is written into a field is no shortcut.
  await openPanel(page, 'cases');
  await page.getByLabel('Search').pressSequentially('n3x');
  assert.match(await textOf(page, '#tour h3').catch(() => ''), /^(1\. .*)?$/);
  assert.ok(await page.locator('#clippers').isVisible());
}));

test('tabs are turned by arrow keys', onPage(async (page) => {
  await page.locator('#clippers-tab').focus();
  for (const [key, id] of [['ArrowRight', 'outcodes'], ['End', 'share'], ['ArrowRight', 'numbers'],
                           ['ArrowLeft', 'share'], ['Home', 'numbers']]) {
    await page.keyboard.press(key);
    await frames(page);
    assert.ok(await page.locator(`#${id}`).isVisible(), `${key}: ${id}`);
    assert.equal(await page.evaluate(() => document.activeElement.id), `${id}-tab`);
  }
}));

test('no panel is longer than the screen, no lesson either', onPage(async (page) => {
  const height = (id) => page.locator(`#${id}`).evaluate((e) => e.getBoundingClientRect().height);
  for (const id of kPanels) {
    await openPanel(page, id);
    assert.ok(await height(id) <= 900, `${id}: ${await height(id)} px`);
  }
  for (let i = 0; i < kTasks.length; ++i) {
    await click(page, '[data-lesson=next]');
    assert.ok(await height('tour') <= 900, `lesson ${i + 1}`);
  }
}));

test('on a phone every panel stays within its width', onPage(async (page) => {
  for (const id of [...kPanels, 'cases', 'tour']) {
    await openPanel(page, id);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 390, `${id}: ${width} px`);
  }
}, kPhone));

test('everything that can be pressed or written to has a name', onPage(async (page) => {
  for (const id of [...kPanels, 'cases', 'tour']) {
    await openPanel(page, id);
    const nameless = await page.locator(`#${id}`).evaluate((panel) =>
      [...panel.querySelectorAll('button, input, select, [role=img], [tabindex="0"]')]
        .filter((e) => !(e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.length > 0))
        .map((e) => e.outerHTML));
    assert.deepEqual(nameless, [], id);
  }
}));
