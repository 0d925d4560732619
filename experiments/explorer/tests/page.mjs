// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/page.mjs PAGE.html CATALOGUE.json: the page as a whole, in a browser: it is one small
// file that loads nothing, fits a desk and a phone, can be used by keyboard and read aloud, takes
// every hard case, and follows a drag at the rate of the screen.
import assert from 'node:assert/strict';
import { readFile, stat } from 'node:fs/promises';
import test from 'node:test';

import { frames, open, withPage } from './browser.mjs';
import { load } from './bundle.mjs';

const [file, cases] = process.argv.slice(2);
assert.ok(cases, 'usage: node tests/page.mjs PAGE.html CATALOGUE.json');
const onPage = (body, options = {}) => withPage(file, options, body);
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const catalogue = JSON.parse(await readFile(cases, 'utf8'));
const { link: { linkOf }, state: { initialState } } = await load('link', 'state');

// Looks at all that is shown one at a time; `check` returns what is wrong there.
async function forEachTab(page, check) {
  const names = await page.getByRole('tab').allInnerTexts();
  const found = [];
  assert.ok(names.length > 8, `${names}`);
  for (const name of new Set(names)) {
    await page.getByRole('tab', { name, exact: true }).first().click();
    await frames(page);
    const wrong = await check();
    if (wrong !== undefined && wrong.length > 0) found.push({ tab: name, wrong });
  }
  assert.deepEqual(found, []);
}

test('page: it has less than a megabyte and loads nothing', async () => {
  const { size } = await stat(file);
  assert.ok(size < 1e6, `${size} bytes`);
  const { page, errors, close } = await open(file);
  const requests = [];
  page.on('request', (request) => requests.push(request.url()));
  await page.reload();
  await page.waitForSelector('body.ready');
  await forEachTab(page, () => {});
  assert.deepEqual(requests.map((url) => url.replace(/^data:.*/, 'data:')), [page.url().split('#')[0]]);
  assert.deepEqual(errors, []);
  await close();
});

// The sections of the page: their names, and what is seen in them.
const sections = (page) => page.locator('main section').evaluateAll((all) => all.map((s) => ({
  id: s.id, text: s.innerText.trim(),
  isSeen: [s, ...s.children].some((e) => e.checkVisibility()), // without a box of its own, too
  name: s.querySelector('h2, h3')?.textContent ??
    document.getElementById(s.getAttribute('aria-labelledby'))?.textContent ?? '',
})));

test('page: every part is there, with a name and something in it', async () => {
  const met = new Set();
  let ids = [];
  for (const screen of [{}, phone]) {
    const { page, errors, close } = await open(file, screen);
    await forEachTab(page, async () => {
      const seen = (await sections(page)).filter((s) => s.isSeen);
      for (const { id } of seen) met.add(id);
      return seen.filter((s) => s.name === '' || ['', s.name].includes(s.text))
        .map((s) => `${s.id}: '${s.text}'`);
    });
    ids = (await sections(page)).map((s) => s.id);
    assert.deepEqual(errors, []);
    await close();
  }
  assert.deepEqual([...met].sort(), ids.sort());
  assert.equal(new Set(ids).size, ids.length);
  for (const id of ['guide', 'instruments', 'tour', 'cases', 'clippers', 'steps', 'magnifier']) {
    assert.ok(met.has(id), `${id} is not among ${ids}`);
  }
});

// --- Widths and themes --------------------------------------------------------------------------

// What reaches out of the page at its right.
const overflow = (page) => page.evaluate(() => {
  const { clientWidth, scrollWidth } = document.documentElement;
  if (scrollWidth === clientWidth) return [];
  return [...document.body.querySelectorAll('*')]
    .filter((e) => e.getBoundingClientRect().right > clientWidth + 0.5)
    .map((e) => `${scrollWidth - clientWidth} px: ${e.outerHTML.slice(0, 80)}`).slice(0, 5);
});

for (const [name, width] of [['a phone', 390], ['a small phone', 320], ['a tablet', 820], ['a desk', 1400]]) {
  test(`page: ${name} has nothing to scroll sideways to`, onPage(async (page) => {
    await forEachTab(page, () => overflow(page));
  }, { viewport: { width, height: 844 } }));
}

test('page: a phone\'s finger finds every control', onPage(async (page) => {
  await forEachTab(page, () => page.locator('button:not(.skip), select, input, summary, [role=slider], [role=tab]')
      .evaluateAll((controls) => controls.filter((c) => c.checkVisibility({ visibilityProperty: true }))
        // A label around its control is as good as this (WCAG 2.2, 2.5.8).
        .map((c) => [c, (c.closest('label') ?? c).getBoundingClientRect()])
        .filter(([, box]) => box.width < 24 || box.height < 24)
        .map(([c, box]) => `${c.outerHTML.slice(0, 80)}: ${box.width} x ${box.height}`)));
}, phone));

// The contrast of every text with what is behind it (WCAG 2.2, 1.4.3), where that is one colour.
function poorContrasts() {
  const channels = (colour) => {
    const canvas = new OffscreenCanvas(1, 1).getContext('2d');
    canvas.fillStyle = colour;
    canvas.fillRect(0, 0, 1, 1);
    return [...canvas.getImageData(0, 0, 1, 1).data];
  };
  const luminance = (rgb) => {
    const [r, g, b] = rgb.map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92
      : ((c / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = (element) => {
    for (let e = element; e !== null; e = e.parentElement) {
      const [r, g, b, alpha] = channels(getComputedStyle(e).backgroundColor);
      if (alpha === 255) return [r, g, b];
      if (alpha > 0) return null;
    }
    return [255, 255, 255];
  };
  const poor = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
    const element = node.parentElement;
    if (node.textContent.trim() === '' || element.closest('script, style, noscript, [disabled]')) continue;
    if (!element.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
    const style = getComputedStyle(element);
    const ground = behind(element), text = channels(style.color);
    if (ground === null || text[3] < 255) continue;
    const [low, high] = [luminance(ground), luminance(text.slice(0, 3))].sort((a, b) => a - b);
    const size = parseFloat(style.fontSize);
    const isLarge = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    const contrast = (high + 0.05) / (low + 0.05);
    if (contrast < (isLarge ? 3 : 4.5)) {
      poor.push(`${node.textContent.trim().slice(0, 40)}: ${contrast.toFixed(2)}`);
    }
  }
  return poor;
}

for (const colorScheme of ['light', 'dark']) {
  test(`page: every text can be read in ${colorScheme}`, onPage(async (page) => {
    await forEachTab(page, () => page.evaluate(poorContrasts));
  }, { colorScheme }));
}

// --- Without a mouse, without eyes --------------------------------------------------------------

const kControls = new Set(['button', 'link', 'textbox', 'searchbox', 'combobox', 'checkbox', 'radio',
                           'slider', 'spinbutton', 'tab', 'switch', 'menuitem', 'listbox']);
const kNamed = new Set([...kControls, 'img', 'image', 'region', 'tabpanel', 'figure']);

async function accessibleNodes(page) {
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send('Accessibility.getFullAXTree');
  await session.detach();
  return nodes.filter((n) => !n.ignored).map((n) =>
    ({ role: n.role?.value, name: (n.name?.value ?? '').trim() }));
}

test('page: what a screen reader meets has a name', onPage(async (page) => {
  let controls = 0;
  await forEachTab(page, async () => {
    const nodes = await accessibleNodes(page);
    controls = Math.max(controls, nodes.filter((n) => kControls.has(n.role)).length);
    return nodes.filter((n) => kNamed.has(n.role) && n.name === '');
  });
  assert.ok(controls > 40, `${controls} controls`);
}));

test('page: headings go down one level at a time, from one title', onPage(async (page) => {
  const levels = await page.getByRole('heading').evaluateAll((headings) =>
    headings.map((h) => Number(h.getAttribute('aria-level') ?? h.tagName.slice(1))));
  assert.equal(levels.filter((level) => level === 1).length, 1);
  levels.forEach((level, i) => assert.ok(i === 0 ? level === 1 : level <= levels[i - 1] + 1, `${levels}`));
  assert.equal(await page.locator('html').getAttribute('lang'), 'en');
  assert.equal(await page.getByRole('main').count(), 1);
  const ids = await page.locator('[id]').evaluateAll((all) => all.map((e) => e.id));
  assert.equal(new Set(ids).size, ids.length, 'an id is there twice');
}));

// What has the focus, and whether that can be seen.
function focused() {
  const e = document.activeElement;
  if (e === null || e === document.body) return null;
  const style = getComputedStyle(e), box = e.getBoundingClientRect();
  globalThis.focusNumbers ??= new WeakMap();
  globalThis.focusCount ??= 0;
  if (!focusNumbers.has(e)) focusNumbers.set(e, focusCount++);
  return {
    number: focusNumbers.get(e), text: e.outerHTML.slice(0, 90),
    isInView: box.bottom > 0 && box.top < innerHeight && box.right > 0 && box.left < innerWidth,
    isMarked: (style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0) ||
      style.boxShadow !== 'none' || e.matches('input[type=checkbox], input[type=radio]'),
  };
}

test('page: the tab key walks through all of it and out again', onPage(async (page) => {
  const met = [];
  for (let i = 0; i < 2000; ++i) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(focused);
    if (at === null || met.some((m) => m.number === at.number)) break;
    assert.ok(at.isInView, `out of sight: ${at.text}`);
    assert.ok(at.isMarked, `not marked: ${at.text}`);
    met.push(at);
  }
  const controls = await page.locator('button, select, input, a[href], summary, [tabindex="0"]')
    .evaluateAll((all) => all.filter((e) => e.tabIndex >= 0 && !e.disabled && e.getClientRects().length > 0 &&
      e.checkVisibility({ visibilityProperty: true }) && !(e.type === 'radio' && !e.checked)).length);
  assert.ok(met.length >= controls, `${met.length} of ${controls} controls were met; the last: ${met.at(-1).text}`);
  assert.ok(met.length > 20);
}));

test('page: a hard case is opened and a vertex is moved without a mouse', onPage(async (page) => {
  const reach = async (matches) => {
    for (let i = 0; i < 2000; ++i) {
      await page.keyboard.press('Tab');
      if (await page.evaluate((selector) => document.activeElement.matches(selector), matches)) return;
    }
    assert.fail(`${matches} was not reached`);
  };
  await reach('[role=tab][aria-controls=tour], #guide [role=tab]');
  await page.keyboard.press('ArrowRight');
  await frames(page);
  await reach('#cases input[type=search]');
  await page.keyboard.type('w_3_to_minus_3');
  await reach('#cases button.case');
  await page.keyboard.press('Enter');
  await frames(page);
  const wanted = catalogue.find((c) => c.name === 'w_sign/w_3_to_minus_3');
  assert.match(await page.locator('#cases').innerText(), new RegExp(wanted.expected));
  await page.waitForFunction(() => location.hash.includes('w_3_to_minus_3'));
  const before = await page.evaluate(() => location.hash);
  await page.evaluate(() => document.querySelector('[role=slider]').focus());
  await page.keyboard.press('ArrowUp');
  await page.waitForFunction((old) => location.hash !== old, before);
}));

// --- All that it may be asked -------------------------------------------------------------------

test('page: every hard case opens by its link', onPage(async (page) => {
  assert.ok(catalogue.length > 200, `${catalogue.length} cases`);
  for (const { name, question } of catalogue) {
    const state = { ...initialState(), ...question, source: name };
    await page.evaluate((fragment) => { location.hash = fragment; }, linkOf(state));
    await frames(page);
    assert.equal(await page.locator('#link-error').count(), 0, name);
  }
}));

test('page: a link that is wrong is said, and the page stays', onPage(async (page) => {
  await page.evaluate(() => { location.hash = 'v1&space=ndc'; });
  await page.locator('#link-error').waitFor();
  assert.match(await page.locator('#link-error').innerText(), /'ndc' was given/);
}));

// --- Speed --------------------------------------------------------------------------------------

const kDragSeconds = 2;
const kFrameMilliseconds = 1000 / 60;

// What the page's own thread has computed, without the times at which others had the processor.
async function threadSeconds(session) {
  const { metrics } = await session.send('Performance.getMetrics');
  return metrics.find((m) => m.name === 'TaskDuration').value;
}

async function dragInCircles(page, handle, seconds) {
  const { x, y, width, height } = await handle.boundingBox();
  const [left, top] = [x + width / 2, y + height / 2];
  await page.mouse.move(left, top);
  await page.mouse.down();
  const end = Date.now() + 1000 * seconds;
  for (let i = 0; Date.now() < end; ++i) {
    await page.mouse.move(left + 30 * Math.sin(i / 9), top + 30 * (1 - Math.cos(i / 9)));
  }
  await page.mouse.up();
}

test('page: a drag takes less than the time of a frame at 60 a second', onPage(async (page) => {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  const handle = page.locator('[data-space=view] .vertex').nth(1);
  await dragInCircles(page, handle, 0.5); // the code is compiled
  await page.evaluate(() => {
    window.frameTimes = [];
    const count = (time) => { window.frameTimes.push(time); window.counting = requestAnimationFrame(count); };
    window.counting = requestAnimationFrame(count);
  });
  const before = await threadSeconds(session);
  await dragInCircles(page, handle, kDragSeconds);
  const computed = await threadSeconds(session) - before;
  const times = await page.evaluate(() => { cancelAnimationFrame(window.counting); return window.frameTimes; });
  const perSecond = 1000 * (times.length - 1) / (times.at(-1) - times[0]);
  const perFrame = 1000 * computed / times.length;
  console.log(`# ${perSecond.toFixed(1)} frames a second, ${perFrame.toFixed(1)} ms of computing each`);
  assert.ok(times.length > 10, `${times.length} frames`);
  assert.ok(perFrame < kFrameMilliseconds, `${perFrame} ms`);
}));
