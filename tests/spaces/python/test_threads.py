# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads change nothing but the time, and a call leaves the interpreter to others."""

import threading
import unittest

import clipscope
import numpy as np
from inputs import FRUSTUM, clip_triangles, same_bits, view_triangles

CAMERA = clipscope.Frustum(*FRUSTUM)


class Threads(unittest.TestCase):
    def test_the_result_does_not_depend_on_them(self):
        triangles = view_triangles(10_000, np.float32)
        expected = clipscope.clip(triangles, CAMERA)
        for threads in (0, 2, 3, 7):
            found = clipscope.clip(triangles, CAMERA, threads=threads)
            for name in ("vertices", "attributes", "offsets", "source", "weights"):
                self.assertTrue(same_bits(getattr(found, name).copy(), getattr(expected, name).copy()), name)

    def test_nor_does_that_of_the_stage(self):
        triangles = clip_triangles(20_000, np.float32)
        indices = np.arange(60_000, dtype=np.uint32)
        calls = (
            lambda threads: clipscope.stage(triangles, threads=threads),
            lambda threads: clipscope.clip_mesh(triangles.reshape(-1, 8), indices, threads=threads),
        )
        for call in calls:
            expected, found = call(1), call(3)
            for name in ("inside", "vertices", "ends", "source"):
                self.assertTrue(same_bits(getattr(found, name).copy(), getattr(expected, name).copy()), name)

    def test_other_threads_run_meanwhile(self):
        """A thread counts while a long call runs: it could not if the call kept the interpreter."""
        triangles = view_triangles(200_000, np.float64)
        counted = 0
        is_running = threading.Event()
        is_done = threading.Event()

        def count():
            nonlocal counted
            is_running.set()
            while not is_done.is_set():
                counted += 1

        counter = threading.Thread(target=count)
        counter.start()
        is_running.wait()
        # One switch of the interpreter's lock before the call and one after it are left.
        before = counted
        clipscope._clipscope.clip(*self.arguments(triangles))
        during = counted - before
        is_done.set()
        counter.join()
        self.assertGreater(during, 100)

    def arguments(self, triangles):
        options = clipscope._volume.volume_options("gl", False, 0, False)
        against = clipscope._volume.against(CAMERA, options, triangles.dtype)
        call = clipscope._clipscope.Options("textbook", True, 1)
        return triangles[..., :3], triangles[..., 3:], against, call, clipscope._clipscope.Output()

    def test_one_output_serves_many_threads(self):
        out = clipscope.Output()
        inputs = [view_triangles(2000, np.float32, seed=s) for s in range(8)]
        found = [None] * len(inputs)

        def work(i):
            for _ in range(20):
                found[i] = clipscope.clip(inputs[i], CAMERA, out=out)

        workers = [threading.Thread(target=work, args=(i,)) for i in range(len(inputs))]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        for triangles, result in zip(inputs, found):
            expected = clipscope.clip(triangles, CAMERA)
            self.assertTrue(same_bits(result.vertices.copy(), expected.vertices.copy()))


if __name__ == "__main__":
    unittest.main()
