# SPDX-License-Identifier: BSD-3-Clause
"""Renderings side by side, with titles and one colour bar."""

import math

import matplotlib.pyplot as plt
import numpy
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

import style


class Panel:
    """A picture, or None and the reason; with a title above and a line below."""

    def __init__(self, title, image=None, below="", reason=""):
        self.title, self.image, self.below, self.reason = title, image, below, reason


def save(panels, folder, name, columns=4, width=2.75, aspect=1.3, bar=None):
    """Draws the panels in a grid. \\a bar: (colours, limits, label) or None. Returns the path of the PNG."""
    columns = min(columns, len(panels))
    rows = math.ceil(len(panels) / columns)
    height = width / aspect + 0.52
    figure, axes = plt.subplots(
        rows, columns, figsize=(columns * width, rows * height + (0.55 if bar else 0)), squeeze=False, layout="constrained"
    )
    for axis in axes.flat:
        axis.set_axis_off()
    blank = numpy.full((100, int(100 * aspect), 3), 255, numpy.uint8)
    for axis, panel in zip(axes.flat, panels):
        _draw(axis, panel, blank)
    if bar:
        colours, limits, label = bar
        mappable = ScalarMappable(Normalize(*limits), colours)
        place = figure.colorbar(
            mappable,
            ax=axes,
            location="bottom",
            fraction=0.04,
            aspect=50,
            pad=0.02,
            shrink=min(1, 7 / (columns * width)),
            extend="max",
        )
        place.set_label(label)
        place.outline.set_visible(False)
    return style.save(figure, folder, name, dpi=180, trim=False)


def _draw(axis, panel, blank):
    axis.set_title(panel.title, loc="center", fontsize=9, pad=3)
    axis.imshow(blank if panel.image is None else panel.image, interpolation="antialiased")
    if panel.image is None:
        axis.text(
            0.5,
            0.5,
            f"gap\n{_wrapped(panel.reason)}",
            transform=axis.transAxes,
            ha="center",
            va="center",
            color="#8a8a8a",
            fontsize=7,
            style="italic",
        )
    if panel.below:
        axis.text(0.5, -0.02, panel.below, transform=axis.transAxes, ha="center", va="top", fontsize=7.5, color="#444444")


def _wrapped(text, width=34):
    lines = [""]
    for word in text.split():
        if len(lines[-1]) + len(word) > width:
            lines.append("")
        lines[-1] = (lines[-1] + " " + word).strip()
    return "\n".join(lines[:6])
