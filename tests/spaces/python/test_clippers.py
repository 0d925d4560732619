# SPDX-License-Identifier: GPL-3.0-or-later
"""Every clipper gives in Python the bits that it gives in C++."""

import unittest

import clipscope
import native
import numpy as np
from inputs import DEPTHS, FRUSTUM, clip_triangles, same_bits, view_triangles

SCALARS = {"float": (np.float32, native.clip_float), "double": (np.float64, native.clip_double)}


class Bits(unittest.TestCase):
    def assert_same(self, found, expected, what):
        numbers, ends = expected
        counts = np.diff(ends, prepend=0)
        drawn = np.flatnonzero(counts)
        self.assertTrue(np.array_equal(found.source, drawn), what)
        self.assertTrue(np.array_equal(found.offsets, np.concatenate([[0], ends[drawn]])), what)
        rows = np.concatenate([found.vertices, found.attributes], axis=1)
        self.assertTrue(same_bits(rows, numbers), what)

    def each_clipper(self):
        for clipper in clipscope.clippers():
            for scalar in clipper.scalars:
                for depth in range(3):
                    yield clipper, *SCALARS[scalar], depth

    def test_view_space(self):
        for clipper, dtype, clip, depth in self.each_clipper():
            triangles = view_triangles(2000, dtype)
            found = clipscope.clip(
                triangles, clipscope.Frustum(*FRUSTUM), clipper=clipper.name, depth=DEPTHS[depth], weights=False
            )
            self.assert_same(found, clip(clipper.name, triangles, list(FRUSTUM), depth, 0), (clipper.name, dtype, depth))
            self.assertGreater(len(found), 50)

    def test_clip_space(self):
        for clipper, dtype, clip, depth in self.each_clipper():
            if "clip" not in clipper.spaces:
                continue
            triangles = clip_triangles(2000, dtype)
            found = clipscope.clip(
                triangles, space="clip", clipper=clipper.name, depth=DEPTHS[depth], weights=False
            )
            self.assert_same(found, clip(clipper.name, triangles, [], depth, 0), (clipper.name, dtype, depth))
            self.assertGreater(len(found), 50)

    def test_clip_distances(self):
        for clipper, dtype, clip, depth in self.each_clipper():
            if not clipper.clip_distances or depth != 0:
                continue
            triangles = view_triangles(1000, dtype)
            found = clipscope.clip(
                triangles, clipscope.Frustum(*FRUSTUM), clipper=clipper.name, clip_distances=2, weights=False
            )
            self.assert_same(found, clip(clipper.name, triangles, list(FRUSTUM), depth, 2), (clipper.name, dtype))

    def test_all_clippers_are_there(self):
        self.assertGreaterEqual(len(clipscope.clippers()), 27)
        self.assertGreaterEqual(len(clipscope.clippers("segment")), 24)
        self.assertEqual(len(clipscope.clippers("point")), 2)
        for primitive in ("triangle", "segment", "point"):
            for clipper in clipscope.clippers(primitive):
                self.assertTrue(clipper.summary and clipper.source)


class Attributes(unittest.TestCase):
    def test_any_number_of_them_changes_no_position(self):
        triangles = view_triangles(500, np.float32, 32)
        camera = clipscope.Frustum(*FRUSTUM)
        bare = clipscope.clip(triangles[..., :3], camera, weights=False)
        for count in range(33):
            found = clipscope.clip(triangles[..., : 3 + count], camera, weights=False)
            self.assertEqual(found.attributes.shape[1], count)
            self.assertTrue(same_bits(np.ascontiguousarray(found.vertices), np.ascontiguousarray(bare.vertices)))
            if count:
                first = clipscope.clip(triangles[..., :4], camera, weights=False).attributes
                self.assertTrue(np.array_equal(found.attributes[:, 0], first[:, 0]))


class OtherPrimitives(unittest.TestCase):
    def test_a_segment_is_cut_where_it_leaves(self):
        for clipper in clipscope.clippers("segment"):
            for scalar in clipper.scalars:
                with self.subTest(clipper=clipper.name, scalar=scalar):
                    frustum = clipscope.orthographic(-1, 1, -1, 1, 0, 4)
                    found = clipscope.segments(
                        [[[-2, 0, -2, 10], [2, 0, -2, 50]]], frustum, clipper=clipper.name, scalar=scalar
                    )
                    np.testing.assert_allclose(found[0], [[-1, 0, 0, 1], [1, 0, 0, 1]], atol=1e-6)
                    np.testing.assert_allclose(found.attributes[:, 0], [20, 40], rtol=1e-6)
                    np.testing.assert_allclose(found.weights, [[0.75, 0.25], [0.25, 0.75]], atol=1e-6)

    def test_a_point_stays_as_long_as_its_square(self):
        points = [[0, 0, 0, 1, 7], [1.5, 0, 0, 1, 8], [9, 0, 0, 1, 9]]
        pop = clipscope.points(points, space="clip")
        self.assertEqual(pop.source.tolist(), [0])
        free = clipscope.points(points, space="clip", clipper="point/pop_free", half_size=(1, 1))
        self.assertEqual(free.source.tolist(), [0, 1])
        self.assertEqual(free.attributes.ravel().tolist(), [7, 8])

    def test_a_polygon_of_three_vertices_is_a_triangle(self):
        for dtype in (np.float32, np.float64):
            triangles = clip_triangles(1000, dtype)
            one = clipscope.clip(triangles, space="clip", weights=False)
            offsets = np.arange(0, 3001, 3)
            other = clipscope.polygons(triangles.reshape(-1, 8), offsets, space="clip", threads=2)
            self.assertTrue(same_bits(one.vertices.copy(), other.vertices.copy()))
            self.assertTrue(same_bits(one.source, other.source))

    def test_a_polygon_in_view_space_is_projected(self):
        square = np.array([[-3, -1, -2], [3, -1, -2], [3, 1, -2], [-3, 1, -2]], np.float64)
        found = clipscope.polygons(square, [0, 4], clipscope.Frustum(-1, 1, -1, 1, 1, 10))
        self.assertEqual(sorted(map(tuple, found[0][:, :2].tolist())), [(-1, -0.5), (-1, 0.5), (1, -0.5), (1, 0.5)])


class Volume(unittest.TestCase):
    def test_depth_clamp_keeps_what_is_nearer(self):
        triangle = [[[0, 0, -2, 1], [0.5, 0, -2, 1], [0, 0.5, -2, 1]]]
        self.assertEqual(len(clipscope.clip(triangle, space="clip")), 0)
        self.assertEqual(len(clipscope.clip(triangle, space="clip", depth_clamp="near")), 1)
        self.assertEqual(len(clipscope.clip(triangle, space="clip", depth_clamp="far")), 0)
        self.assertEqual(len(clipscope.clip(triangle, space="clip", depth_clamp=True)), 1)

    def test_an_open_side_does_not_own_its_points(self):
        on_the_right = [[[1, 0, 0, 1], [1, 0.5, 0, 1], [1, 0, 0.5, 1]]]
        self.assertEqual(len(clipscope.clip(on_the_right, space="clip", depth_clamp=True)), 1)
        for sides in (True, "right", ["right", "top"]):
            self.assertEqual(len(clipscope.clip(on_the_right, space="clip", open_sides=sides)), 0)
        self.assertEqual(len(clipscope.clip(on_the_right, space="clip", open_sides="left")), 1)

    def test_a_matrix_is_a_projection(self):
        n, f = 1.0, 10.0
        matrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)], [0, 0, -1, 0]]
        triangles = view_triangles(500, np.float64)
        one = clipscope.clip(triangles, matrix)
        other = clipscope.clip(triangles, clipscope.Frustum(-1, 1, -1, 1, n, f))
        self.assertTrue(np.array_equal(one.source, other.source))
        np.testing.assert_allclose(one.vertices, other.vertices, rtol=1e-9, atol=1e-9)

    def test_an_infinite_far_plane(self):
        far_away = [[[0, 0, -1e9], [1e8, 0, -1e9], [0, 1e8, -1e9]]]
        self.assertEqual(len(clipscope.clip(far_away, clipscope.perspective(90, 1, 1))), 1)
        self.assertEqual(len(clipscope.clip(far_away, clipscope.perspective(90, 1, 1, 100))), 0)


if __name__ == "__main__":
    unittest.main()
