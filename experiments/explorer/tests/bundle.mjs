// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modules of the page for tests that run without a browser.
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { build } from 'esbuild';

export const root = dirname(dirname(fileURLToPath(import.meta.url)));

// What src/NAME.ts exports, several of them together: { engine: {...}, exact: {...} }; of a file in
// a folder as { folder_file: {...} }.
export async function load(...names) {
  const bundled = await build({
    stdin: {
      contents: names.map((name) => `export * as ${name.replaceAll('/', '_')} from './src/${name}';`).join('\n'),
      resolveDir: root,
      loader: 'ts',
    },
    bundle: true,
    format: 'esm',
    platform: 'node',
    write: false,
  });
  const code = Buffer.from(bundled.outputFiles[0].contents).toString('base64');
  return import(`data:text/javascript;base64,${code}`);
}
