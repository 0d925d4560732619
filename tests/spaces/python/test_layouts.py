# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of any layout are read as they are; results look at memory that stays theirs."""

import gc
import sys
import tracemalloc
import unittest

import clipscope
import numpy as np
from inputs import FRUSTUM, same_bits, view_triangles

CAMERA = clipscope.Frustum(*FRUSTUM)


def layouts(array):
    """The same numbers at other places in memory."""
    yield "as it is", array
    yield "Fortran", np.asfortranarray(array)
    yield "reversed", array[::-1, ::-1, ::-1].copy()[::-1, ::-1, ::-1]
    wide = np.full((2 * len(array), 3, 3 * array.shape[2]), np.nan, array.dtype)
    wide[::2, :, ::3] = array
    yield "every other", wide[::2, :, ::3]
    yield "transposed", np.ascontiguousarray(array.transpose(2, 0, 1)).transpose(1, 2, 0)
    yield "swapped bytes", array.astype(array.dtype.newbyteorder())
    yield "unaligned", np.frombuffer(b"x" + array.tobytes(), array.dtype, offset=1).reshape(array.shape)
    read_only = array.copy()
    read_only.flags.writeable = False
    yield "read-only", read_only


class Inputs(unittest.TestCase):
    def test_the_layout_makes_no_difference(self):
        for dtype in (np.float32, np.float64):
            triangles = view_triangles(300, dtype)
            expected = clipscope.clip(triangles, CAMERA)
            for name, array in layouts(triangles):
                with self.subTest(layout=name, dtype=dtype):
                    found = clipscope.clip(array, CAMERA)
                    self.assertTrue(same_bits(found.vertices.copy(), expected.vertices.copy()))
                    self.assertTrue(same_bits(found.attributes.copy(), expected.attributes.copy()))

    def test_attributes_may_stand_beside(self):
        triangles = view_triangles(300, np.float32, 5)
        expected = clipscope.clip(triangles, CAMERA)
        found = clipscope.clip(triangles[..., :3].copy(), CAMERA, attributes=np.asfortranarray(triangles[..., 3:]))
        self.assertTrue(same_bits(found.attributes.copy(), expected.attributes.copy()))

    def test_other_numbers_become_double(self):
        for values in ([[[0, 0, -2], [1, 0, -2], [0, 1, -2]]], np.array([[[0, 0, -2], [1, 0, -2], [0, 1, -2]]], np.float16)):
            self.assertEqual(clipscope.clip(values, CAMERA).vertices.dtype, np.float64)
        single = clipscope.clip([[[0, 0, -2], [1, 0, -2], [0, 1, -2]]], CAMERA, scalar="float")
        self.assertEqual(single.vertices.dtype, np.float32)

    def test_nothing_is_copied_on_the_way_in(self):
        triangles = np.zeros((200_000, 3, 7), np.float64)  # behind the near plane: nothing comes out
        out = clipscope.Output()
        clipscope.clip(triangles, CAMERA, out=out)
        tracemalloc.start()
        clipscope.clip(triangles, CAMERA, out=out)
        clipscope.clip(triangles[::2, :, ::-1], CAMERA, out=out)
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        self.assertLess(peak, triangles.nbytes / 100)

    def test_none_at_all(self):
        for values in ([], np.zeros((0, 3, 5), np.float32)):
            found = clipscope.clip(values, CAMERA)
            self.assertEqual((len(found), found.offsets.tolist()), (0, [0]))
            self.assertEqual(found.fans().shape, (0, 3))

    def test_the_input_is_not_written(self):
        triangles = view_triangles(500, np.float32)
        before = triangles.copy()
        clipscope.clip(triangles, CAMERA)
        self.assertTrue(same_bits(triangles, before))


class Results(unittest.TestCase):
    def test_they_outlive_what_made_them(self):
        out = clipscope.Output()
        triangles = view_triangles(500, np.float32)
        found = clipscope.clip(triangles, CAMERA, out=out)
        kept = found.weights
        expected = kept.copy()
        del found, out, triangles
        gc.collect()
        self.assertTrue(same_bits(kept.copy(), expected))

    def test_a_held_result_is_never_overwritten(self):
        out = clipscope.Output()
        held = [clipscope.clip(view_triangles(400, np.float32, seed=s), CAMERA, out=out) for s in range(12)]
        for s, result in enumerate(held):
            fresh = clipscope.clip(view_triangles(400, np.float32, seed=s), CAMERA)
            self.assertTrue(same_bits(result.vertices.copy(), fresh.vertices.copy()))

    def test_the_memory_of_dropped_results_is_used_again(self):
        out = clipscope.Output()
        places = set()
        for s in range(10):
            result = clipscope.clip(view_triangles(400, np.float32), CAMERA, out=out)
            places.add(result.vertices.__array_interface__["data"][0])
        self.assertEqual(len(places), 2)  # the last one is held while the next is made

    def test_no_reference_is_left_behind(self):
        triangles = view_triangles(100, np.float32)
        out = clipscope.Output()
        before = sys.getrefcount(triangles)
        for _ in range(100):
            clipscope.clip(triangles, CAMERA, out=out)
            with self.assertRaises(ValueError):
                clipscope.clip(triangles, CAMERA, clipper="no such", out=out)
        self.assertEqual(sys.getrefcount(triangles), before)

    def test_memory_does_not_grow(self):
        triangles = view_triangles(20_000, np.float64)

        def megabytes():
            with open("/proc/self/statm") as file:
                return int(file.read().split()[1]) * 4096 / 1e6

        for _ in range(3):
            clipscope.clip(triangles, CAMERA)
        before = megabytes()
        for _ in range(30):
            clipscope.clip(triangles, CAMERA)
        self.assertLess(megabytes() - before, 10)

    def test_fans_cover_each_polygon(self):
        found = clipscope.clip(view_triangles(1000, np.float64), CAMERA)
        fans = found.fans()
        self.assertEqual(len(fans), (np.diff(found.offsets) - 2).sum())
        first = fans[0]
        self.assertEqual(first.tolist(), [0, 1, 2])
        polygon = np.searchsorted(found.offsets, fans, side="right") - 1
        self.assertTrue((polygon == polygon[:, :1]).all())
        for i in (0, len(found) // 2, -1):
            self.assertEqual(len(found[i]), np.diff(found.offsets)[i])


if __name__ == "__main__":
    unittest.main()
