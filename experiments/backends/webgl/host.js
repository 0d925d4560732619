// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the host asks of its page, answered by objects that JSON can hold.
'use strict';

let drawing = null;

// A context that is lost does not come back where another one can be had.
function current() {
  if (!Uint8Array.prototype.toBase64) throw new Error('the browser is older than Chromium 140');
  if (!drawing || drawing.isLost()) drawing = new Drawing();
  return drawing;
}

const base64 = (floats) => new Uint8Array(floats.buffer).toBase64();

function attempt(action) {
  try {
    return action();
  } catch (error) {
    return { error: error.message, isLost: !!drawing && drawing.isLost() };
  }
}

const describe = () => attempt(() => current().describe());
const answer = (call) => attempt(() => ({ passes: current().draw(call).map((values) => values.map(base64)) }));
