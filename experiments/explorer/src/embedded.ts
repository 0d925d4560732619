// SPDX-License-Identifier: GPL-3.0-or-later
//
// What build.mjs puts into the page beside the program: bytes, compressed by gzip, in base64.

export async function embedded(id: 'engine' | 'catalogue'): Promise<ArrayBuffer> {
  const text = document.getElementById(id)!.textContent!;
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}
