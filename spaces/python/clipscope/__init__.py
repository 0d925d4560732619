# SPDX-License-Identifier: MIT
"""clipscope: triangles clipped in every space, by the real C++ clippers, bit for bit.

Start here:

    import numpy as np, clipscope

    triangles = np.array([[[0, -1, -2], [4, 0, -2], [0, 1, -2]]], np.float32)  # view space
    camera = clipscope.perspective(fov_y=90, aspect=1, near=1, far=100)
    result = clipscope.clip(triangles, camera)

    result[0]            # the polygon left of the first triangle: x, y, z in NDC, 1/w
    result.source        # which triangle each polygon is left of
    result.weights       # barycentric weights of each vertex: gradients flow through them
    result.fans()        # as triangles, to draw

What there is:

    clip                 triangles, by any of the clippers: clippers() lists them with their sources
    segments, points     the same for other primitives; polygons: convex ones of any size
    clip_mesh, stage     many triangles at once in SIMD, before the divide, as a renderer does it
    perspective, orthographic, Frustum   what is clipped against; or any matrix (4, 4)
    Output               memory that calls use again: clip(..., out=output)
    plot                 a result as a picture, where matplotlib is there

View space is right-handed, the eye at the origin, looking down -z. Clip space is (x, y, z, w)
before the divide, with w = -z of view space for perspective. A polygon has x, y, z in normalised
device coordinates (NDC), 1/w, and attributes as their true, perspective-correct values. The volume
is closed: a point on a plane is inside.

Arrays are float32 or float64, of any layout. Wrong arguments raise ValueError, which names the
argument, its shape and what was expected; NaN and infinity raise nothing and yield nothing. Calls
release the GIL and may be made by many threads.

This package is under the MIT licence. `import clipscope` loads nothing else; the exact reference and
the judge (GPL) are the submodule clipscope.exact, which you import yourself.
"""

from ._batch import Method, Staged, clip_mesh, methods, stage
from ._clip import Clipped, Clipper, Output, clip, clippers, points, polygons, segments
from ._plot import plot
from ._volume import Frustum, orthographic, perspective

__all__ = [
    "clip", "segments", "points", "polygons", "clippers", "Clipped", "Clipper", "Output",
    "clip_mesh", "stage", "methods", "Staged", "Method", "Frustum", "perspective", "orthographic", "plot",
]  # fmt: skip
__version__ = "0.1.0"
