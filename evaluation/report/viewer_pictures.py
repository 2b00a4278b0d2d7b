# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of README.md and doc/viewer.md that the viewer takes: of a part and of a scan."""

import argparse
import os
import tempfile

from doc_pictures import shrink
from running import run


def take(tools, work, target, *arguments, height=900):
    """Takes a picture with the viewer, and shrinks it."""
    picture = os.path.join(work, "picture.png")
    run(tools, "pcl_normal_smoothing_viewer", *arguments, "-screenshot", picture, "-width", 1600, "-height", height)
    shrink(picture, target, colours=64)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh", help="clean: models/csg_part.ply of a study")
    parser.add_argument("scan", help="a real scan: table_scene_mug_stereo_textured.pcd of PCL's test data")
    parser.add_argument("images", help="folder of the pictures")
    parser.add_argument("-tools", required=True, help="folder of the built tools")
    options = parser.parse_args()
    os.environ.pop("DISPLAY", None)  # the viewer's own display gives the same pictures everywhere
    with tempfile.TemporaryDirectory() as work:
        noisy = os.path.join(work, "part.ply")
        run(options.tools, "pcl_add_surface_noise", options.mesh, noisy, "-sigma", 0.2, "-seed", 1)
        take(options.tools, work, os.path.join(options.images, "viewer.png"), noisy, options.mesh, "-color_by", "distance")
        scan = (options.scan, "-color_by", "curvature")
        take(options.tools, work, os.path.join(options.images, "scan.png"), *scan, height=800)


if __name__ == "__main__":
    main()
