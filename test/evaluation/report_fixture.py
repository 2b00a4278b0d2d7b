# SPDX-License-Identifier: BSD-3-Clause
"""Small studies with known numbers, in the format of pcl_smoothing_study."""

import csv
import itertools
import json
import math
import os

HEADER = (
    "model,points,noise,sigma,seed,family,name,parameters,k,normal_iterations,point_iterations,status,reason,seconds,E_A,E_k7,"
    "E_k15,E_k21,p2s_mean,p2s_rms,p2s_max,p2s_ratio,p2p_mean,p2p_ratio,normal_angle,edge_error,edge_fraction,spacing_p01,"
    "own_normal_angle,exact_mean,exact_ratio,cloud"
).split(",")


def row(model, noise, family, name, seed=1, **values):
    return {
        "model": model,
        "points": 81,
        "noise": noise,
        "sigma": 0.2,
        "seed": seed,
        "family": family,
        "name": name,
        "status": "ok",
        **values,
    }


def sweep(model, noise, area, curvature, ratio):
    """All 540 rows; the measures are functions of (estimator, weights, k, normal iterations, point iterations)."""
    rows = []
    for choice in itertools.product(("P", "WP", "H"), "TGM", (7, 15, 21), (2, 4, 8, 16, 32), (5, 10, 20, 40)):
        estimator, weights, k, normal, point = choice
        errors = {"E_A": area(*choice), "E_k7": curvature(*choice), "E_k15": curvature(*choice), "E_k21": curvature(*choice)}
        rows.append(
            row(
                model,
                noise,
                "sweep",
                f"{estimator}{weights}U{k}",
                k=k,
                normal_iterations=normal,
                point_iterations=point,
                p2s_ratio=ratio(*choice),
                seconds=0.5,
                **errors,
            )
        )
    return rows


def write_wave(path, height=0.0, ripple=0.0):
    """Writes a sheet of 81 points with a bump, as ASCII PLY; the ripple stands for noise."""
    side = range(9)
    with open(path, "w", encoding="utf-8") as file:
        file.write("ply\nformat ascii 1.0\nelement vertex 81\nproperty float x\nproperty float y\nproperty float z\n")
        file.write("element face 128\nproperty list uchar int vertex_indices\nend_header\n")
        for y, x in itertools.product(side, side):
            z = math.sin(x / 3) + 0.5 * math.cos(y / 2) + height + ripple * ((7 * x + 3 * y) % 5 - 2)
            file.write(f"{x} {y} {z}\n")
        for y, x in itertools.product(range(8), range(8)):
            corner = 9 * y + x
            file.write(f"3 {corner} {corner + 1} {corner + 10}\n3 {corner} {corner + 10} {corner + 9}\n")


def write_study(folder, rows, models=("double_torus",)):
    os.makedirs(os.path.join(folder, "models"), exist_ok=True)
    for model in models:
        write_wave(os.path.join(folder, "models", model + ".ply"))
    info = {
        "version": "1.2.3",
        "command_line": "pcl_smoothing_study <out>",
        "noises": ["GN", "GR"],
        "sigmas": [0.2],
        "seeds": [1, 2],
        "models": [{"name": m, "file": f"models/{m}.ply", "points": 81, "mean_edge": 1.1, "source": "test"} for m in models],
    }
    with open(os.path.join(folder, "study.json"), "w", encoding="utf-8") as file:
        json.dump(info, file)
    with open(os.path.join(folder, "rows.csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, HEADER, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def typical_rows(folder):
    """One model with both noises: ours for two seeds, the whole sweep for GN only, RIMLS, a peer that failed and one that is
    absent; some clouds are kept."""
    clouds = os.path.join(folder, "clouds", "case")
    os.makedirs(clouds, exist_ok=True)
    write_wave(os.path.join(clouds, "noisy.ply"), ripple=0.1)
    write_wave(os.path.join(clouds, "default.ply"), ripple=0.03)
    rows = []
    for noise, seed in itertools.product(("GN", "GR"), (1, 2)):
        first = seed == 1
        rows.append(
            row("double_torus", noise, "noisy", "noisy", seed, p2s_ratio=1, cloud="clouds/case/noisy.ply" if first else "")
        )
        for preset, ratio in (("default", 0.271), ("fast", 0.312), ("paper", 1.507)):
            cloud = "clouds/case/default.ply" if first and preset == "default" else ""
            rows.append(
                row(
                    "double_torus",
                    noise,
                    "ours",
                    preset,
                    seed,
                    p2s_ratio=ratio + 0.02 * (seed - 1),
                    own_normal_angle=20 * ratio,
                    exact_mean=0.01 * ratio,
                    exact_ratio=ratio + 0.1 * seed,
                    seconds=0.125,
                    cloud=cloud,
                )
            )
    rows += sweep(
        "double_torus",
        "GN",
        area=lambda e, w, k, n, p: 1e-3 * (1 + (e == "WP") + 2 * (k == 21) + 0.5 * "TGM".index(w)) + 1e-6 * p,
        curvature=lambda e, w, k, n, p: 1e-3 * (2 if (e, k) == ("P", 15) else 3) + 1e-6 * n,
        ratio=lambda e, w, k, n, p: 0.8 + 0.01 * p + 0.001 * n + 0.1 * "TGM".index(w),
    )
    for noise in ("GN", "GR"):
        errors = {"E_A": 9e-3, "E_k7": 4e-3, "E_k15": 4e-3, "E_k21": 4e-3}
        rows.append(
            row(
                "double_torus",
                noise,
                "peer",
                "RIMLS",
                parameters="filter scale 3, sharpness 0.75 (default)",
                p2s_ratio=0.617,
                **errors,
            )
        )
        rows.append(
            row("double_torus", noise, "peer", "RIMLS", parameters="filter scale 4, sharpness 1", p2s_ratio=0.543, **errors)
        )
        rows.append(
            row(
                "double_torus",
                noise,
                "peer",
                "LOP",
                parameters="h 3 (default)",
                status="failed",
                reason="timed out after 7 s <&>",
            )
        )
        rows.append(
            row(
                "double_torus",
                noise,
                "peer",
                "APSS",
                parameters="filter scale 2 (default)",
                status="absent",
                reason="meshlabserver is not installed",
            )
        )
    return rows
