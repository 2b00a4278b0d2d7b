# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Fig. 3: normals filtered without and with flips."""

import os
import tempfile

import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import geometry
import style
from gallery import Model, lowest
from panels import Panel, save
from running import ToolTrouble, run
from scene import View, coloured

K, ITERATIONS, WORST_DEGREES = 7, 4, 40


def add(study, page, folder, stage, tools):
    page.heading("Fig. 3: filtering normals without and with flips")
    name = study.find_model("double_torus") or (study.models or [None])[0]
    row = lowest(study.select(family="noisy", model=name, sigma=study.sigma))
    path = study.path(row["cloud"]) if row else None
    if not path:
        page.gap("Fig. 3", "the study keeps no noisy cloud to filter the normals of")
        return
    try:
        model = Model(study, name)
        fields = _fields(model.cloud(path), path, tools)
    except (geometry.Unreadable, ToolTrouble) as error:
        page.gap("Fig. 3", str(error))
        return
    truth = model.normals()
    points = model.cloud(path)
    near, view = _patch(model)
    panels = []
    for title, normals in fields:
        wrong = _angles(normals, truth)
        actors = [
            coloured(geometry.surface(points, model.triangles)),
            _needles(points, normals, wrong, near, 1.3 * model.edge),
        ]
        panels.append(Panel(title, stage.draw(actors, view), f"{wrong.mean():.1f}° off on average, over the whole model"))
    image = save(
        panels,
        folder,
        "fig3",
        columns=3,
        width=3.7,
        aspect=view.aspect(),
        bar=("turbo", (0, WORST_DEGREES), "angle to the true normal, whatever its sign, degrees"),
    )
    page.figure(
        image,
        (
            f"Fig. 3, {style.model_title(name)}, {row['noise']}: normals by WPCA, k {K}, each with a random sign, as an"
            f" eigenvector has; {ITERATIONS} iterations of the Gaussian filter. Needles go to the side that the normal"
            " points to: those into the surface are hidden."
        ),
    )


def _fields(points, path, tools):
    """Three pairs (title, normals): estimated, filtered without flips, filtered with flips."""
    with tempfile.TemporaryDirectory() as folder:
        estimated, mixed = os.path.join(folder, "estimated.ply"), os.path.join(folder, "mixed.ply")
        run(tools, "pcl_wpca_normal_estimation", path, estimated, "-k", K)
        normals = geometry.normals_of(geometry.read_ply(estimated))
        signs = numpy.random.default_rng(1).choice([-1.0, 1.0], size=(len(normals), 1))
        geometry.write_ply(mixed, points, signs * normals)
        fields = [("estimated normals, signs mixed", signs * normals)]
        for oriented, title in ((1, "filtered without flips"), (0, "filtered with flips")):
            filtered = os.path.join(folder, f"filtered_{oriented}.ply")
            run(
                tools,
                "pcl_bilateral_normal_filter",
                mixed,
                filtered,
                "-k",
                K,
                "-normal_iterations",
                ITERATIONS,
                "-sigma_s",
                0.3,
                "-oriented",
                oriented,
            )
            fields.append((title, geometry.normals_of(geometry.read_ply(filtered))))
    return fields


def _angles(normals, truth):
    """Angles in degrees, regardless of sign."""
    return numpy.degrees(numpy.arccos(numpy.clip(numpy.abs((normals * truth).sum(axis=1)), 0, 1)))


def _patch(model):
    """Selects a part of the points, small enough for single needles to be seen, and a view of it."""
    seen = model.view
    corner = model.points[(model.points @ (0.6 * seen.right + 0.5 * seen.up - 0.4 * seen.looking)).argmax()]
    away = numpy.linalg.norm(model.points - corner, axis=1)
    near = away < numpy.partition(away, min(len(away) - 1, 420))[min(len(away) - 1, 420)]
    return near, View(model.points[near], seen.looking, seen.up, margin=1.12)


def _needles(points, normals, values, chosen, length):
    starts, ends = points[chosen], points[chosen] + length * normals[chosen]
    holder, lines = vtkPoints(), vtkCellArray()
    for start, end in zip(starts, ends):
        lines.InsertNextCell(2)
        lines.InsertCellPoint(holder.InsertNextPoint(*start))
        lines.InsertCellPoint(holder.InsertNextPoint(*end))
    data = vtkPolyData()
    data.SetPoints(holder)
    data.SetLines(lines)
    actor = coloured(data, numpy.repeat(values[chosen], 2), (0, WORST_DEGREES), "turbo", flat=False)
    actor.GetProperty().SetLineWidth(2.2)
    actor.GetProperty().LightingOff()
    return actor
