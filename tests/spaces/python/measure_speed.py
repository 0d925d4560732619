# SPDX-License-Identifier: GPL-3.0-or-later
"""What does a call from Python cost beside the same C++ call? Both with a reused output, in one process.

Not a test, since it needs an idle machine: PYTHONPATH=build/release/python:build/release/tests/spaces/python
/usr/bin/python3 measure_speed.py [ROUNDS]. 200,000 triangles in view space, float, by
homogeneous/sutherland_hodgman. Rounds time both in random order by the thread's processor time; printed are
ns per triangle and the median of the rounds' ratios with its 95 % interval (order statistics).
"""

import random
import sys
import time

import clipscope
import native_speed
import numpy as np

TRIANGLES = 200_000
FRUSTUM = (-1.0, 1.0, -1.0, 1.0, 1.0, 10.0)


def triangles_with(attributes: int) -> np.ndarray:
    """About half of those that are left are cut."""
    rng = np.random.default_rng(1)
    centres = rng.uniform((-4, -4, -11), (4, 4, 0), size=(TRIANGLES, 1, 3))
    positions = centres + rng.normal(scale=1.5, size=(TRIANGLES, 3, 3))
    values = rng.normal(size=(TRIANGLES, 3, attributes))
    return np.concatenate([positions, values], axis=2).astype(np.float32)


def nanoseconds(call) -> float:
    begin = time.thread_time_ns()
    call()
    return (time.thread_time_ns() - begin) / TRIANGLES


def interval(values: list[float]) -> tuple[float, float, float]:
    """The median and its 95 % interval."""
    ordered = sorted(values)
    count = len(ordered)
    reach = 0.98 * count**0.5
    return ordered[count // 2], ordered[max(0, int(count / 2 - reach))], ordered[min(count - 1, int(count / 2 + reach))]


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 31
    camera = clipscope.Frustum(*FRUSTUM)
    out = clipscope.Output()
    for attributes in (0, 2, 3, 4, 8):
        triangles = triangles_with(attributes)
        calls = {
            "Python": lambda: clipscope.clip(triangles, camera, weights=False, out=out),
            "C++": lambda: native_speed.clip_reused(triangles, list(FRUSTUM)),
        }
        assert len(calls["Python"]().vertices) == calls["C++"]()
        for call in calls.values():
            call()
        times: dict[str, list[float]] = {name: [] for name in calls}
        for _ in range(rounds):
            for name in random.sample(list(calls), 2):
                times[name].append(nanoseconds(calls[name]))
        ratios = [a / b for a, b in zip(times["Python"], times["C++"])]
        median, low, high = interval(ratios)
        ns = {name: interval(values)[0] for name, values in times.items()}
        print(
            f"{attributes} attributes: Python {ns['Python']:.1f} ns, C++ {ns['C++']:.1f} ns per triangle; "
            f"ratio {median:.3f} [{low:.3f}, {high:.3f}], {rounds} rounds"
        )


if __name__ == "__main__":
    main()
