# SPDX-License-Identifier: BSD-3-Clause
"""The beginning of the page: conclusions and what was run; and its end: what has no result."""

import main_results
import style
from page import Gap, escape, format_number


def lead(study):
    version = study.info.get("version")
    return (
        "Point cloud smoothing, every combination of Valdivia et al. (SIBGRAPI 2013) and its peers, on"
        f" {len(study.models)} model(s)"
        + (f"; pcl_normal_smoothing {version}" if version else "")
    )


def add(study, page):
    page.section("summary", "In short")
    said = main_results.conclusions(study)
    if said:
        page.points([escape(sentence) for sentence in said])
    else:
        page.gap("conclusions", "no model has both our result and a peer's in this study")
    page.text("What the paper says, and whether this rerun bears it out:")
    page.all_verdicts()
    for note in study.notes:
        page.gap("damaged study", note)
    page.section("run", "What was run")
    _add_models(study, page)
    seeds = ", ".join(format_number(seed) for seed in study.seeds)
    sigmas = ", ".join(format_number(sigma) for sigma in study.sigmas)
    page.points([
        "Noise: " + escape("; ".join(style.NOISE_NAMES.get(noise, noise) for noise in study.noises) or "none"),
        f"Sigma: {escape(sigmas or 'none')} mean edge lengths of the clean mesh; seeds: {escape(seeds or 'none')}",
        f"Rows: {len(study.select())} with a result, {len(study.rows) - len(study.select())} without",
    ])  # fmt: skip
    command = study.info.get("command_line")
    if command:
        page.text(
            f"Made by <code>{escape(command)}</code>; <code>rows.csv</code> and <code>rows.json</code> beside this report"
            " hold every row."
        )


def _add_models(study, page):
    rows = []
    for model in study.models:
        info = study.model_info.get(model, {})
        points = info.get("points") or next((row["points"] for row in study.rows if row["model"] == model), None)
        rows.append([style.model_title(model), f"{points:.0f}" if points else Gap("–"), str(info.get("source") or "–")])
    if rows:
        page.table(["model", "points", "source"], rows)
    else:
        page.gap("models", "the study has none")


def add_gaps(study, page):
    page.section("gaps", "What has no result")
    groups = {}
    for row in study.rows:
        if row["status"] != "ok":
            key = (row["model"], row["noise"], row["name"], row["status"], row["reason"])
            groups.setdefault(key, []).append(row)
    if not groups:
        page.text("Nothing: every row of the study has a result.")
        return
    lines = [
        [style.model_title(m), noise, name, str(len(rows)), status, reason]
        for (m, noise, name, status, reason), rows in groups.items()
    ]
    page.table(
        ["model", "noise", "method", "rows", "status", "reason"],
        lines,
        caption="Rows that failed, or that could not be run.",
    )
