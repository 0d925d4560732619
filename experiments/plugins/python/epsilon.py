#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A clipper as a program of clipscope: all six planes before the divide.

Its bug is in many clippers: a small number in the denominator, "so that it is never zero". It never
is, since the two distances have different signs; and each new vertex lies a little off its plane.
"""
import math
import os
import sys

EPSILON = 1e-3
ATTRIBUTES = int(os.environ.get("CLIPSCOPE_ATTRIBUTES", 0))
PLANES = [(axis, side) for axis in range(3) for side in (1, -1)]


def cut(polygon, axis, side):
    """The part where w + side * coordinate >= 0 (Sutherland and Hodgman, 1974)."""
    out = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        d_a, d_b = a[3] + side * a[axis], b[3] + side * b[axis]
        if d_a >= 0:
            out.append(a)
        if (d_a >= 0) != (d_b >= 0):
            t = d_a / (d_a - d_b + EPSILON)
            out.append([x + t * (y - x) for x, y in zip(a, b)])
    return out


def clip(triangle):
    """The triangle in clip space, x y z w and attributes; what is left of it, x y z 1/w."""
    if not all(math.isfinite(x) for vertex in triangle for x in vertex[:4]):
        return []
    for plane in PLANES:
        triangle = cut(triangle, *plane)
    if any(w <= 0 for _, _, _, w, *_ in triangle):
        return []
    return [[x / w, y / w, z / w, 1 / w, *rest] for x, y, z, w, *rest in triangle]


def main():
    print("triangle,vertex,x,y,z,inv_w", *(f"a{k}" for k in range(ATTRIBUTES)), sep=",")
    size = 4 + ATTRIBUTES
    for triangle, line in enumerate(sys.stdin):
        numbers = [float(word) for word in line.split()]
        vertices = [numbers[i : i + size] for i in range(0, 3 * size, size)]
        for vertex, values in enumerate(clip(vertices)):
            print(triangle, vertex, *values, sep=",")


if __name__ == "__main__":
    main()
