# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Figs. 1, 4 and 5: every method on every model, coloured by two measures; one camera and one scale per model."""

import numpy

import geometry
import style
from panels import Panel, save
from scene import coloured, view_of
from summary import PEERS, combination, only_default

DISTANCE = ("distance to the clean surface, in mean edge lengths", "gist_heat_r")
SHEETS = ("two_sheets", "two_sheets_apart")
VARIATION = ("surface variation (k 15)", "viridis")


class Model:
    """The clean mesh of a model, and a view of it."""

    def __init__(self, study, name):
        path = study.mesh(name)
        if not path:
            raise geometry.Unreadable(f"models/{name}.ply is missing")
        self.name, self.data = name, geometry.read_ply(path)
        self.points, self.triangles = geometry.points_of(self.data), geometry.triangles_of(self.data)
        if not len(self.triangles):
            raise geometry.Unreadable(f"{path} holds no triangles")
        self.edge = geometry.mean_edge(self.points, self.triangles)
        self.view = view_of(self.points, self.triangles)

    def cloud(self, path):
        """The points of a result, which must be as many as the mesh has."""
        points = geometry.points_of(geometry.read_ply(path))
        if len(points) != len(self.points):
            raise geometry.Unreadable(f"{path} holds {len(points)} points, the mesh {len(self.points)}")
        return points

    def normals(self):
        """Normals of the vertices, weighted by triangle area."""
        corners = self.points[self.triangles]
        faces = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals = numpy.zeros_like(self.points)
        for corner in range(3):
            numpy.add.at(normals, self.triangles[:, corner], faces)
        return normals / numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-300)


def lowest(rows):
    """The row with a kept cloud and the lowest p2s ratio, or None."""
    kept = [row for row in rows if row["cloud"] and row["p2s_ratio"] is not None]
    return min(kept, key=lambda row: row["p2s_ratio"], default=None)


def shown_rows(study, model, noise):
    """A tuple (title, row or None, reason) for each picture of the comparison."""
    where = {"model": model, "noise": noise, "sigma": study.sigma}
    cases = [("noisy", "noisy", {"family": "noisy"})]
    cases += [(peer, "peer", {"family": "peer", "name": peer}) for peer in PEERS]
    cases += [("paper's chain", "sweep", {"family": "sweep"})]
    cases += [(f"ours: {preset}", "ours", {"family": "ours", "name": preset}) for preset in ("default", "fast")]
    shown = []
    for title, family, extra in cases:
        rows = study.select(**extra, **where)
        row = lowest(rows)
        if family in ("peer", "sweep"):
            title += ", default" if family == "peer" and only_default(rows) else ", best"
        shown.append((title, row, "no cloud kept" if rows else study.why_missing(**extra, **where)))
    return shown


def add(study, page, folder, stage, progress):
    page.text(
        "The clean mesh with its vertices where each method put them: same camera, same scale, same colours. Each peer, and"
        " the paper's chain, at the setting that came nearest to the surface (its default where no other was tried); below each"
        " picture its p2s ratio."
    )
    if not study.models:
        page.gap("renderings", "the study has no model")
    loaded = {}
    for name in study.models:
        try:
            loaded[name] = Model(study, name)
        except geometry.Unreadable as error:
            page.gap(f"renderings of {style.model_title(name)}", str(error))
    _add_first(study, page, folder, stage, loaded)
    for model in loaded.values():
        if model.name in SHEETS:
            continue  # from outside, one sheet hides the other: see the sections of Fig. 10
        progress(f"renderings of {model.name}")
        _add_model(study, page, folder, stage, model)


def _add_first(study, page, folder, stage, loaded):
    name = study.find_model("elephant") or next(iter(loaded), None)
    model = loaded.get(name)
    if not model:
        return
    page.heading("Fig. 1: original, perturbed, smoothed")
    panels = [Panel("original", _plain(stage, model, model.points))]
    for title, wanted in (("noisy", {"family": "noisy"}), ("ours: default", {"family": "ours", "name": "default"})):
        for noise in ("GN", "GR"):
            where = {"model": name, "noise": noise, "sigma": study.sigma, **wanted}
            row = lowest(study.select(**where))
            panels.append(panel(study, stage, model, f"{title}, {noise}", row, study.why_missing(**where), _plain))
    path = save(panels, folder, "fig1", columns=5, width=2.4, aspect=model.view.aspect())
    page.figure(
        path,
        (
            f"Fig. 1: {style.model_title(name)}. Original; noise along normals and in random directions; smoothed by our"
            " default."
        ),
    )


def _plain(stage, model, points):
    return stage.draw([coloured(geometry.surface(points, model.triangles))], model.view)


def panel(study, stage, model, title, row, reason, draw):
    path = study.path(row["cloud"]) if row else None
    if not path:
        return Panel(title, reason=f"{row['cloud']} is missing" if row else reason)
    try:
        points = model.cloud(path)
    except geometry.Unreadable as error:
        return Panel(title, reason=str(error))
    below = f"p2s ratio {row['p2s_ratio']:.3f}" if row["family"] != "noisy" and row["p2s_ratio"] is not None else ""
    if row["family"] == "sweep":
        title = f"{title} ({combination(row)})"
    return Panel(title, draw(stage, model, points), below)


def _add_model(study, page, folder, stage, model):
    noise = "GR" if study.select(family="noisy", model=model.name, noise="GR") else (study.noises or ["GR"])[0]
    shown = shown_rows(study, model.name, noise)
    noisy = next((row for title, row, _ in shown if title == "noisy"), None)
    path = study.path(noisy["cloud"]) if noisy else None
    page.heading(f"{style.model_title(model.name).capitalize()}, {style.NOISE_NAMES.get(noise, noise)}")
    if not path:
        page.gap(f"renderings of {style.model_title(model.name)}", "the noisy cloud is not in this study")
        return
    noisy_points = model.cloud(path)
    for (label, colours), measure, name in (
        (DISTANCE, distances_in_edges, "distance"),
        (VARIATION, _variation, "variation"),
    ):
        limit = float(numpy.percentile(measure(model, noisy_points), 95))

        def draw(stage, model, points):
            data = geometry.surface(points, model.triangles)
            return stage.draw([coloured(data, measure(model, points), (0, limit), colours)], model.view)

        panels = [Panel("original", draw(stage, model, model.points))]
        panels += [panel(study, stage, model, title, row, reason, draw) for title, row, reason in shown]
        path = save(
            panels, folder, f"{model.name}_{noise}_{name}", aspect=model.view.aspect(), bar=(colours, (0, limit), label)
        )
        page.figure(
            path,
            (
                f"{style.model_title(model.name).capitalize()}, {noise}, coloured by {label}. The scale ends where 95 % of"
                " the noisy points lie below."
            ),
        )


def distances_in_edges(model, points):
    return geometry.distances(points, model.data) / model.edge


def _variation(model, points):
    return geometry.surface_variation(points)
