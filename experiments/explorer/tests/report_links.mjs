// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/report_links.mjs PAGE.html WRITE_SAMPLE_PAGE: a page of results leads to the explorer
// that lies beside it, and a worst input opens there as the question that it was.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFile, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';

import { open } from './browser.mjs';

const [file, writeSamplePage] = process.argv.slice(2);
assert.ok(writeSamplePage, 'usage: node tests/report_links.mjs PAGE.html WRITE_SAMPLE_PAGE');

const folder = await mkdtemp(join(tmpdir(), 'clipscope-report-'));
after(() => rm(folder, { recursive: true }));
await copyFile(file, join(folder, 'explorer.html'));
execFileSync(writeSamplePage, [folder, 'folder']);
const report = { file: join(folder, 'report.html'), ready: 'main' };

test('report: it leads to the explorer', async () => {
  const { page, errors, close } = await open(report.file, { ready: report.ready });
  await page.getByRole('link', { name: 'The explorer' }).click();
  await page.waitForSelector('body.ready');
  assert.match(page.url(), /explorer\.html$/);
  assert.deepEqual(errors, []);
  await close();
});

test('report: a worst input opens in the explorer', async () => {
  const { page, errors, close } = await open(report.file, { ready: report.ready });
  await page.getByText('Inputs on which each contestant was farthest off').first().click();
  await page.getByRole('link', { name: 'see it in the explorer' }).click();
  await page.waitForSelector('body.ready');
  assert.equal(await page.locator('#link-error').count(), 0);
  await page.getByRole('tab', { name: 'Numbers', exact: true }).click();
  const number = (name, vertex) =>
    page.getByLabel(`${name} of ${vertex}`, { exact: true }).inputValue().then(Number);
  // tests/experiments/report/sample_page.hpp
  const expected = { A: [-2, -1, -4], B: [3, -0.5, 2], C: [0, 2.5, -5] };
  for (const [vertex, position] of Object.entries(expected)) {
    assert.deepEqual(await Promise.all(['x', 'y', 'z'].map((n) => number(n, vertex))), position);
  }
  assert.match(page.url(), /clippers=cvv\/naive,barycentric\/distance_matrix/);
  assert.deepEqual(errors, []);
  await close();
});
