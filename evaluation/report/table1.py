# SPDX-License-Identifier: BSD-3-Clause
"""Table I: our runs compared with the figures printed in the paper."""

import csv
import os

import claims
import style
from page import Gap, format_number
from summary import DEFAULT_MARK, combination, ranked

PRINTED = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "paper_table1.csv")
METHODS = ("LOP", "WLOP", "APSS", "RIMLS", "Ours")


def printed_rows():
    """Table I as the paper prints it: dictionaries with model, points, noise, method, parameters, E_A, E_k (not in 1e-3)."""
    with open(PRINTED, newline="", encoding="utf-8") as file:
        return [
            {
                **line,
                "E_A": float(line["E_A_1e-3"]) / 1e3,
                "E_k": float(line["E_k_1e-3"]) / 1e3,
                "points": int(line["points"]),
            }
            for line in csv.DictReader(file)
        ]


def our_row(study, model, noise, method):
    """The method's best row by E_A and E_k together, at the first seed; or None."""
    seed = min(study.seeds, default=None)
    where = {"model": model, "noise": noise, "sigma": study.sigma, "seed": seed}
    sweep = [row for row in study.select(family="sweep", **where) if row["E_A"] is not None and row["E_k15"] is not None]
    rows = sweep if method == "Ours" else study.select(family="peer", name=method, **where)
    return claims.best_combined(rows, sweep or rows)


def compared(study):
    """(printed row, our row or None) for each row of Table I, in its order."""
    pairs = []
    for printed in printed_rows():
        model = study.find_model(printed["model"])
        pairs.append((printed, our_row(study, model, printed["noise"], printed["method"]) if model else None))
    return pairs


def add(study, page):
    page.section("table1", "Table I: our runs beside the paper's figures")
    page.text(
        "The best of each method by E_A and E_k together, as the paper chose: the lowest sum of the two, each over its"
        " median in the sweep. E_k depends on the number of neighbours, which the paper does not give: all three are shown."
        " E in 1e-3. LOP, WLOP: support radius h, &mu;; APSS: filter scale, spherical parameter; RIMLS: filter scale,"
        " sharpness; ours: name, normal iterations, point iterations. The paper's LOP and WLOP lengths are in units of its"
        " own models."
    )
    pairs = compared(study)
    table = [_line(study, printed, row) for printed, row in pairs]
    rules = [index for index in range(len(pairs)) if index and index % len(METHODS) == 0]
    page.table(
        [
            "model",
            "noise",
            "method",
            "paper: parameters",
            "paper: E_A",
            "paper: E_k",
            "rerun: parameters",
            "E_A",
            "E_k, k 7",
            "k 15",
            "k 21",
            "p2s ratio",
        ],
        table,
        rules=rules,
        caption="Left: as printed; right: this study.",
    )
    page.verdict(*claims.competitive_with_rimls(_cases(pairs)))
    page.verdict(*claims.competitive_by_distance(_cases_by_distance(study)))


def _line(study, printed, row):
    left = [
        style.model_title(printed["model"]),
        printed["noise"],
        printed["method"],
        f"({printed['parameters']})",
        printed["E_A_1e-3"],
        printed["E_k_1e-3"],
    ]
    if row is None:
        model = study.find_model(printed["model"])
        if not model:
            return left + [Gap("model not in this study")] + [Gap("–")] * 5
        family = {"family": "sweep"} if printed["method"] == "Ours" else {"family": "peer", "name": printed["method"]}
        return left + [Gap(study.why_missing(model=model, noise=printed["noise"], **family))] + [Gap("–")] * 5
    parameters = combination(row) if printed["method"] == "Ours" else row["parameters"].removesuffix(DEFAULT_MARK)
    errors = [format_number(1e3 * row[c]) if row[c] is not None else None for c in ("E_A", "E_k7", "E_k15", "E_k21")]
    return left + [parameters] + errors + [format_number(row["p2s_ratio"])]


def _cases(pairs):
    """The pairs (ours, rimls) for which both exist."""
    cases = {}
    for printed, row in pairs:
        if row is not None and printed["method"] in ("Ours", "RIMLS"):
            cases.setdefault((printed["model"], printed["noise"]), {})[printed["method"]] = row
    return [(case["Ours"], case["RIMLS"]) for case in cases.values() if len(case) == 2]


def _cases_by_distance(study):
    cases = []
    for model in study.models:
        for noise in study.noises:
            where = {"model": model, "noise": noise, "sigma": study.sigma}
            ours = ranked(study.select(family="sweep", **where))
            rimls = ranked(study.select(family="peer", name="RIMLS", **where))
            if ours and rimls:
                cases.append((ours[0][0], rimls[0][0]))
    return cases
