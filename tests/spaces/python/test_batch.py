# SPDX-License-Identifier: GPL-3.0-or-later
"""The batch clippers: the three layouts agree, nothing is copied, results stay."""

import tracemalloc
import unittest

import clipscope
import numpy as np
from inputs import clip_triangles, same_bits


def polygons_of(staged):
    """{triangle: its vertices}."""
    parts = np.split(staged.vertices, staged.ends[:-1])
    return {int(t): part.tobytes() for t, part in zip(staged.source, parts)}


class Stage(unittest.TestCase):
    def test_it_has_the_bits_of_its_clipper_before_the_divide(self):
        triangles = clip_triangles(5000, np.float32)
        for depth in ("gl", "zero_to_one", "reversed"):
            staged = clipscope.stage(triangles, depth=depth)
            clipped = clipscope.clip(triangles, space="clip", depth=depth, weights=False)
            self.assertTrue(np.array_equal(staged.source, clipped.source))
            self.assertTrue(np.array_equal(staged.offsets, clipped.offsets))
            position = staged.vertices[:, :3] / staged.vertices[:, 3:4]
            inverse = np.float32(1) / staged.vertices[:, 3:4]
            divided = np.concatenate([position, inverse, staged.vertices[:, 4:]], axis=1)
            expected = np.concatenate([clipped.vertices, clipped.attributes], axis=1)
            for begin, end in zip(staged.offsets, staged.offsets[1:]):
                # A polygon begins at any of its vertices.
                self.assertEqual(
                    sorted(row.tobytes() for row in divided[begin:end]),
                    sorted(row.tobytes() for row in expected[begin:end]),
                )

    def test_the_layouts_agree(self):
        for method in clipscope.methods():
            for attributes in (0, 2, 5):
                with self.subTest(method=method.name, attributes=attributes):
                    triangles = clip_triangles(3000, np.float32, attributes)
                    rows = polygons_of(clipscope.stage(triangles, method=method.name))
                    streams = np.ascontiguousarray(triangles[..., :4].transpose(1, 2, 0))
                    beside = np.ascontiguousarray(triangles[..., 4:])
                    by_number = clipscope.stage(streams, layout="streams", attributes=beside, method=method.name)
                    vertices = triangles.reshape(-1, 4 + attributes)
                    mesh = clipscope.clip_mesh(vertices, np.arange(9000).reshape(-1, 3), method=method.name)
                    for other in (by_number, mesh):
                        self.assertGreater(len(other.inside), 10)
                        inside = {int(t): triangles[t].tobytes() for t in other.inside}
                        self.assertEqual({**polygons_of(other), **inside}, rows)

    def test_clip_distances_and_depth_clamp(self):
        triangles = clip_triangles(3000, np.float32)
        for options in ({"clip_distances": 2}, {"depth_clamp": True}, {"open_sides": True}):
            staged = clipscope.stage(triangles, **options)
            clipped = clipscope.clip(triangles, space="clip", weights=False, **options)
            self.assertTrue(np.array_equal(staged.source, clipped.source), options)

    def test_what_is_contiguous_is_not_copied(self):
        triangles = np.full((100_000, 3, 8), -1, np.float32)
        indices = np.arange(300_000, dtype=np.uint32)
        out = clipscope.Output()
        calls = (
            lambda: clipscope.stage(triangles, out=out),
            lambda: clipscope.clip_mesh(triangles.reshape(-1, 8), indices, out=out),
        )
        for call in calls:
            call()
            tracemalloc.start()
            call()
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            self.assertLess(peak, 100_000)

    def test_a_held_result_is_never_overwritten(self):
        out = clipscope.Output()
        held = [clipscope.stage(clip_triangles(1000, np.float32, seed=s), out=out) for s in range(9)]
        for s, result in enumerate(held):
            fresh = clipscope.stage(clip_triangles(1000, np.float32, seed=s))
            self.assertTrue(same_bits(result.vertices.copy(), fresh.vertices.copy()))


class Mesh(unittest.TestCase):
    def test_weights_make_the_new_vertices(self):
        vertices = clip_triangles(1000, np.float32, 2).reshape(-1, 6)
        vertices = vertices[np.isfinite(vertices).all(axis=1)]
        vertices[:, 3] = np.abs(vertices[:, 3]) + 0.1
        indices = np.random.default_rng(5).integers(0, len(vertices), (3000, 3))
        for method in clipscope.methods():
            for distances in (0, 1):
                with self.subTest(method=method.name, clip_distances=distances):
                    found = clipscope.clip_mesh(
                        vertices, indices, method=method.name, weights=True, clip_distances=distances
                    )
                    self.assertEqual(len(found.weights), len(found.vertices))
                    triangle = np.repeat(found.source, np.diff(found.offsets))
                    corners = vertices[indices[triangle]].astype(np.float64)
                    made = np.einsum("vj,vjc->vc", found.weights.astype(np.float64), corners)
                    size = np.abs(corners).max(axis=(1, 2))
                    error = np.abs(made - found.vertices).max(axis=1) / size
                    self.assertLess(error.max(), 100 * np.finfo(np.float32).eps)

    def test_a_matrix_projects(self):
        rng = np.random.default_rng(4)
        points = rng.normal(size=(300, 3)).astype(np.float32)
        indices = rng.integers(0, 300, (500, 3))
        matrix = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1.2, -2.2], [0, 0, -1, 0]], np.float32)
        projected = np.column_stack([points, np.ones(300, np.float32)]) @ matrix.T
        one = clipscope.clip_mesh(points, indices, matrix)
        other = clipscope.clip_mesh(projected, indices)
        self.assertTrue(np.array_equal(one.source, other.source))
        np.testing.assert_allclose(one.vertices, other.vertices, rtol=1e-5, atol=1e-5)

    def test_each_method_has_a_source(self):
        self.assertGreaterEqual(len(clipscope.methods()), 5)
        for method in clipscope.methods():
            self.assertTrue(method.summary and method.source)


if __name__ == "__main__":
    unittest.main()
