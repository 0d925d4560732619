// SPDX-License-Identifier: GPL-3.0-or-later
//
// node build.mjs ENGINE.wasm CATALOGUE.json OUT.html [DEPENDENCIES]: the page as one file that needs
// nothing else. DEPENDENCIES: a makefile of what it was made from.
import { readFile, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

import { build } from 'esbuild';

const [engine, catalogue, out, dependencies] = process.argv.slice(2);
if (out === undefined) {
  console.error('usage: node build.mjs ENGINE.wasm CATALOGUE.json OUT.html [DEPENDENCIES]');
  process.exit(2);
}
const here = dirname(fileURLToPath(import.meta.url));
const styles = ['src/page.css', 'src/panels/panels.css'].map((file) => join(here, file));
const bundled = await build({
  entryPoints: [join(here, 'src/main.ts')],
  bundle: true,
  minify: true,
  format: 'esm',
  target: 'es2022',
  charset: 'ascii',
  write: false,
  metafile: true,
});
const packed = async (file) => gzipSync(await readFile(file), { level: 9 }).toString('base64');
const parts = {
  CSS: (await Promise.all(styles.map((file) => readFile(file, 'utf8')))).join(''),
  ENGINE: await packed(engine),
  CATALOGUE: await packed(catalogue),
  // The browser ends the script at its first end tag, also within a string.
  SCRIPT: bundled.outputFiles[0].text.replaceAll('</script', '<\\/script'),
};
const page = await readFile(join(here, 'src/index.html'), 'utf8');
await writeFile(out, page.replace(/@([A-Z]+)@/g, (_, part) => parts[part]));
if (dependencies !== undefined) {
  const inputs = Object.keys(bundled.metafile.inputs).map((path) => resolve(path));
  const files = [...inputs, ...styles, join(here, 'src/index.html')];
  await writeFile(dependencies, `${out}: ${files.map((f) => f.replaceAll(' ', '\\ ')).join(' ')}\n`);
}
