// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the page does: tables sorted, filtered, shortened and copied; commands copied; pictures enlarged; the
// section in view marked among the contents. The rows of a long table are loaded when they are asked for.
// Without it the rows in the page are shown.
'use strict';
(() => {
  const FEW = 50;    // rows that are shown without being asked for
  const FIRST = 20;  // rows shown of a longer table

  // What a cell says, without what folds out beneath it.
  const textOf = (cell) => cell.firstChild?.textContent ?? '';

  // The cell's value: a number where it has one, null where it is empty, else its text.
  const valueOf = (cell) => {
    if (cell.classList.contains('nothing')) return null;
    return cell.classList.contains('n') ? Number(cell.dataset.v ?? cell.textContent) : textOf(cell);
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
    const text = (cell) => (cell.classList.contains('nothing') ? '' : cell.dataset.v ?? textOf(cell));
    return [head, ...rows.map((row) => [...row.cells].map(text))]
      .map((cells) => cells.map(quote).join(',') + '\n').join('');
  };

  // The scripts of rows call it with a table's name and its rows.
  const waiting = new Map();
  window.clipscopeRows = (name, html) => waiting.get(name)(html);

  const setUpTable = (figure) => {
    const table = figure.querySelector('table');
    const body = table.tBodies[0];
    const tools = figure.querySelector('.tools');
    const input = tools.querySelector('input');
    const count = tools.querySelector('.count');
    const more = figure.querySelector('.more');
    const { script } = figure.dataset;
    const total = Number(figure.dataset.rows ?? body.rows.length);
    let rows = [...body.rows];
    let texts = null;  // of the rows, once somebody filters
    let loaded = null;
    let all = total <= FEW;

    // Hides what the filter leaves out, and of what it leaves in all but the first rows.
    const show = () => {
      const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
      if (words.length > 0) texts ??= rows.map((row) => row.textContent.toLowerCase());
      rows.forEach((row, i) => row.classList.toggle('out', !words.every((w) => texts[i].includes(w))));
      const left = [...body.rows].filter((row) => !row.classList.contains('out'));
      const found = rows.length < total ? total : left.length;
      const shown = all || found <= FEW ? found : FIRST;
      left.forEach((row, i) => row.classList.toggle('rest', i >= shown));
      more.hidden = shown === found && !(all && found > FEW);
      more.textContent = shown < found ? `Show all ${found} rows` : `Show the first ${FIRST} rows only`;
      more.setAttribute('aria-expanded', String(shown === found));
      const of = found === total ? `${total} rows` : `${found} of ${total} rows`;
      count.textContent = shown < found ? `${of}, the first ${shown} shown` : of;
    };

    const load = () => new Promise((done, failed) => {
      waiting.set(figure.querySelector('.caption').id.slice('table-'.length), (html) => {
        body.innerHTML = html;
        rows = [...body.rows];
        texts = null;
        done();
      });
      document.head.append(Object.assign(document.createElement('script'), { src: script, onerror: failed }));
    });

    // Does it when all rows are there.
    const withRows = async (work) => {
      try {
        if (script) await (loaded ??= load());
        work();
      } catch {
        loaded = null;
        count.textContent = `${script} can't be loaded; it has the other rows`;
      }
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
      header.querySelector('button').addEventListener('click', () => withRows(() => sort(header)));
    }
    input.addEventListener('input', () => withRows(show));
    more.addEventListener('click', () => withRows(() => { all = !all; show(); }));
    const button = tools.querySelector('button');
    button.addEventListener('click', () => withRows(() => { copy(csvOf(table), button); }));
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
  for (const button of document.querySelectorAll('.pictures button, .readers figure button')) {
    button.addEventListener('click', () => {
      const image = button.querySelector('img');
      enlarged.src = image.getAttribute('src');
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
