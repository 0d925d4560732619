// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the page does: tables sorted, filtered, shortened and copied; commands copied; pictures enlarged; the
// section in view marked among the contents. Without it all rows are shown.
'use strict';
(() => {
  const FEW = 50;    // rows that are shown without being asked for
  const FIRST = 20;  // rows shown of a longer table

  // The cell's value: a number where it has one, null where it is empty, else its text.
  const valueOf = (cell) => {
    if (cell.classList.contains('nothing')) return null;
    return 'v' in cell.dataset ? Number(cell.dataset.v) : cell.textContent;
  };

  // Where a value goes whatever the direction: NaN after numbers and texts, nothing at the very end.
  const place = (value) => (value === null ? 2 : Number.isNaN(value) ? 1 : 0);
  const compare = (a, b) => {
    if (typeof a === 'number' && typeof b === 'number') return a < b ? -1 : a > b ? 1 : 0;
    if (typeof a !== typeof b) return typeof a === 'number' ? -1 : 1;
    return a.localeCompare(b, 'en', { numeric: true });
  };

  const copy = async (text, button) => {
    const label = button.textContent;
    const fallback = () => {
      const area = document.createElement('textarea');
      area.value = text;
      button.after(area);
      area.select();
      const done = document.execCommand('copy');
      area.remove();
      button.focus();
      return done;
    };
    let done = false;
    try {
      await navigator.clipboard.writeText(text);
      done = true;
    } catch {
      done = fallback();
    }
    button.textContent = done ? 'Copied' : 'Could not copy';
    setTimeout(() => { button.textContent = label; }, 1500);
  };

  const csvOf = (table) => {
    const quote = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
    const head = [...table.tHead.rows[0].cells].map((cell) => cell.dataset.key);
    const rows = [...table.tBodies[0].rows].filter((row) => !row.classList.contains('out'));
    const text = (cell) => (cell.classList.contains('nothing') ? '' : cell.dataset.v ?? cell.textContent);
    return [head, ...rows.map((row) => [...row.cells].map(text))]
      .map((cells) => cells.map(quote).join(',') + '\n').join('');
  };

  const setUpTable = (figure) => {
    const table = figure.querySelector('table');
    const body = table.tBodies[0];
    const rows = [...body.rows];
    const texts = rows.map((row) => row.textContent.toLowerCase());
    const tools = figure.querySelector('.tools');
    const input = tools.querySelector('input');
    const count = tools.querySelector('.count');
    const more = figure.querySelector('.more');
    let all = rows.length <= FEW;

    // Hides what the filter leaves out, and of what it leaves in all but the first rows.
    const show = () => {
      const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
      rows.forEach((row, i) => row.classList.toggle('out', !words.every((w) => texts[i].includes(w))));
      const left = [...body.rows].filter((row) => !row.classList.contains('out'));
      const shown = all || left.length <= FEW ? left.length : FIRST;
      left.forEach((row, i) => row.classList.toggle('rest', i >= shown));
      more.hidden = shown === left.length && !(all && left.length > FEW);
      more.textContent = shown < left.length ? `Show all ${left.length} rows` : `Show the first ${FIRST} rows only`;
      more.setAttribute('aria-expanded', String(shown === left.length));
      const of = left.length === rows.length ? `${rows.length} rows` : `${left.length} of ${rows.length} rows`;
      count.textContent = shown < left.length ? `${of}, the first ${shown} shown` : of;
    };

    const sort = (header) => {
      const column = header.cellIndex;
      const ascending = header.getAttribute('aria-sort') !== 'ascending';
      for (const other of header.parentNode.cells) other.setAttribute('aria-sort', 'none');
      header.setAttribute('aria-sort', ascending ? 'ascending' : 'descending');
      const keyed = rows.map((row, i) => ({ row, i, value: valueOf(row.cells[column]) }));
      keyed.sort((a, b) => {
        const apart = place(a.value) - place(b.value);
        if (apart !== 0 || place(a.value) !== 0) return apart || a.i - b.i;
        return (ascending ? 1 : -1) * compare(a.value, b.value) || a.i - b.i;
      });
      body.append(...keyed.map((k) => k.row));
      show();
    };

    for (const header of table.tHead.rows[0].cells) {
      header.setAttribute('aria-sort', 'none');
      header.querySelector('button').addEventListener('click', () => sort(header));
    }
    input.addEventListener('input', show);
    more.addEventListener('click', () => { all = !all; show(); });
    tools.querySelector('button').addEventListener('click', (event) => copy(csvOf(table), event.currentTarget));
    tools.hidden = false;
    show();
  };

  document.querySelectorAll('.table').forEach(setUpTable);

  for (const button of document.querySelectorAll('.command button')) {
    button.hidden = false;
    button.addEventListener('click', () => copy(button.parentNode.querySelector('code').textContent, button));
  }

  const dialog = document.getElementById('enlarged');
  const enlarged = dialog.querySelector('img');
  for (const button of document.querySelectorAll('.pictures button')) {
    button.addEventListener('click', () => {
      const image = button.querySelector('img');
      enlarged.src = image.src;
      enlarged.alt = image.alt;
      dialog.showModal();
    });
  }
  dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });

  const contents = document.querySelector('nav details');
  const wide = matchMedia('(min-width: 82rem)');
  const fold = () => { contents.open = wide.matches; };
  wide.addEventListener('change', fold);
  fold();

  const links = new Map([...document.querySelectorAll('nav a')].map((a) => [a.hash.slice(1), a]));
  const inView = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      links.forEach((link, id) => {
        if (id === entry.target.id) link.setAttribute('aria-current', 'location');
        else link.removeAttribute('aria-current');
      });
    }
  }, { rootMargin: '0px 0px -75% 0px' });
  links.forEach((_, id) => inView.observe(document.getElementById(id)));
})();
