# SPDX-License-Identifier: GPL-3.0-or-later
"""clipscope.exact: exact answers, verdicts on Python functions, cases, and what else it asks the program."""

import doctest
import os
import pathlib
import sqlite3
import struct
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

import clipscope
import numpy as np
from clipscope import exact as package
from clipscope.exact import bounds, camera, catalogue, exact, hunt, results, verify


def sutherland_hodgman(triangle, axes=3, epsilon=0.0):
    polygon = list(triangle.astype(np.float64))
    for axis in range(axes):
        for sign in (1, -1):
            kept = []
            for a, b in zip(polygon, polygon[1:] + polygon[:1]):
                d_a, d_b = a[3] + sign * a[axis], b[3] + sign * b[axis]
                if d_a >= 0:
                    kept.append(a)
                if (d_a >= 0) != (d_b >= 0):
                    kept.append(a + d_a / (d_a - d_b + epsilon) * (b - a))
            polygon = kept
    return polygon


def without_far_and_near(triangle):
    return sutherland_hodgman(triangle, axes=2)


def raises(triangle):
    raise RuntimeError("on purpose")


def correctly_rounded(triangles):
    return clipscope.clip(triangles, space="clip", clipper="barycentric/correctly_rounded", weights=False)


class Exact(unittest.TestCase):
    def test_it_is_rational(self):
        """The edge from (-2, 0, 0, 3) to (4, 0, 0, -3) meets x = w at t = 5/12: tests/corpus/w_sign.cases."""
        polygon = exact([[[-2, 0, 0, 3], [4, 0, 0, -3], [-2, 0.5, 0, 3]]], space="clip")[0]
        expected = {(Fraction(-2, 3), 0, 0, Fraction(1, 3)), (Fraction(-2, 3), Fraction(1, 6), 0, Fraction(1, 3)),
                    (1, 0, 0, 2), (1, Fraction(7, 12), 0, 2)}  # fmt: skip
        self.assertEqual(set(polygon), expected)

    def test_doubles_are_the_nearest(self):
        triangles = np.random.default_rng(1).normal(size=(50, 3, 4)) + [0, 0, 0, 1]
        rational = exact(triangles, space="clip", weights=True)
        nearest = exact(triangles, space="clip", weights=True, fractions=False)
        rows = np.concatenate([nearest.vertices, nearest.weights], axis=1)
        self.assertEqual(rows.tolist(), [[float(x) for x in v] for polygon in rational for v in polygon])
        self.assertEqual(nearest.source.tolist(), [i for i, p in enumerate(rational) if p])

    def test_weights_are_exact(self):
        triangle = [[0, -1, -2], [4, 0, -2], [0, 1, -2]]
        for vertex in exact([triangle], clipscope.Frustum(-1, 1, -1, 1, 1, 100), weights=True)[0]:
            weights = vertex[4:]
            self.assertEqual(sum(weights), 1)
            x, _, z = (sum(w * Fraction(p[c]) for w, p in zip(weights, triangle)) for c in range(3))
            self.assertEqual(x / -z, vertex[0])

    def test_correctly_rounded_is_the_nearest_float(self):
        triangles = np.random.default_rng(2).normal(size=(200, 3, 4)).astype(np.float32) + np.float32([0, 0, 0, 1])
        found = correctly_rounded(triangles)
        expected = exact(triangles, space="clip", fractions=False)
        self.assertEqual(found.source.tolist(), expected.source.tolist())
        for i in range(len(found)):
            rounded = {tuple(v) for v in expected[i].astype(np.float32).tolist()}
            self.assertTrue({tuple(v) for v in found[i].tolist()} <= rounded)

    def test_wrong_arguments(self):
        with self.assertRaisesRegex(ValueError, r"not finite at \[0, 1, 2\]"):
            exact([[[0, 0, 0, 1], [0, 0, np.nan, 1], [0, 1, 0, 1]]], space="clip")
        with self.assertRaisesRegex(ValueError, r"triangles: shape \(1, 2\)"):
            exact([[1, 2]], space="clip")
        self.assertEqual(exact(np.zeros((0, 3, 4)), space="clip"), [])


class Verify(unittest.TestCase):
    def test_a_right_function_keeps_what_is_asked(self):
        verdict = verify(sutherland_hodgman, answers="clip", triangles=200)
        self.assertTrue(verdict.kept, verdict)
        self.assertEqual(verdict.name, "python/sutherland_hodgman")
        self.assertGreater(verdict.judged, 150)
        self.assertIn("covers", verdict.holds)
        self.assertIsNone(verdict.shrunk)
        self.assertIsNone(verdict.error)

    def test_a_missing_plane_is_found_and_shrunk(self):
        verdict = verify(without_far_and_near, answers="clip", triangles=200)
        self.assertFalse(verdict.kept)
        self.assertIs(verdict["contained"].held, False)
        self.assertEqual(verdict["contained"].counterexample.shape[0], 3)
        self.assertEqual(verdict.shrunk.shape, (3, 4))
        # It is a counterexample: something of what is drawn lies beyond near or far.
        drawn = np.array(without_far_and_near(verdict.shrunk))
        self.assertTrue((np.abs(drawn[:, 2]) > drawn[:, 3]).any())
        self.assertIn("BROKEN", repr(verdict))
        page = verdict._repr_html_()
        for part in ("<table>", "contained", "Smallest counterexample", "python/without_far_and_near"):
            self.assertIn(part, page)

    def test_what_is_ours_is_judged_through_python_as_it_is(self):
        verdict = verify(correctly_rounded, batch=True, triangles=200, promises="correctly_rounded")
        self.assertTrue(verdict.kept, verdict)
        self.assertTrue(verdict["correctly_rounded"].held)
        self.assertTrue(verify("barycentric/correctly_rounded", triangles=100).kept)

    def test_an_exception_is_no_answer(self):
        verdict = verify(raises, triangles=20)
        self.assertIs(verdict["total"].held, False)
        self.assertIn("on purpose", verdict.error)
        self.assertIn("on purpose", verdict._repr_html_())

    def test_a_wrong_shape_is_no_answer(self):
        verdict = verify(lambda triangle: triangle[:, :3], triangles=20)
        self.assertIs(verdict["total"].held, False)
        self.assertIn("expected (m, 4)", verdict.error)

    def test_attributes_depths_and_view_space(self):
        told = set()

        def clip(triangles, against):
            told.add((against.space, against.depth))
            return clipscope.clip(
                triangles, against.projection, depth=against.depth, clipper="view/exact_sign", weights=False
            )

        verdict = verify(
            clip, batch=True, space="view", attributes=4, depth=("gl", "zero_to_one", "reversed"), triangles=0,
            catalogue=True,
        )  # fmt: skip
        self.assertTrue(verdict.kept, verdict)
        self.assertTrue(verdict["constants"].held)
        self.assertEqual(told, {("view", d) for d in ("gl", "zero_to_one", "reversed")})

    def test_double(self):
        given = set()

        def clip(triangle):
            given.add(triangle.dtype)
            return sutherland_hodgman(triangle)

        self.assertTrue(verify(clip, answers="clip", triangles=100, scalar="double").kept)
        self.assertEqual(given, {np.dtype(np.float64)})

    def test_wrong_arguments(self):
        for call, part in (
            (lambda: verify("no/such"), "no/such"),
            (lambda: verify(raises, space="ndc"), "'clip' or 'view'"),
            (lambda: verify(raises, answers="px"), "answers"),
            (lambda: verify(raises, depth="d3d"), "depth"),
            (lambda: verify(raises, triangles=0), "triangles"),
            (lambda: hunt(raises, "cm"), "measure"),
        ):
            with self.assertRaisesRegex(ValueError, part):
                call()

    def test_a_hunt_finds_what_lies_outside(self):
        worst = hunt(without_far_and_near, "containment", answers="clip", evaluations=300)
        self.assertGreater(worst.value, 0)
        self.assertEqual(worst.case.vertices.shape, (3, 4))
        self.assertEqual(worst.evaluations, 300)


class Catalogue(unittest.TestCase):
    def test_cases_come_out_as_they_say(self):
        cases = catalogue(primitive="triangle")
        self.assertGreater(len(cases), 100)
        for case in cases:
            points = {vertex[:3] for vertex in exact([case.vertices], **case.arguments())[0]}
            with self.subTest(case=case.name):
                if case.expected == "rejected":
                    self.assertEqual(points, set())
                elif (case.count or 3) >= 3:
                    self.assertEqual(len(points), case.count or 3)
                else:  # a point or a segment is left: nothing is drawn, or a polygon without area
                    self.assertIn(len(points), (0, case.count))

    def test_all_of_them_are_there(self):
        themes = {case.name.split("/")[0] for case in catalogue()}
        corpus = pathlib.Path(__file__).resolve().parents[2] / "corpus"
        self.assertEqual(themes, {path.stem for path in corpus.glob("*.cases")})
        for case in catalogue():
            self.assertTrue(case.source and case.why and len(case.vertices), case.name)
        with self.assertRaisesRegex(ValueError, "w_sign"):
            catalogue("no such")


class Rest(unittest.TestCase):
    def test_a_camera_is_read(self):
        found = camera(clipscope.perspective(60, 1.5, 0.25, 100))
        self.assertAlmostEqual(found["vertical_degrees"], 60, places=4)
        self.assertAlmostEqual(found["conventions"]["gl"]["near"]["value"], 0.25, places=4)

    def test_bounds(self):
        frustum = clipscope.Frustum(-1, 1, -1, 1, 1, 10)
        rows = bounds([("sphere", 13, 0, -14, 4.9), ("box", -1, -1, -5, 1, 1, -4)], frustum)
        self.assertEqual([row["exact"] for row in rows], ["rejected", "accepted"])
        with self.assertRaisesRegex(ValueError, "number 0, a box, has 3 numbers; expected 6"):
            bounds([("box", 1, 2, 3)], frustum)

    def test_results(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(FileNotFoundError):
                results(folder)
            store = sqlite3.connect(pathlib.Path(folder) / "results.sqlite")
            store.execute("CREATE TABLE accuracy(clipper TEXT, max_px REAL)")
            store.execute("INSERT INTO accuracy VALUES('a', 0.5), ('b', ?)", (struct.pack(">d", float("nan")),))
            store.commit()
            store.close()
            run = results(folder)
            self.assertEqual(list(run), ["accuracy"])
            columns = run.columns("accuracy")
            self.assertEqual(columns["clipper"], ["a", "b"])
            self.assertTrue(np.isnan(columns["max_px"][1]))
            self.assertEqual(list(run["accuracy"]), ["clipper", "max_px"])
            with self.assertRaisesRegex(KeyError, "there are accuracy"):
                run.columns("cost")

    def test_the_examples_in_the_help_run(self):
        for name in ("_exact", "_cases", "_camera"):
            found = doctest.testmod(sys.modules[f"clipscope.exact.{name}"])
            self.assertEqual(found.failed, 0)
            self.assertGreater(found.attempted, 0)
        self.assertIn("GPL", package.__doc__)

    def test_without_the_program_it_says_how_to_get_it(self):
        code = "import clipscope.exact as e; e.exact([[[0,0,0,1]]*3], space='clip')"
        environment = {**os.environ, "PATH": "/nowhere"}
        environment.pop("CLIPSCOPE_PROGRAM", None)
        ended = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
        self.assertIn("CLIPSCOPE_PROGRAM", ended.stderr)
        self.assertIn("experiments/run python", ended.stderr)


if __name__ == "__main__":
    unittest.main()
