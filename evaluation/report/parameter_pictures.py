# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of the class pages in doc/: what the two extremes of each parameter do to one noisy part."""

import argparse
import os
import tempfile

import geometry
import gallery
import numpy
import panels
from doc_pictures import shrink
from off_screen import display
from running import run
from scene import Stage, coloured
from vtkmodules.util.numpy_support import numpy_to_vtk

NOISE = 0.2  # mean edge lengths
MOVED = ("distance to the clean surface, in mean edge lengths", "gist_heat_r", (0, 0.4))
TURNED = ("angle to the true normal, in degrees", "gist_heat_r", (0, 40))
K = ("-k", 15)

# page: (what the colours show, commands in the order in which they run, (title, options of the last command)...)
# {sigma} and {edge} are the noise and the mean edge length, in the cloud's unit.
PAGES = {
    "normal_smoothing": (MOVED, (("pcl_normal_smoothing",),), (
        ("k 8", "-k 8"), ("k 32", "-k 32"),
        ("1 round", "-point_iterations 1"), ("6 rounds", "-point_iterations 6"),
        ("noise sigma / 4", "-noise_sigma {quarter}"), ("noise sigma x 4", "-noise_sigma {fourfold}"),
        ("displacement up to sigma / 2", "-max_displacement {half}"), ("up to 5 sigma", "-max_displacement {five}"),
        ("sheet distance sigma / 4", "-sheet_distance {quarter}"), ("sheet distance infinite", "-sheet_distance inf"),
        ("preset fast", "-preset fast"), ("preset paper", "-preset paper"),
    )),
    "wpca_normal_estimation": (TURNED, (("pcl_wpca_normal_estimation",),), (
        ("k 5", "-k 5"), ("k 60", "-k 60"),
        ("radius 1.2 edges", "-radius {near}"), ("radius 4 edges", "-radius {far}"),
    )),
    "hough_normal_estimation": (TURNED, (("pcl_hough_normal_estimation",),), (
        ("k 10", "-k 10"), ("k 100", "-k 100"),
        ("tolerance 0.5", "-k 50 -tolerance 0.5"), ("tolerance 0.05", "-k 50 -tolerance 0.05"),
        ("4 bands", "-k 50 -bands 4"), ("60 bands", "-k 50 -bands 60"),
        ("1 rotation", "-k 50 -rotations 1"), ("10 rotations", "-k 50 -rotations 10"),
        ("confidence 0.1", "-k 50 -confidence 0.1"), ("confidence 0.999", "-k 50 -confidence 0.999"),
    )),
    "bilateral_normal_filter": (TURNED, (("pcl_wpca_normal_estimation", *K), ("pcl_bilateral_normal_filter",)), (
        ("k 6", "-k 6"), ("k 60", "-k 60"),
        ("sigma_s 0.05", "-k 15 -sigma_s 0.05"), ("sigma_s 2", "-k 15 -sigma_s 2"),
        ("1 iteration", "-k 15 -normal_iterations 1"), ("40 iterations", "-k 15 -normal_iterations 40"),
        ("THRESHOLD, T 0", "-k 15 -weights threshold -threshold 0"),
        ("THRESHOLD, T 0.98", "-k 15 -weights threshold -threshold 0.98"),
        ("MIXED, PRINTED", "-k 15 -weights mixed -mixed printed"), ("MIXED, RMS", "-k 15 -weights mixed -mixed rms"),
    )),
    "normal_guided_point_update": (MOVED, (("pcl_wpca_normal_estimation", *K), ("pcl_bilateral_normal_filter", *K),
                                           ("pcl_normal_guided_point_update",)), (
        ("k 6", "-k 6"), ("k 60", "-k 60"),
        ("sigma_s 0.001", "-k 15 -update_sigma_s 0.001"), ("sigma_s 1", "-k 15 -update_sigma_s 1"),
        ("1 iteration", "-k 15 -point_iterations 1"), ("20 iterations", "-k 15 -point_iterations 20"),
        ("PAPER, 20 iterations", "-k 15 -update paper -point_iterations 20"),
        ("displacement up to sigma / 2", "-k 15 -max_displacement {half}"),
    )),
}  # fmt: skip


def lengths(model):
    sigma = NOISE * model.edge
    return {"quarter": sigma / 4, "half": sigma / 2, "fourfold": 4 * sigma, "five": 5 * sigma,
            "near": 1.2 * model.edge, "far": 4 * model.edge}  # fmt: skip


def image(stage, model, cloud, kind):
    """Renders the surface: with its vertices at the points, coloured by distance, or lit by the points' own normals."""
    points = geometry.points_of(cloud)
    _, colours, limits = kind
    if kind is MOVED:
        values = gallery.distances_in_edges(model, points)
        return stage.draw([coloured(geometry.surface(points, model.triangles), values, limits, colours)], model.view)
    normals, true = geometry.normals_of(cloud), model.normals()
    cosines = (normals * true).sum(axis=1)
    data = geometry.surface(points, model.triangles)
    lit = numpy.where(cosines[:, None] < 0, -normals, normals)
    data.GetPointData().SetNormals(numpy_to_vtk(numpy.ascontiguousarray(lit, dtype=numpy.float32), deep=True))
    angles = numpy.degrees(numpy.arccos(numpy.clip(numpy.abs(cosines), 0, 1)))
    return stage.draw([coloured(data, angles, limits, colours, flat=False)], model.view)


def draw_page(name, model, noisy, tools, stage, work):
    kind, commands, cases = PAGES[name]
    source = noisy
    for number, command in enumerate(commands[:-1]):
        source, before = os.path.join(work, f"{name}_{number}.ply"), source
        run(tools, command[0], before, source, *command[1:])
    shown = []
    for title, options in cases:
        result = os.path.join(work, "result.ply")
        run(tools, commands[-1][0], source, result, *options.format(**lengths(model)).split())
        shown.append(panels.Panel(title, image(stage, model, geometry.read_ply(result), kind)))
    label, colours, limits = kind
    bar = (colours, limits, label)
    return panels.save(shown, work, name, columns=4, width=2.4, aspect=model.view.aspect(), bar=bar)


class OneMesh:
    """Stands in for a study: provides one mesh file as its model."""

    def __init__(self, path):
        self.path = path

    def mesh(self, _name):
        return self.path


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh", help="clean, PLY: models/csg_part.ply of a study")
    parser.add_argument("images", help="folder of the pictures")
    parser.add_argument("-tools", required=True, help="folder of the built tools")
    parser.add_argument("-pages", default=",".join(PAGES), help="which")
    options = parser.parse_args()
    model = gallery.Model(OneMesh(options.mesh), "part")
    os.makedirs(options.images, exist_ok=True)
    with tempfile.TemporaryDirectory() as work, display(), Stage(height=360) as stage:
        noisy = os.path.join(work, "noisy.ply")
        run(options.tools, "pcl_add_surface_noise", options.mesh, noisy, "-type", "GN", "-sigma", NOISE, "-seed", 1)
        for name in options.pages.split(","):
            path = draw_page(name, model, noisy, options.tools, stage, work)
            shrink(path, os.path.join(options.images, f"parameters_{name}.png"), width=880, colours=64)


if __name__ == "__main__":
    main()
