// SPDX-License-Identifier: GPL-3.0-or-later
//
// Run inside the sample page by check_page: uses it as a person does and posts what is wrong to the
// frame around it. expected: the page's form, folder or single; the width of the view [px]; whether its
// colours shall be dark.
'use strict';
(async () => {
  const wrong = [...window.pageErrors];
  let checks = 0;
  const check = (claim, holds, seen = '') => {
    checks += 1;
    if (!holds) wrong.push(`${claim} ${typeof seen === 'string' ? seen : JSON.stringify(seen)}`);
  };
  const same = (claim, a, b) => check(claim, JSON.stringify(a) === JSON.stringify(b), { saw: a, expected: b });
  const pause = () => new Promise((done) => { setTimeout(done, 20); });
  const until = async (holds) => { for (let i = 0; i < 250 && !holds(); ++i) await pause(); };
  let copied = null;
  Object.defineProperty(navigator, 'clipboard', { value: { writeText: async (text) => { copied = text; } } });

  const tableOf = (name) => document.getElementById(`table-${name}`).closest('.table');
  const visible = (figure) => [...figure.querySelectorAll('tbody tr')].filter((row) => row.offsetParent !== null);
  const column = (figure, index) => visible(figure).map((row) => row.cells[index].textContent);
  const header = (figure, index) => figure.querySelector('thead tr').cells[index];
  const sortBy = async (figure, index) => { header(figure, index).querySelector('button').click(); await pause(); };
  const filter = async (figure, text) => {
    const input = figure.querySelector('input');
    input.value = text;
    input.dispatchEvent(new Event('input', { bubbles: true }));
    await pause();
  };

  try {
    const lead = document.querySelector('.lead').getBoundingClientRect();
    check('the answer is on the first screen', lead.top >= 0 && lead.bottom < 900, lead);

    const odd = tableOf('odd');
    await sortBy(odd, 1);
    same('numbers sort by value, then NaN, then nothing', column(odd, 0),
      ['below all', 'tiny <b>bold</b>', 'nine, "9"', 'ten', 'infinite', 'not a number', 'nothing']);
    same('the sorted column says so', header(odd, 1).getAttribute('aria-sort'), 'ascending');
    await sortBy(odd, 1);
    same('a second click sorts the other way; NaN and nothing stay last', column(odd, 0),
      ['infinite', 'ten', 'nine, "9"', 'tiny <b>bold</b>', 'below all', 'not a number', 'nothing']);
    same('and says so', header(odd, 1).getAttribute('aria-sort'), 'descending');
    await sortBy(odd, 2);
    same('counts sort as numbers', column(odd, 2), ['-4', '3', '5', '6', '20', '100', '–']);
    same('only one column is said to be sorted', odd.querySelectorAll('th[aria-sort$="ending"]').length, 1);
    const key = header(odd, 0).querySelector('button');
    key.focus();
    check('a header can be reached and pressed by keyboard', document.activeElement === key && key.tagName === 'BUTTON');

    await sortBy(odd, 1);
    await filter(odd, 'n');
    odd.querySelector('.tools button').click();
    await pause();
    await filter(odd, '"9" NINE');
    same('the filter takes words in any order and case', column(odd, 0), ['nine, "9"']);
    same('and says how many rows are left', odd.querySelector('.count').textContent, '1 of 7 rows');
    odd.querySelector('.tools button').click();
    await pause();
    same('what is shown is copied as CSV', copied, 'name,value_px,count\n"nine, ""9""",9,3\n');
    await filter(odd, 'no such row');
    same('a filter that nothing passes leaves nothing', visible(odd).length, 0);
    await filter(odd, '');
    same('without a filter all rows are back', visible(odd).length, 7);

    const long = tableOf('long'), more = long.querySelector('.more');
    same('of a long table the first rows are shown', visible(long).length, 20);
    same('and it is said how many there are', long.querySelector('.count').textContent, '160 rows, the first 20 shown');
    same('the others are in the page only if it is a single file', long.querySelectorAll('tbody tr').length,
      expected.form === 'single' ? 160 : 20);
    await sortBy(long, 2);
    await until(() => long.querySelectorAll('tbody tr').length === 160);
    same('sorted, the least of all rows are first', column(long, 2).slice(0, 3).map(Number), [1, 2, 3]);
    same('and still the first rows only', visible(long).length, 20);
    more.click();
    await pause();
    same('a button shows all rows', visible(long).length, 160);
    more.click();
    await pause();
    same('and the first only again', visible(long).length, 20);
    await filter(long, 'homogeneous float');
    check('the filter looks at rows that were not shown', long.querySelector('.count').textContent === '40 of 160 rows'
      && visible(long).length === 40, long.querySelector('.count').textContent);
    await filter(long, '');

    same('a table without rows is shown as such', tableOf('empty').querySelector('.count').textContent, '0 rows');

    document.querySelector('#sample .command button').click();
    await pause();
    same('the command is copied', copied, "clipscope run sample --out 'my results'");

    const dialog = document.getElementById('enlarged');
    document.querySelector('.pictures button').click();
    check('a picture is enlarged', dialog.open && dialog.querySelector('img').alt === 'A "picture"');
    dialog.close();

    same('answers come first, then claims', [...document.querySelectorAll('main > section')].slice(0, 2).map((s) => s.id),
      ['answers', 'claims']);
    for (const link of document.querySelectorAll('.evidence')) {
      check('a sentence leads to its evidence', document.querySelector(link.getAttribute('href')) !== null, link.textContent);
    }
    const matrix = tableOf('answers_stability');
    same('the matrix says by colours who fails', [...matrix.querySelectorAll('tbody tr')].map((row) => row.cells[4].className),
      ['n', 'n right', 'n few', 'n many']);
    const colours = new Set([...matrix.querySelectorAll('.right, .few, .many')].map((cell) => getComputedStyle(cell).backgroundColor));
    same('which are three', colours.size, 3);
    same('nothing in the page is a script but ours', document.querySelectorAll('main script, main b:not(.finding b)').length, 0);
    check('the title is ours', document.title.startsWith('clipscope'), document.title);

    const roots = document.documentElement;
    same('the view is as wide as asked for', roots.clientWidth, expected.width);
    check('the page does not scroll sideways', roots.scrollWidth <= roots.clientWidth, String(roots.scrollWidth));
    const box = long.querySelector('.box');
    check('a wide table scrolls inside its box', expected.width > 1000 || box.scrollWidth > box.clientWidth);

    const ids = [...document.querySelectorAll('[id]')].map((e) => e.id);
    same('no id is used twice', ids.filter((id, i) => ids.indexOf(id) !== i), []);
    for (const link of document.querySelectorAll('[href], [src]')) {
      const target = link.getAttribute('href') ?? link.getAttribute('src');
      const isBeside = /^(sample|answers|report)\/[\w.]+$/.test(target);
      check('nothing comes from elsewhere', target.startsWith('#') ? target === '#' || document.getElementById(target.slice(1)) !== null
        : expected.form === 'single' ? target.startsWith('data:') : isBeside, target.slice(0, 60));
    }
    for (const cell of document.querySelectorAll('th')) check('a header says of what', cell.scope === 'col' || cell.scope === 'row');
    for (const image of document.querySelectorAll('.pictures img')) check('a picture has a text', image.alt !== '');
    for (const image of document.querySelectorAll('.plot img, .pictures img, .readers img')) {
      image.loading = 'eager';
      await until(() => image.naturalWidth > 0);
      check('a picture is there', image.naturalWidth > 0, image.getAttribute('src').slice(0, 60));
      check('it keeps its place before it is loaded', image.hasAttribute('width') && image.hasAttribute('height'));
    }
    const plots = expected.form === 'single' ? '.plot svg' : '.plot img';
    same('there is every plot', document.querySelectorAll(plots).length, 3);
    for (const plot of document.querySelectorAll('.plot img')) same('a plot has a text', plot.alt, 'A plot. What it shows');
    for (const plot of document.querySelectorAll('.plot svg')) {
      check('a plot has a text', plot.getAttribute('role') === 'img' && plot.getAttribute('aria-label') === 'A plot. What it shows');
      const marks = [...plot.querySelectorAll('use')].filter((use) => !use.closest('defs'));
      for (const use of marks) check('a mark is drawn', use.getBoundingClientRect().width > 1);
      check('a plot is drawn', plot.querySelectorAll('path').length > 5 && plot.getBoundingClientRect().width > 200);
    }

    // Contrast as WCAG 2.1 defines it: at least 4.5 to 1 for text.
    const channels = (colour) => colour.match(/[\d.]+/g).map(Number);
    const light = ([r, g, b]) => [r, g, b].map((c) => c / 255)
      .map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
    const behind = (element) => {
      for (let e = element; e !== null; e = e.parentElement) {
        const colour = channels(getComputedStyle(e).backgroundColor);
        if (colour.length === 3 || colour[3] === 1) return colour;
      }
      return [255, 255, 255];
    };
    for (const element of document.querySelectorAll('body *:not(svg *)')) {
      const text = [...element.childNodes].some((n) => n.nodeType === Node.TEXT_NODE && n.data.trim() !== '');
      if (!text || element.offsetParent === null) continue;
      const a = light(channels(getComputedStyle(element).color)), b = light(behind(element));
      const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      check('text stands out from its ground', ratio >= 4.5, `${element.tagName}.${element.className} ${ratio.toFixed(2)}`);
    }
    for (const text of document.querySelectorAll('.plot svg text')) {
      if (text.textContent.trim() === '') continue;
      const a = light(channels(getComputedStyle(text).fill)), b = light(behind(text.closest('div')));
      const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      check('text in a plot stands out', ratio >= 4.5, `${text.textContent} ${ratio.toFixed(2)}`);
    }
    same('the colours are those of the scheme', light(behind(document.body)) < 0.2, expected.dark);
  } catch (error) {
    wrong.push(`the checks broke off: ${error.stack}`);
  }
  wrong.push(...window.pageErrors.filter((e) => !wrong.includes(e)));
  parent.postMessage({ checks, wrong }, '*');
})();
