// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page in a real browser, for tests that click and drag: Debian's Chromium without a window.
//
// Where there is none, the test is skipped (exit code 77), unless CLIPSCOPE_REQUIRE_CHROMIUM is set.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after } from 'node:test';
import { pathToFileURL } from 'node:url';

import { chromium } from 'playwright-core';

const executablePath = ['chromium', 'chromium-browser', 'google-chrome']
  .flatMap((name) => process.env.PATH.split(':').map((folder) => join(folder, name))).find(existsSync);
if (executablePath === undefined) {
  console.error('Chromium is not installed (on Debian: apt-get install chromium)');
  process.exit(process.env.CLIPSCOPE_REQUIRE_CHROMIUM ? 1 : 77);
}

let browser = null;
after(() => browser?.close());

// Opens the page and waits until it shows a triangle, or for what is `ready` on another. Whatever
// it writes to the console as an error or throws is in `errors`.
export async function open(file, { fragment = '', ready = 'body.ready', ...options } = {}) {
  browser ??= await chromium.launch({ executablePath, args: ['--no-sandbox'] });
  const context = await browser.newContext({ viewport: { width: 1400, height: 900 }, ...options });
  const page = await context.newPage();
  const errors = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) errors.push(message.text());
  });
  page.on('pageerror', (error) => errors.push(String(error.stack ?? error)));
  await page.goto(pathToFileURL(resolve(file)).href + fragment);
  await page.waitForSelector(ready);
  await frames(page);
  return { page, errors, close: () => context.close() };
}

// What a change shows is on the page two frames later.
export async function frames(page) {
  await page.evaluate(() => new Promise((done) => {
    requestAnimationFrame(() => requestAnimationFrame(done));
  }));
}

// A test of a page that ends without an error on it.
export function withPage(file, options, body) {
  return async () => {
    const { page, errors, close } = await open(file, options);
    await body(page);
    await frames(page);
    assert.deepEqual(errors, []);
    await close();
  };
}
