# SPDX-License-Identifier: BSD-3-Clause
"""The style of the figures, and saving them."""

import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (the backend comes first)
from matplotlib.ticker import LogLocator, NullLocator  # noqa: E402

# Okabe and Ito's colours, which colour-blind people can tell apart.
BLUE, ORANGE, GREEN, RED, PURPLE, SKY = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9"
GREY, DARK, LIGHT = "#7a7a7a", "#222222", "#e4e4e4"
ESTIMATOR_COLOURS = {"P": BLUE, "WP": GREEN, "H": ORANGE}
ESTIMATOR_NAMES = {"P": "PCA", "WP": "WPCA", "H": "Hough"}
WEIGHT_NAMES = {"T": "thresholded", "G": "Gaussian", "M": "mixed"}
GROUP_COLOURS = {"ours": RED, "sweep": BLUE, "peer": GREY, "noisy": DARK}
NOISE_NAMES = {"GN": "noise along normals (GN)", "GR": "noise in random directions (GR)"}
METHODS = [estimator + weights for estimator in ("P", "WP", "H") for weights in "TGM"]
NEIGHBOURS = (7, 15, 21)

plt.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 9, "axes.titlesize": 10, "axes.titleweight": "bold", "axes.titlelocation": "left",
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": "#999999", "axes.labelcolor": DARK,
    "axes.grid": True, "grid.color": LIGHT, "grid.linewidth": 0.7, "axes.axisbelow": True, "xtick.color": DARK,
    "ytick.color": DARK, "legend.frameon": False, "figure.facecolor": "white", "savefig.facecolor": "white",
    "svg.hashsalt": "pcl_normal_smoothing",
})  # fmt: skip


def model_title(name):
    """'double_torus' in readable form."""
    return name.replace("_", " ")


def plain_number(value, _place=None):
    """Formats 0.002, 0.5, 20: never as a power of ten."""
    return f"{value:.6f}".rstrip("0").rstrip(".") if value < 1 else f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def plain_ticks(axis):
    """Sets few ticks with plain numbers on an axis (axes.xaxis or axes.yaxis) that is already logarithmic."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 5), numticks=9))
    axis.set_major_formatter(plain_number)
    axis.set_minor_locator(NullLocator())


def legend_below(figure, axis, columns):
    """One legend for all axes, below them: saving includes what lies outside the figure."""
    figure.legend(*axis.get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0), ncols=columns)


def save(figure, folder, name, dpi=150, trim=True):
    """Writes <name>.png and <name>.svg and closes the figure. Returns the PNG's path. Trimming also includes what lies outside
    the figure, but takes twice as long."""
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, name + ".png")
    box = {"bbox_inches": "tight", "pad_inches": 0.08} if trim else {}
    figure.savefig(path, dpi=dpi, **box)
    figure.savefig(os.path.join(folder, name + ".svg"), dpi=dpi, metadata={"Date": None}, **box)
    plt.close(figure)
    return path
