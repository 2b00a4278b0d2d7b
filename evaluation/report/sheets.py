# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Fig. 10: two close sheets in cross-section."""

import os
import tempfile

import geometry
import matplotlib.pyplot as plt
import numpy
import style
from gallery import SHEETS, Model, lowest
from running import ToolTrouble, run

CASES = (
    ("noisy", {"family": "noisy"}),
    ("paper's chain (PGU7, 5 and 7)", {"family": "ours", "name": "paper"}),
    ("ours: default", {"family": "ours", "name": "default"}),
)
ORIENTED = "ours: default, with normals that point outwards (-normals input -oriented 1)"


def add(study, page, folder, tools):
    page.heading("Fig. 10: two close sheets")
    for name in SHEETS:
        try:
            _add_model(study, page, folder, tools, name)
        except geometry.Unreadable as error:
            page.gap(f"Fig. 10, {name}", str(error))


def _add_model(study, page, folder, tools, name):
    if name not in study.models:
        raise geometry.Unreadable(f"the model {name} is not in this study")
    model = Model(study, name)
    noise = "GN" if study.select(family="noisy", model=name, noise="GN") else (study.noises or ["GN"])[0]
    cuts = [(title, *_kept(study, model, noise, wanted)) for title, wanted in CASES]
    cuts.append((ORIENTED, *_oriented(model, cuts[0][1], tools)))
    heights = numpy.ptp(model.points @ _frame(model.points)[2]) / model.edge
    page.figure(
        _draw(model, cuts, folder, "fig10" if name == SHEETS[0] else f"fig10_{name}"),
        (
            f"Fig. 10: two parallel sheets, {heights:.1f} mean edge lengths apart, {noise}, a slice across them; heights"
            " stretched. Lines: the clean surface; dots: the points of either sheet. Neighbourhoods that reach across pull"
            " the sheets together, unless something tells them apart: last, estimated normals (WPCA, k 15), each turned to"
            " its sheet's outer side, as a scanner that saw it from there would."
        ),
    )


def _kept(study, model, noise, wanted):
    """(points, reason, p2s ratio); the points or the reason are None."""
    where = {"model": model.name, "noise": noise, "sigma": study.sigma, **wanted}
    row = lowest(study.select(**where))
    path = study.path(row["cloud"]) if row else None
    if not path:
        return None, "no cloud kept" if row else study.why_missing(**where), None
    try:
        return model.cloud(path), None, row["p2s_ratio"] if row["family"] != "noisy" else None
    except geometry.Unreadable as error:
        return None, str(error), None


def _oriented(model, noisy, tools):
    """As _kept(), for our default given normals oriented like those of the clean sheets."""
    if noisy is None:
        return None, "the noisy cloud is not in this study", None
    with tempfile.TemporaryDirectory() as folder:
        cloud, oriented, smoothed = (os.path.join(folder, name + ".ply") for name in ("cloud", "oriented", "smoothed"))
        try:
            geometry.write_ply(cloud, noisy, numpy.zeros_like(noisy))
            run(tools, "pcl_wpca_normal_estimation", cloud, oriented, "-k", 15)
            normals = geometry.normals_of(geometry.read_ply(oriented))
            signs = numpy.where((normals * model.normals()).sum(axis=1, keepdims=True) < 0, -1, 1)
            geometry.write_ply(oriented, noisy, signs * normals)
            run(tools, "pcl_normal_smoothing", oriented, smoothed, "-normals", "input", "-oriented", 1)
            points = model.cloud(smoothed)
        except (ToolTrouble, geometry.Unreadable) as error:
            return None, str(error), None
    before, after = (geometry.distances(cloud, model.data).mean() for cloud in (noisy, points))
    return points, None, after / before


def _draw(model, cuts, folder, name):
    figure, axes = plt.subplots(len(cuts), 1, figsize=(10, 6.6), sharex=True, sharey=True, layout="constrained")
    for axis, (title, points, reason, ratio) in zip(axes, cuts):
        axis.set_title(title + (f": p2s ratio {ratio:.2f}" if ratio is not None else ""))
        axis.set_ylabel("height")
        if points is not None:
            _cut(axis, model, points)
        else:
            axis.text(0.5, 0.5, f"gap: {reason}", transform=axis.transAxes, ha="center", color="#8a8a8a", style="italic")
    axes[-1].set_xlabel("mean edge lengths")
    return style.save(figure, folder, name)


def _frame(points):
    """The long, the middle and the thin axis of the points."""
    _, axes = numpy.linalg.eigh(numpy.cov(points.T))
    return axes[:, 2], axes[:, 1], axes[:, 0]


def _cut(axis, model, points):
    long, middle, thin = _frame(model.points)
    centre = model.points.mean(axis=0)
    slab = numpy.abs((model.points - centre) @ middle) < 1.5 * model.edge
    clean, moved = (model.points[slab] - centre) / model.edge, (points[slab] - centre) / model.edge
    upper = clean @ thin > 0
    for chosen, colour in ((upper, style.BLUE), (~upper, style.RED)):
        sheet = clean[chosen]
        order = numpy.argsort(sheet @ long)
        axis.plot((sheet @ long)[order], (sheet @ thin)[order], color=style.GREY, linewidth=1)
        axis.plot((moved @ long)[chosen], (moved @ thin)[chosen], ".", color=colour, markersize=4, alpha=0.8)
