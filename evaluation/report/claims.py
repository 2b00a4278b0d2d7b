# SPDX-License-Identifier: BSD-3-Clause
"""Whether the rerun confirms the paper's statements. Every verdict is computed from the rows."""

import statistics

from page import format_number
from style import ESTIMATOR_NAMES, NEIGHBOURS, WEIGHT_NAMES
from study import estimator_of, mean, weights_of

CONFIRMED, PARTLY, NOT_CONFIRMED, UNTOLD = "confirmed", "partly confirmed", "not confirmed", "cannot be told"
GROUPS = [(estimator, k) for estimator in ("P", "WP", "H") for k in NEIGHBOURS]


def group_name(group):
    """('WP', 7) as 'WPCA k 7'."""
    return f"{ESTIMATOR_NAMES[group[0]]} k {group[1]}"


def group_medians(rows, column):
    """The median over weights and iterations for each estimator and k; empty unless all nine groups have rows."""
    medians = {}
    for group in GROUPS:
        values = [row[column] for row in rows if (estimator_of(row), row["k"]) == group and row[column] is not None]
        if not values:
            return {}
        medians[group] = statistics.median(values)
    return medians


def _ranking(medians, scale=1e3):
    order = sorted(medians, key=medians.get)
    return ", ".join(f"{group_name(group)} {format_number(scale * medians[group])}" for group in order)


def area_by_estimator(rows, model, noise):
    """Fig. 6: 'PCA and Hough with neighborhood 7 and 15 tend to generate smaller errors ... for the area error'."""
    claim = f"Area error is lowest with PCA and Hough at k 7 and 15 ({model}, {noise})"
    medians = group_medians(rows, "E_A")
    if not medians:
        return UNTOLD, f"{claim}: the sweep of this model and noise is not complete."
    named = {("P", 7), ("P", 15), ("H", 7), ("H", 15)}
    order = sorted(medians, key=medians.get)
    inside = len(named & set(order[:4]))
    lower = mean(medians[g] for g in named) < mean(medians[g] for g in GROUPS if g not in named)
    verdict = CONFIRMED if inside == 4 else PARTLY if lower and inside >= 2 else NOT_CONFIRMED
    return (
        verdict,
        f"{claim}: {inside} of these four groups are among the four lowest. Medians of E_A, in 1e-3: {_ranking(medians)}.",
    )


def curvature_by_estimator(rows, model, noise, column="E_k15"):
    """Fig. 6: 'For curvature error, PCA with neighborhood 15 for normal Gaussian noise, WPCA with neighborhood 7 for random'."""
    named = ("P", 15) if noise == "GN" else ("WP", 7)
    claim = f"Curvature error is lowest with {group_name(named)} ({model}, {noise})"
    medians = group_medians(rows, column)
    if not medians:
        return UNTOLD, f"{claim}: the sweep of this model and noise is not complete."
    place = sorted(medians, key=medians.get).index(named) + 1
    verdict = CONFIRMED if place == 1 else PARTLY if place <= 3 else NOT_CONFIRMED
    how = column.replace("E_k", "E_k with k ")
    return verdict, f"{claim}: it is number {place} of nine. Medians of {how}, in 1e-3: {_ranking(medians)}."


def thresholded_best_on_area(study, noise):
    """Fig. 7: 'Thresholded Weights approach performs better regarding area error'."""
    rows = study.sweep(noise=noise)
    claim = f"Thresholded weights have the lowest area error, over all models ({noise})"
    means = {}
    for estimator in ESTIMATOR_NAMES:
        for weights in WEIGHT_NAMES:
            means[estimator, weights] = mean(
                row["E_A"] for row in rows if (estimator_of(row), weights_of(row)) == (estimator, weights)
            )
    if None in means.values():
        return UNTOLD, f"{claim}: the sweep is not complete."
    wins = [e for e in ESTIMATOR_NAMES if means[e, "T"] == min(means[e, w] for w in WEIGHT_NAMES)]
    verdict = CONFIRMED if len(wins) == 3 else PARTLY if wins else NOT_CONFIRMED
    by_weights = {w: mean(means[e, w] for e in ESTIMATOR_NAMES) for w in WEIGHT_NAMES}
    figures = ", ".join(
        f"{WEIGHT_NAMES[w]} {format_number(1e3 * by_weights[w])}" for w in sorted(by_weights, key=by_weights.get)
    )
    names = " and ".join(ESTIMATOR_NAMES[e] for e in wins) if wins else "no estimator"
    return verdict, f"{claim}: so it is with {names}. Mean E_A over the three estimators, in 1e-3: {figures}."


def competitive_with_rimls(cases):
    """Table I: 'our method is quite competitive, outperforming in some cases RIMLS'. \\a cases are (ours, rimls) rows, each the
    best by E_A and E_k on one model and noise."""
    claim = "The paper's chain is competitive with RIMLS (best of each by E_A and E_k)"
    if not cases:
        return UNTOLD, f"{claim}: there is no case where both the sweep and RIMLS have a result."
    area = sum(ours["E_A"] < rimls["E_A"] for ours, rimls in cases)
    curvature = sum(ours["E_k15"] < rimls["E_k15"] for ours, rimls in cases)
    need = len(cases) / 2
    verdict = (
        CONFIRMED if area >= need and curvature >= need else PARTLY if area >= need or curvature >= need else NOT_CONFIRMED
    )
    return verdict, f"{claim}: E_A is lower than that of RIMLS in {area} of {len(cases)} cases, E_k (k 15) in {curvature}."


def competitive_by_distance(cases):
    """The same claim, judged by p2s: \\a cases are (ours, rimls) rows, each the best by p2s."""
    claim = "By the distance to the surface, each tuned for it"
    cases = [case for case in cases if case[0]["p2s_ratio"] is not None and case[1]["p2s_ratio"] is not None]
    if not cases:
        return UNTOLD, f"{claim}: there is no case where both the sweep and RIMLS have a result."
    lower = sum(ours["p2s_ratio"] < rimls["p2s_ratio"] for ours, rimls in cases)
    verdict = CONFIRMED if 2 * lower >= len(cases) else PARTLY if lower else NOT_CONFIRMED
    figures = ", ".join(f"{o['model']} {o['noise']} {o['p2s_ratio']:.2f} against {r['p2s_ratio']:.2f}" for o, r in cases)
    return verdict, f"{claim}, the paper's chain is ahead of RIMLS in {lower} of {len(cases)} cases (p2s ratio): {figures}."


def combined_score(rows, reference):
    """For each row, the sum of E_A and E_k (k 15), each divided by its median in \\a reference; lower is better."""
    area = statistics.median(row["E_A"] for row in reference) or 1
    curvature = statistics.median(row["E_k15"] for row in reference) or 1
    return {id(row): row["E_A"] / area + row["E_k15"] / curvature for row in rows}


def best_combined(rows, reference):
    """The row with the lowest combined score, or None."""
    rows = [row for row in rows if row["E_A"] is not None and row["E_k15"] is not None]
    if not rows or not reference:
        return None
    scores = combined_score(rows, reference)
    return min(rows, key=lambda row: scores[id(row)])
