# SPDX-License-Identifier: MIT
"""Pictures of results, where matplotlib is there."""

from __future__ import annotations

from typing import Any, Optional

from ._clip import Clipped


def plot(result: Clipped, ax: Optional[Any] = None, **style: Any) -> Any:
    """Draws the polygons of a result in NDC, and the sides of the view volume. Returns the axes.

    ax: matplotlib axes to draw into [new ones]; style: for matplotlib's Polygon. Raises ImportError
    without matplotlib (Debian: python3-matplotlib).
    """
    try:
        from matplotlib import pyplot
        from matplotlib.patches import Polygon
    except ImportError:
        raise ImportError("plot needs matplotlib (Debian: python3-matplotlib)") from None
    if ax is None:
        ax = pyplot.figure().add_subplot()
    ax.add_patch(Polygon([[-1, -1], [1, -1], [1, 1], [-1, 1]], fill=False, linestyle="--", color="grey"))
    look = {"alpha": 0.4, "edgecolor": "black", **style}
    for i in range(len(result)):
        ax.add_patch(Polygon(result[i][:, :2], **look))
    ax.set(xlim=(-1.2, 1.2), ylim=(-1.2, 1.2), aspect="equal", xlabel="x (NDC)", ylabel="y (NDC)")
    return ax
