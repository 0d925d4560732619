// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page's address follows the state, and the state a link that is opened.

import { linkOf, LinkError, stateOfLink } from './link';
import type { Names } from './link';
import type { Store } from './state';

// Browsers refuse more than some hundred changes of the address within half a minute.
const kMilliseconds = 400;

// Says what is wrong with a link on top of the page, until the next link is opened.
function complain(message: string | null) {
  document.getElementById('link-error')?.remove();
  if (message === null) return;
  const alert = document.createElement('p');
  alert.id = 'link-error';
  alert.setAttribute('role', 'alert');
  alert.textContent = `This link can't be shown: ${message}. The page stays as it is.`;
  document.body.prepend(alert);
}

function read(store: Store, names: Names) {
  const fragment = location.hash.slice(1);
  if (fragment === '' || fragment === linkOf(store.state)) return;
  try {
    store.update(stateOfLink(fragment, names));
    complain(null);
  } catch (error) {
    if (!(error instanceof LinkError)) throw error;
    complain(error.message);
  }
}

export function followLink(store: Store, names: Names) {
  read(store, names);
  window.addEventListener('hashchange', () => read(store, names));
  let timer: number | null = null;
  store.subscribe((state, before) => {
    if (timer !== null || state === before) return;
    timer = window.setTimeout(() => {
      timer = null;
      history.replaceState(null, '', `#${linkOf(store.state)}`);
    }, kMilliseconds);
  });
}
