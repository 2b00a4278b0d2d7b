# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Fig. 10: two close sheets, cut across."""

import matplotlib.pyplot as plt
import numpy

import geometry
import style
from gallery import Model, lowest

CASES = (
    ("noisy", {"family": "noisy"}),
    ("paper's chain (PGU7, 5 and 7)", {"family": "ours", "name": "paper"}),
    ("ours: default", {"family": "ours", "name": "default"}),
)


def add(study, page, folder):
    page.heading("Fig. 10: two close sheets")
    name = study.find_model("two_sheets") or study.find_model("sheets")
    if not name:
        page.gap("Fig. 10", "the model sheets is not in this study")
        return
    try:
        model = Model(study, name)
    except geometry.Unreadable as error:
        page.gap("Fig. 10", str(error))
        return
    noise = "GN" if study.select(family="noisy", model=name, noise="GN") else (study.noises or ["GN"])[0]
    figure, axes = plt.subplots(len(CASES), 1, figsize=(10, 5.6), sharex=True, sharey=True, layout="constrained")
    told = []
    for axis, (title, wanted) in zip(axes, CASES):
        row = lowest(study.select(model=name, noise=noise, sigma=study.sigma, **wanted))
        path = study.path(row["cloud"]) if row else None
        axis.set_title(title + (f": p2s ratio {row['p2s_ratio']:.2f}" if path and row["family"] != "noisy" else ""))
        if path:
            _cut(axis, model, geometry.points_of(geometry.read_ply(path)))
            told.append(title)
        else:
            reason = study.why_missing(model=name, noise=noise, **wanted)
            axis.text(0.5, 0.5, f"gap: {reason}", transform=axis.transAxes, ha="center", color="#8a8a8a", style="italic")
    axes[-1].set_xlabel("mean edge lengths")
    image = style.save(figure, folder, "fig10")
    page.figure(
        image,
        (
            f"Fig. 10: two parallel sheets, {noise}, a slice across them; heights stretched. Lines: the clean surface; dots:"
            " points."
        ),
    )


def _frame(points):
    """Long, middle and thin axis."""
    _, axes = numpy.linalg.eigh(numpy.cov(points.T))
    return axes[:, 2], axes[:, 1], axes[:, 0]


def _cut(axis, model, points):
    long, middle, thin = _frame(model.points)
    centre = model.points.mean(axis=0)
    slab = numpy.abs((model.points - centre) @ middle) < 1.5 * model.edge
    clean, moved = (model.points[slab] - centre) / model.edge, (points[slab] - centre) / model.edge
    for side in (1, -1):
        sheet = clean[numpy.sign(clean @ thin) == side]
        if len(sheet):
            order = numpy.argsort(sheet @ long)
            axis.plot((sheet @ long)[order], (sheet @ thin)[order], color=style.GREY, linewidth=1)
    upper = numpy.sign(clean @ thin) > 0
    for chosen, colour in ((upper, style.BLUE), (~upper, style.RED)):
        axis.plot((moved @ long)[chosen], (moved @ thin)[chosen], ".", color=colour, markersize=4, alpha=0.8)
    axis.set_ylabel("height")
