# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of doc/choosing.md, small PNGs, from a finished study."""

import argparse
import os
import tempfile

import gallery
import main_results
import numpy
import panels
import PIL.Image
import sheets
from off_screen import display
from page import Page
from scene import Stage, coloured
from study import Study
from summary import best_peer, entries

WIDTH, COLOURS = 1000, 256


def shrink(path, target, width=WIDTH, colours=COLOURS):
    """Writes the picture with fewer pixels and colours."""
    picture = PIL.Image.open(path).convert("RGB")
    height = round(picture.height * width / picture.width)
    picture = picture.resize((width, height), PIL.Image.LANCZOS)
    picture.quantize(colours, dither=PIL.Image.Dither.NONE).save(target, optimize=True)
    print(f"{target}: {os.path.getsize(target) // 1024} kB")


def strip(study, stage, model_name, noise, work):
    """The noisy cloud, the paper's preset, the best peer and our presets in a row, coloured by distance."""
    model = gallery.Model(study, model_name)
    where = {"model": model_name, "noise": noise, "sigma": study.sigma}
    peer = best_peer(entries(study, **where))
    rows = [("noisy", gallery.lowest(study.select(family="noisy", **where)))]
    rows.append(("preset paper", gallery.lowest(study.select(family="ours", name="paper", **where))))
    if peer:
        rows.append((f"best peer: {peer.label.split(':')[0]}", gallery.lowest(peer.rows)))
    rows += [
        (f"preset {name}", gallery.lowest(study.select(family="ours", name=name, **where))) for name in ("fast", "default")
    ]
    limit = float(numpy.percentile(gallery.distances_in_edges(model, model.cloud(study.path(rows[0][1]["cloud"]))), 95))

    def draw(stage, model, points):
        values = gallery.distances_in_edges(model, points)
        data = gallery.geometry.surface(points, model.triangles)
        return stage.draw([coloured(data, values, (0, limit), gallery.DISTANCE[1])], model.view)

    shown = [gallery.panel(study, stage, model, title, row, "not in the study", draw) for title, row in rows]
    bar = (gallery.DISTANCE[1], (0, limit), gallery.DISTANCE[0])
    return panels.save(shown, work, model_name, columns=5, width=2.2, aspect=model.view.aspect(), bar=bar)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study")
    parser.add_argument("images", help="folder of the pictures")
    parser.add_argument("-tools", required=True, help="folder of the built tools")
    parser.add_argument("-models", default="fandisk,elephant", help="of the strips")
    parser.add_argument("-noise", default="GN", help="GN or GR")
    options = parser.parse_args()
    study = Study(options.study)
    os.makedirs(options.images, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        counts = {name: len(study.select(model=name, noise=options.noise, family="peer")) for name in study.models}
        studied = [name for name, count in counts.items() if count == max(counts.values())]  # fully studied models
        no_gaps = {"ours", "peer", "noisy"} | ({"sweep"} if study.select(family="sweep") else set())
        by_model = {
            name: [e for e in entries(study, model=name, noise=options.noise, sigma=study.sigma) if e.group in no_gaps]
            for name in studied
        }
        shrink(main_results.dots(by_model, work, "results"), os.path.join(options.images, "choosing_results.png"))
        with display(), Stage(height=420) as stage:
            for name in options.models.split(","):
                path = strip(study, stage, study.find_model(name), options.noise, work)
                shrink(path, os.path.join(options.images, f"choosing_{name}.png"))
        sheets.add(study, Page("", ""), work, options.tools)
        shrink(os.path.join(work, "fig10.png"), os.path.join(options.images, "choosing_sheets.png"))


if __name__ == "__main__":
    main()
