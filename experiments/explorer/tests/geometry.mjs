// SPDX-License-Identifier: GPL-3.0-or-later
//
// node tests/geometry.mjs: lenses, what is drawn of points at infinity, and short decimals, without
// a browser.
import assert from 'node:assert/strict';
import test from 'node:test';

import { load } from './bundle.mjs';

globalThis.window = { devicePixelRatio: 1, matchMedia: () => ({ addEventListener() {} }) };
const page = await load('floats', 'views/lens', 'views/painter', 'views/figure',
                        'views/canonical_space', 'views/view_space');
const { floats, views_lens: { OrbitLens, PlaneLens, project } } = page;
const { Painter } = page.views_painter, { drawFigure } = page.views_figure;
const { kCanonicalSpace } = page.views_canonical_space, { outsideOf } = page.views_view_space;

const kSize = 400;
const kCorners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-3, 5].map((z) => [x, y, z])));

function lensOf(Lens) {
  const lens = new Lens({ yaw: 0.7, pitch: 0.3 });
  lens.resize(kSize, kSize);
  lens.fit(kCorners);
  return lens;
}

// A canvas that keeps the ends of the lines drawn on it.
function recorder() {
  const lines = [];
  let at = null;
  const context = new Proxy({}, {
    get: (_, name) => (...numbers) => {
      if (name === 'lineTo' && at !== null) lines.push([at, numbers]);
      if (name === 'moveTo' || name === 'lineTo') at = numbers;
      if (name === 'beginPath') at = null;
      return name === 'createPattern' ? {} : { width: 0 };
    },
    set: () => true,
  });
  const canvas = { getContext: () => context, width: 0, height: 0 };
  globalThis.document = { createElement: () => ({ ...canvas }) };
  const painter = new Painter(canvas);
  painter.resize(kSize, kSize);
  return { painter, lines };
}

for (const Lens of [OrbitLens, PlaneLens]) {
  test(`lens: the point under a pixel is seen at that pixel, ${Lens.name}`, () => {
    const lens = lensOf(Lens);
    for (let i = 0; i < 100; ++i) {
      lens.turn(31 * Math.sin(i), 17 * Math.cos(i));
      lens.zoom(1 + 0.3 * Math.sin(3 * i), { x: 100, y: 200 });
      const pixel = { x: 37 * i % kSize, y: 91 * i % kSize };
      const seen = project(lens, [...lens.pointAt(pixel, [0.3, -0.2, 0.1]), 1]);
      assert.ok(Math.hypot(seen.x - pixel.x, seen.y - pixel.y) < 1e-6);
    }
  });

  test(`lens: what it is fitted to is on the canvas and fills it, ${Lens.name}`, () => {
    const lens = lensOf(Lens);
    const seen = kCorners.map((p) => project(lens, [...p, 1]));
    for (const { x, y, w } of seen) {
      assert.ok(w > 0 && x > 0 && x < kSize && y > 0 && y < kSize, `${x}, ${y}`);
    }
    const size = (values) => Math.max(...values) - Math.min(...values);
    const largest = Math.max(size(seen.map((p) => p.x)), size(seen.map((p) => p.y)));
    assert.ok(largest > 0.7 * kSize, `${largest}`);
  });
}

test('lens: a point on a plane keeps that coordinate to the last bit', () => {
  const lens = lensOf(OrbitLens);
  const point = lens.pointOn({ x: 123, y: 77 }, 2, 0.1);
  assert.equal(point[2], 0.1);
  const seen = project(lens, [...point, 1]);
  assert.ok(Math.hypot(seen.x - 123, seen.y - 77) < 1e-6);
});

test('painter: a line to a point at infinity ends beyond the border, where that point is seen', () => {
  const { painter, lines } = recorder();
  const lens = lensOf(PlaneLens);
  painter.begin(lens);
  painter.line([[0, 0, 0, 1], [3, 4, 0, 0]], { colour: 'red' });
  assert.equal(lines.length, 1);
  const [[x0, y0], [x1, y1]] = lines[0];
  const start = project(lens, [0, 0, 0, 1]);
  assert.ok(Math.hypot(x0 - start.x, y0 - start.y) < 1e-6);
  assert.ok(Math.abs((x1 - x0) * 4 + (y1 - y0) * 3) < 1e-6); // y of the canvas goes down
  assert.ok(x1 > kSize || y1 < 0);
});

test('painter: numbers beyond all range are drawn as finite ones, those that are none not at all', () => {
  const { painter, lines } = recorder();
  painter.begin(lensOf(OrbitLens));
  painter.line([[1e300, -1e300, 1e308, 1], [-1e300, 1e200, 1, 1e-300]], { colour: 'red' });
  painter.line([[NaN, 0, 0, 1], [0, 0, 0, 1]], { colour: 'red' });
  painter.line([[Infinity, 0, 0, 1], [0, 0, 0, 1]], { colour: 'red' });
  for (const ends of lines) assert.ok(ends.flat().every(Number.isFinite), String(ends));
});

test('figure: an edge through w = 0 is two rays outwards, not the segment between its ends', () => {
  const { painter, lines } = recorder();
  const lens = lensOf(OrbitLens);
  const clip = [[-0.5, 0, 0, 1], [0.5, 0.25, 0, -1], [0.5, 0, 0, 1]]
    .map((position) => ({ position, attributes: [] }));
  const scene = { clip, steps: [], exact: null, answers: [{ polygon: null }, { polygon: null }],
                  state: { step: 0, frustum: { depth: 'minus_one_to_one' } } };
  painter.begin(lens);
  drawFigure(kCanonicalSpace, scene, { painter, lens, colours: { input: 'black' } });
  const [a, b, c] = [[-0.5, 0, 0, 1], [-0.5, -0.25, 0, 1], [0.5, 0, 0, 1]]
    .map((point) => project(lens, point));
  const isAt = (point) => ([x, y]) => Math.hypot(x - point.x, y - point.y) < 1e-6;
  // The other ends of what is drawn from a vertex.
  const from = (point) => lines.filter((ends) => ends.some(isAt(point)))
    .map((ends) => ends.find((end) => !isAt(point)(end)));
  // A + B is (0, 0.25, 0, 0): upwards, so the ray from A leaves at the top, that from B below.
  assert.ok(from(a).some(([, y]) => y < 0), JSON.stringify(from(a)));
  assert.ok(from(b).some(([, y]) => y > kSize), JSON.stringify(from(b)));
  assert.ok(from(a).some(isAt(c)));
  assert.ok(!from(a).some(isAt(b)) && !from(c).some(isAt(b)));
});

test('view space: the planes tell what is outside in each convention of depth', () => {
  const f = { depth: 'minus_one_to_one' };
  assert.deepEqual(outsideOf(f, [-2, 0, 0, 1]), [true, false, false, false, false, false]);
  assert.deepEqual(outsideOf(f, [0, 2, -2, 1]), [false, false, false, true, true, false]);
  assert.deepEqual(outsideOf({ depth: 'zero_to_one' }, [0, 0, -0.5, 1])[4], true);
  assert.deepEqual(outsideOf({ depth: 'reversed' }, [0, 0, -0.5, 1]).slice(4), [false, true]);
  assert.deepEqual(outsideOf({ depth: 'reversed' }, [0, 0, 1, 1]).slice(4), [false, false]);
});

test('floats: steps are 1, 2 or 5 times a power of ten, and multiples have no other digits', () => {
  assert.deepEqual([0.011, 0.02, 0.3, 1, 5.1, 700].map(floats.niceStep),
                   [0.02, 0.02, 0.5, 1, 10, 1000]);
  assert.equal(floats.toStep(0.29999, 0.1), 0.3);
  assert.equal(floats.toStep(-1.2345e-7, 2e-9), -1.24e-7);
  assert.ok(Object.is(floats.toStep(-0.01, 0.1), 0));
});

test('floats: a short decimal is rounded to the number that it stands for', () => {
  assert.equal(floats.shortest('float', Math.fround(0.1)), '0.1');
  assert.equal(floats.shortest('double', 0.1), '0.1');
  assert.equal(floats.shortest('float', 0.1), '0.1'); // a double that is no float stays as it is
  for (let i = 0; i < 10000; ++i) {
    const x = Math.fround((i + 0.37) ** 3 * 2 ** (i % 200 - 100));
    assert.equal(Math.fround(Number(floats.shortest('float', x))), x);
  }
});
