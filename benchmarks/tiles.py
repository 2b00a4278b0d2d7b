#!/usr/bin/env python3
"""Measures the cost of tiles: pcl_normal_smoothing_tiles against pcl_normal_smoothing over the whole cloud, for some tile sizes.

usage: tiles.py <build folder> [--points 4000000] [--tiles 2,4,8,16,32] [--out benchmark_output] [--plot] [option of the tool]...

Every output is compared byte by byte with that of the whole cloud. Times are processor time summed over all threads, which a
shared machine affects least. Writes tiles.md, and tiles.png with --plot (which needs python3-matplotlib). Run nothing else
meanwhile."""
# SPDX-License-Identifier: BSD-3-Clause
import argparse
import filecmp
import os
import re
import subprocess
import sys
import tempfile

COLUMNS = ("points of a tile", "tiles", "loaded around", "plan, s", "run, s", "merge, s", "sum / whole cloud", "wall / whole cloud",
           "run, GB")


class Cost:
    """Cost of running a program: processor seconds, wall seconds, peak gigabytes, and what it printed."""

    def __init__(self, *words):
        begin = os.times().elapsed
        with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
            self.printed = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{' '.join(words)} ended with {process.returncode}")
        self.wall = os.times().elapsed - begin
        self.seconds = usage.ru_utime + usage.ru_stime
        self.gigabytes = usage.ru_maxrss / 1e6


def measure(tool, cloud, whole, tile_points, options):
    """One row of the table, as a dictionary by column name."""
    folder = os.path.dirname(cloud)
    plan, smoothed = os.path.join(folder, "tiles"), os.path.join(folder, "smoothed.pcd")
    tiles = tool + "_tiles"
    steps = (Cost(tiles, "plan", plan, cloud, "-max_points", str(tile_points), *options), Cost(tiles, "run", plan),
             Cost(tiles, "merge", plan, "-output", smoothed))
    if not filecmp.cmp(smoothed, whole.output, shallow=False):
        sys.exit(f"{tile_points} points a tile: not the points of the whole cloud")
    rows = re.findall(r"^tile \d+: (\d+) points, (\d+) around", steps[1].printed, re.MULTILINE)
    own, around = (sum(int(row[i]) for row in rows) for i in (0, 1))
    subprocess.run(["rm", "-r", plan, smoothed], check=True)
    return dict(zip(COLUMNS, (
        f"{max(int(row[0]) for row in rows):,}", len(rows), f"{around / own:.2f}", *(f"{step.seconds:.1f}" for step in steps),
        f"{sum(step.seconds for step in steps) / whole.seconds:.2f}", f"{sum(step.wall for step in steps) / whole.wall:.2f}",
        f"{steps[1].gigabytes:.2f}")))


def table(rows, whole, points):
    lines = [f"{points:,} points, of which the whole-cloud tool takes {whole.seconds:.1f} s of processor time, {whole.wall:.1f} s "
             f"of the clock and {whole.gigabytes:.2f} GB:\n", "| " + " | ".join(COLUMNS) + " |", "|---" * len(COLUMNS) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(row[column]) for column in COLUMNS) + " |" for row in rows]) + "\n"


def plot(rows, whole, points, path):
    import matplotlib  # only needed for a picture

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    sizes = [int(row[COLUMNS[0]].replace(",", "")) for row in rows]
    figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
    bottom = [0.0] * len(rows)
    for step, colour in (("run, s", "#0072B2"), ("plan, s", "#E69F00"), ("merge, s", "#009E73")):
        heights = [float(row[step]) / whole.seconds for row in rows]
        axes.bar(range(len(rows)), heights, 0.6, bottom, color=colour, label=step.split(",")[0])
        bottom = [low + height for low, height in zip(bottom, heights)]
    axes.plot(range(len(rows)), [1 + float(row["loaded around"]) for row in rows], "o--", color="#222222",
              label="points loaded / points")
    axes.axhline(1, color="#7a7a7a", linewidth=1)
    axes.set_xticks(range(len(rows)), [f"{size / 1e6:.2g}" for size in sizes])
    axes.set(xlabel="million points of a tile", ylabel="processor time / whole cloud",
             title=f"Smoothing {points / 1e6:g} million points in tiles")
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, loc="upper left", bbox_to_anchor=(1, 1))
    figure.savefig(path, dpi=130)


def main():
    parser = argparse.ArgumentParser(description="Measures what tiles cost.")
    parser.add_argument("build")
    parser.add_argument("--points", type=int, default=4_000_000)
    parser.add_argument("--tiles", default="2,4,8,16,32", help="into how many tiles, about")
    parser.add_argument("--out", default="benchmark_output")
    parser.add_argument("--plot", action="store_true")
    arguments, options = parser.parse_known_args()
    tool = os.path.abspath(os.path.join(arguments.build, "tools", "pcl_normal_smoothing"))
    os.makedirs(arguments.out, exist_ok=True)
    os.environ["OMP_WAIT_POLICY"] = "passive"
    with tempfile.TemporaryDirectory(dir=arguments.out) as folder:
        cloud = os.path.join(folder, "cloud.pcd")
        Cost(os.path.join(arguments.build, "test", "reliability", "large_cloud"), cloud, str(arguments.points))
        whole_cloud = os.path.join(folder, "whole.pcd")
        whole = Cost(tool, cloud, whole_cloud, *options)
        whole.output = whole_cloud
        rows = [measure(tool, cloud, whole, arguments.points // int(tiles), options) for tiles in arguments.tiles.split(",")]
    text = table(rows, whole, arguments.points)
    print(text, end="")
    with open(os.path.join(arguments.out, "tiles.md"), "w", encoding="utf-8") as file:
        file.write(text)
    if arguments.plot:
        plot(rows, whole, arguments.points, os.path.join(arguments.out, "tiles.png"))


if __name__ == "__main__":
    main()
