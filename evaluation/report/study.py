# SPDX-License-Identifier: BSD-3-Clause
"""The output folder of pcl_smoothing_study, as read by the report."""

import csv
import json
import math
import os

NUMBERS = (
    "points sigma seed k normal_iterations point_iterations seconds E_A E_k7 E_k15 E_k21 p2s_mean p2s_rms p2s_max "
    "p2s_ratio p2p_mean p2p_ratio normal_angle edge_error edge_fraction spacing_p01 own_normal_angle exact_mean exact_ratio"
).split()
TEXTS = "model noise family name parameters status reason cloud".split()
PAPER_SIGMA = 0.2


def number(text):
    """The finite number in a cell, or None."""
    try:
        value = float(text)
    except (TypeError, ValueError):
        return None
    return value if math.isfinite(value) else None


def mean(values):
    """Mean of the values that are not None; None if there are none."""
    there = [value for value in values if value is not None]
    return sum(there) / len(there) if there else None


def geometric_mean(values):
    """Geometric mean of the positive values; None if there are none."""
    there = [math.log(value) for value in values if value is not None and value > 0]
    return math.exp(sum(there) / len(there)) if there else None


def ordered(values):
    """Each value once, in the order of its first appearance."""
    return list(dict.fromkeys(value for value in values if value not in (None, "")))


class Study:
    """Rows are dictionaries by the columns of rows.csv: texts, and numbers or None. If a file is missing or damaged, there is
    less to report, and a note says so; no exception is raised."""

    def __init__(self, folder):
        self.folder = folder
        self.notes = []
        self.info = self._read_info(os.path.join(folder, "study.json"))
        self.rows = self._read_rows(os.path.join(folder, "rows.csv"))
        listed = [model for model in self.info.get("models") or [] if isinstance(model, dict) and model.get("name")]
        self.model_info = {model["name"]: model for model in listed}
        self.models = ordered(list(self.model_info) + [row["model"] for row in self.rows])
        self.noises = ordered((self.info.get("noises") or []) + [row["noise"] for row in self.rows])
        self.sigmas = ordered([number(s) for s in self.info.get("sigmas") or []] + [row["sigma"] for row in self.rows])
        self.seeds = ordered([number(s) for s in self.info.get("seeds") or []] + [row["seed"] for row in self.rows])
        self.sigma = min(self.sigmas, key=lambda sigma: abs(sigma - PAPER_SIGMA), default=PAPER_SIGMA)

    def _read_info(self, path):
        try:
            with open(path, encoding="utf-8") as file:
                info = json.load(file)
            return info if isinstance(info, dict) else {}
        except (OSError, ValueError) as error:
            self.notes.append(f"study.json cannot be read: {error}")
            return {}

    def _read_rows(self, path):
        rows, damaged = [], 0
        try:
            with open(path, newline="", encoding="utf-8", errors="replace") as file:
                for line in csv.DictReader(file):
                    if None in line or not line.get("model") or line.get("status") not in ("ok", "failed", "absent"):
                        damaged += 1  # the last line, if the study was killed
                        continue
                    row = {name: (line.get(name) or "").strip() for name in TEXTS}
                    row.update({name: number(line.get(name)) for name in NUMBERS})
                    rows.append(row)
        except (OSError, csv.Error) as error:
            self.notes.append(f"rows.csv cannot be read: {error}")
        if damaged:
            self.notes.append(f"{damaged} damaged line(s) of rows.csv are left out")
        return rows

    def select(self, status="ok", **wanted):
        """The rows whose columns equal the wanted values; status None: with any status."""
        return [
            row
            for row in self.rows
            if (status is None or row["status"] == status) and all(row[key] == value for key, value in wanted.items())
        ]

    def sweep(self, **wanted):
        """Rows of the 540 combinations of the paper, at the paper's sigma."""
        return self.select(family="sweep", sigma=self.sigma, **wanted)

    def find_model(self, name):
        """The model of that name, or one whose name begins with it (fandisk_subdivided), or None."""
        exact = [model for model in self.models if model.lower() == name]
        near = [model for model in self.models if model.lower().startswith(name)]
        return (exact + near + [None])[0]

    def path(self, relative):
        """Path of a file in the study's folder, or None if it does not exist."""
        path = os.path.join(self.folder, relative) if relative else None
        return path if path and os.path.isfile(path) else None

    def mesh(self, model):
        """Path of the clean mesh, or None."""
        return self.path(self.model_info.get(model, {}).get("file") or f"models/{model}.ply")

    def why_missing(self, **wanted):
        """Why there is no such row: the reasons of failed or absent ones, or that it was not run."""
        reasons = ordered(row["reason"] for row in self.select(status=None, **wanted) if row["status"] != "ok")
        return "; ".join(reasons) if reasons else "not in this study"


def method_of(row):
    """'PT' of PTU7, 'WPG' of WPGU21: the estimator and the weights."""
    return row["name"].split("U")[0]


def estimator_of(row):
    """P, WP or H."""
    return method_of(row)[:-1]


def weights_of(row):
    """T, G or M."""
    return method_of(row)[-1:]
