# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong arguments raise a ValueError that names the argument, what it is and what was expected."""

import math
import unittest

import clipscope
import numpy as np

CAMERA = clipscope.perspective(90, 1, 1, 100)
TRIANGLES = np.zeros((5, 3, 3))
CLIP = np.zeros((5, 3, 4), np.float32)
MESH = (np.zeros((4, 4), np.float32), [[0, 1, 2]])

# What is called, and what the message must hold.
WRONG = [
    (lambda: clipscope.clip(np.zeros((5, 2, 3)), CAMERA), ["triangles", "(5, 2, 3)", "(n, 3, 3 + k)"]),
    (lambda: clipscope.clip(np.zeros((5, 3, 3)), space="clip"), ["triangles", "(5, 3, 3)", "(n, 3, 4 + k)"]),
    (lambda: clipscope.clip(np.zeros((3, 3)), CAMERA), ["triangles", "(3, 3)", "(n, 3, 3 + k)"]),
    (lambda: clipscope.clip([[[1, 2], [3]]], CAMERA), ["triangles", "not an array of numbers"]),
    (lambda: clipscope.clip(np.zeros((5, 3, 3), complex), CAMERA), ["triangles", "complex128", "float64"]),
    (lambda: clipscope.clip([[["a", "b", "c"]] * 3], CAMERA), ["triangles", "dtype", "float32 or float64"]),
    (lambda: clipscope.clip(TRIANGLES), ["projection", "missing", "clip space"]),
    (lambda: clipscope.clip(CLIP, CAMERA, space="clip"), ["projection", "given with space='clip'"]),
    (lambda: clipscope.clip(TRIANGLES, np.eye(3)), ["projection", "(3, 3)", "(4, 4)"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, space="ndc"), ["space", "'ndc'", "'view' or 'clip'"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, clipper="homogenous/pipelin"), ["clipper", "did you mean homogeneous/pipeline"]),
    (lambda: clipscope.clip(CLIP, space="clip", clipper="view/exact_sign"), ["clipper", "view/exact_sign", "projection="]),
    (lambda: clipscope.clip(TRIANGLES, np.eye(4), clipper="view/exact_sign"), ["clipper", "view/exact_sign", "Frustum"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, clipper="barycentric/correctly_rounded"), ["scalar", "float alone"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, scalar="half"), ["scalar", "'half'", "'float' or 'double'"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, scalar=np.int32), ["scalar", "'float' or 'double'"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, depth="d3d"), ["depth", "'d3d'", "'zero_to_one'"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, depth_clamp="both"), ["depth_clamp", "'both'", "'near' or 'far'"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, open_sides="front"), ["open_sides", "'front'", "left, right"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, clip_distances=1), ["clip_distances", "1", "0 attributes"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, clip_distances=9), ["clip_distances", "9", "0 to 8"]),
    (lambda: clipscope.clip(np.zeros((1, 3, 33)), CAMERA), ["attributes", "33", "32 at most"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, attributes=np.zeros((4, 3, 2))), ["attributes", "(4, 3, 2)", "(5, 3, k)"]),
    (lambda: clipscope.clip(np.zeros((5, 3, 4)), CAMERA, attributes=np.zeros((5, 3, 2))), ["triangles", "(5, 3, 4)", "3 numbers"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, threads=-1), ["threads", "-1", "0 to 1024"]),
    (lambda: clipscope.clip(TRIANGLES, CAMERA, threads=1.5), ["threads", "1.5", "whole number"]),
    (lambda: clipscope.segments(np.zeros((5, 3, 3)), CAMERA), ["segments", "(5, 3, 3)", "(n, 2, 3 + k)"]),
    (lambda: clipscope.points(np.zeros((5, 2)), CAMERA), ["points", "(5, 2)", "(n, 3 + k)"]),
    (lambda: clipscope.points(np.zeros((5, 3)), CAMERA, half_size=(-1, 0)), ["half_size", ">= 0"]),
    (lambda: clipscope.segments(np.zeros((1, 2, 3)), CAMERA, clipper="cvv/skala_polyhedron", depth_clamp=True), ["depth_clamp", "cvv/skala_polyhedron"]),
    (lambda: clipscope.polygons(np.zeros((5, 3)), [0, 4], CAMERA), ["offsets", "0 to 4", "5"]),
    (lambda: clipscope.polygons(np.zeros((5, 3)), [0, 4, 3, 5], CAMERA), ["offsets", "ascending"]),
    (lambda: clipscope.polygons(np.zeros((5, 3)), [0.0, 5.0], CAMERA), ["offsets", "float64", "integers"]),
    (lambda: clipscope.Frustum(1, -1, -1, 1, 1, 10), ["Frustum", "left < right"]),
    (lambda: clipscope.Frustum(-1, 1, -1, 1, 0, 10), ["near 0", "0 < near < far"]),
    (lambda: clipscope.Frustum(math.nan, 1, -1, 1, 1, 10), ["left is nan", "finite"]),
    (lambda: clipscope.clip(CLIP[..., :3], clipscope.Frustum(-1, 1, -1, 1, 1, 1 + 1e-12)), ["encloses no volume in float32"]),
    (lambda: clipscope.perspective(180, 1, 1), ["fov_y", "180", "between 0 and 180"]),
    (lambda: clipscope.clip_mesh(np.zeros((4, 3), np.float32), [[0, 1, 2]]), ["vertices", "(4, 3)", "(v, 4 + k)"]),
    (lambda: clipscope.clip_mesh(MESH[0], [[0, 1, 4]]), ["indices", "largest is 4", "less than 4"]),
    (lambda: clipscope.clip_mesh(MESH[0], [[0, 1, -1]]), ["indices", "from -1", "0 to 4294967295"]),
    (lambda: clipscope.clip_mesh(MESH[0], [0, 1, 2, 3]), ["indices", "(4,)", "(m, 3) or (3 m,)"]),
    (lambda: clipscope.clip_mesh(MESH[0], [[0.0, 1.0, 2.0]]), ["indices", "float64", "integers"]),
    (lambda: clipscope.clip_mesh(*MESH, matrix=np.eye(3)), ["matrix", "(3, 3)", "(4, 4)"]),
    (lambda: clipscope.clip_mesh(*MESH, method="fast"), ["method", "'fast'", "homogeneous/batch"]),
    (lambda: clipscope.stage(np.zeros((5, 3, 3), np.float32)), ["triangles", "(5, 3, 3)", "(n, 3, 4 + k)"]),
    (lambda: clipscope.stage(CLIP, layout="rows"), ["layout", "'rows'", "'vertices' or 'streams'"]),
    (lambda: clipscope.stage(CLIP, layout="streams"), ["triangles", "(5, 3, 4)", "(3, 4, n)"]),
    (lambda: clipscope.stage(CLIP, attributes=CLIP), ["attributes", "layout='vertices'"]),
    (lambda: clipscope.clippers("quad"), ["primitive", "'quad'", "'triangle'"]),
]  # fmt: skip


class Errors(unittest.TestCase):
    def test_each_message_says_what_where_and_what_would_be_right(self):
        for number, (call, parts) in enumerate(WRONG):
            with self.subTest(number=number, parts=parts):
                with self.assertRaises(ValueError) as caught:
                    call()
                for part in parts:
                    self.assertIn(part, str(caught.exception))

    def test_what_is_no_number_raises_nothing(self):
        triangles = np.full((3, 3, 3), np.nan)
        triangles[0] = np.inf
        self.assertEqual(len(clipscope.clip(triangles, CAMERA)), 0)


if __name__ == "__main__":
    unittest.main()
