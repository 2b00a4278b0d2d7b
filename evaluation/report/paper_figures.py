# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Figs. 6, 7 and 8, from our rows."""

import matplotlib.pyplot as plt

import claims
import style
from study import estimator_of, mean, method_of, weights_of
from summary import combination

MEASURES = (("E_A", "E_A"), ("E_k15", "E_k (k 15)"), ("p2s_ratio", "p2s ratio"))

WORD_OFFSETS = {
    "best": (12, -14),
    "average": (22, -24),
    "worst": (-18, -22),
    "best area": (14, 18),
    "worst curvature": (24, -3),
}


def add(study, page, folder):
    page.section("figures", "The paper's comparison: Figs. 6, 7 and 8")
    page.text(
        "The 540 combinations of the paper: PCA (P), WPCA (WP) or Hough (H) normals; thresholded (T), Gaussian (G) or mixed"
        " (M) weights; U for the point update; 7, 15 or 21 neighbours; 2 to 32 normal and 5 to 40 point iterations. The"
        " third row of each figure, p2s, is not in the paper."
    )
    add_box_plots(study, page, folder)
    add_mean_errors(study, page, folder)
    add_scatter(study, page, folder)


def add_box_plots(study, page, folder):
    page.heading("Fig. 6: the twenty choices of iterations, a box for each method and k")
    model = study.find_model("elephant") or (study.models or [None])[0]
    for noise in study.noises or ["GN", "GR"]:
        rows = study.sweep(model=model, noise=noise)
        if not rows:
            page.gap(f"Fig. 6, {noise}", study.why_missing(family="sweep", model=model, noise=noise))
            continue
        path = _box_plots(rows, folder, noise)
        other = (
            ""
            if model == study.find_model("elephant")
            else " The paper's model is the elephant, which is not in this study."
        )
        page.figure(
            path,
            (
                f"Fig. 6, {style.model_title(model)}, {style.NOISE_NAMES.get(noise, noise)}. Boxes: quartiles and median;"
                f" whiskers: all values.{other}"
            ),
        )
        page.verdict(*claims.area_by_estimator(rows, style.model_title(model), noise))
        page.verdict(*claims.curvature_by_estimator(rows, style.model_title(model), noise))


def _box_plots(rows, folder, noise):
    figure, axes = plt.subplots(3, 1, figsize=(10, 8.4), sharex=True, layout="constrained")
    names = [f"{method}U{k}" for method in style.METHODS for k in style.NEIGHBOURS]
    places = [index + index // 3 * 0.5 + index // 9 * 0.8 for index in range(len(names))]
    for axis, (column, title) in zip(axes, MEASURES):
        for place, name in zip(places, names):
            values = [row[column] for row in rows if row["name"] == name and row[column] is not None]
            if values:
                _box(axis, values, place, style.ESTIMATOR_COLOURS[name.split("U")[0][:-1]])
            else:
                axis.text(
                    place,
                    0.02,
                    "gap",
                    transform=axis.get_xaxis_transform(),
                    rotation=90,
                    fontsize=7,
                    color="#999999",
                    ha="center",
                )
        axis.set_yscale("log")
        style.plain_ticks(axis.yaxis)
        axis.set_title(title)
        axis.grid(axis="x", visible=False)
    axes[2].axhline(1, color=style.DARK, linewidth=0.9, linestyle="--")
    axes[2].set_xticks(places, names, rotation=90)
    handles = [plt.Rectangle((0, 0), 1, 1, color=c, alpha=0.55) for c in style.ESTIMATOR_COLOURS.values()]
    axes[0].legend(
        handles, style.ESTIMATOR_NAMES.values(), ncols=3, loc="lower right", bbox_to_anchor=(1, 1), borderaxespad=0
    )
    return style.save(figure, folder, f"fig6_{noise}")


def _box(axis, values, place, colour):
    axis.boxplot(
        [values],
        positions=[place],
        widths=0.75,
        whis=(0, 100),
        patch_artist=True,
        manage_ticks=False,
        boxprops={"facecolor": colour, "alpha": 0.55, "edgecolor": colour},
        medianprops={"color": style.DARK, "linewidth": 1.4},
        whiskerprops={"color": colour},
        capprops={"color": colour},
    )


def add_mean_errors(study, page, folder):
    page.heading("Fig. 7: mean errors over all models, sixty variations a method")
    noises = [noise for noise in study.noises if study.sweep(noise=noise)]
    if not noises:
        page.gap("Fig. 7", study.why_missing(family="sweep"))
        return
    figure, axes = plt.subplots(
        3, len(noises), figsize=(5.2 * len(noises), 7.6), sharex=True, squeeze=False, layout="constrained"
    )
    for column, noise in enumerate(noises):
        for row, (measure, title) in enumerate(MEASURES):
            _mean_errors(axes[row, column], study, noise, measure)
            axes[row, column].set_title(f"{title}, {noise}")
        axes[2, column].set_xticks(range(len(style.METHODS)), [method + "U" for method in style.METHODS])
    style.legend_below(figure, axes[0, 0], 5)
    path = style.save(figure, folder, "fig7")
    page.figure(
        path,
        (
            "Fig. 7: mean over 3 neighbourhoods and 20 choices of iterations. Bars: mean over the models (blue PCA, green"
            " WPCA, orange Hough); marks: each model."
        ),
    )
    for noise in study.noises:
        page.verdict(*claims.thresholded_best_on_area(study, noise))


def _mean_errors(axis, study, noise, measure):
    marks = "osD^vP*X<>"
    for place, method in enumerate(style.METHODS):
        rows = [row for row in study.sweep(noise=noise) if method_of(row) == method]
        models = [mean(row[measure] for row in rows if row["model"] == model) for model in study.models]
        if mean(models) is not None:
            axis.hlines(mean(models), place - 0.38, place + 0.38, color=style.ESTIMATOR_COLOURS[method[:-1]], linewidth=4)
        for index, (model, value) in enumerate(zip(study.models, models)):
            if value is not None:
                label = style.model_title(model) if place == 0 else None
                axis.plot(place, value, marks[index % len(marks)], color=style.DARK, markersize=3.5, alpha=0.8, label=label)
    axis.set_yscale("log")
    style.plain_ticks(axis.yaxis)
    axis.grid(axis="x", visible=False)
    if measure == "p2s_ratio":
        axis.axhline(1, color=style.DARK, linewidth=0.9, linestyle="--")


def add_scatter(study, page, folder):
    page.heading("Fig. 8: E_A and E_k of all 540 combinations")
    model = study.find_model("double_torus") or (study.models or [None])[0]
    noise = "GR" if study.sweep(model=model, noise="GR") else (study.noises or ["GR"])[0]
    seed = min(study.seeds, default=None)
    rows = [row for row in study.sweep(model=model, noise=noise, seed=seed) if row["E_A"] and row["E_k15"]]
    if not rows:
        page.gap("Fig. 8", study.why_missing(family="sweep", model=model, noise=noise))
        return
    figure, axes = plt.subplots(1, 2, figsize=(11, 5), layout="constrained")
    marked = marked_rows(rows)
    _scatter(axes[0], rows, "E_k15", marked)
    _scatter(axes[1], rows, "p2s_ratio", marked)
    axes[0].set(title=f"{style.model_title(model)}, {noise}: E_A and E_k", ylabel="E_k (k 15)")
    axes[1].set(title="the same combinations: E_A and p2s ratio", ylabel="p2s ratio")
    axes[1].axhline(1, color=style.DARK, linewidth=0.9, linestyle="--")
    style.legend_below(figure, axes[0], 3)
    path = style.save(figure, folder, "fig8")
    told = "; ".join(
        f"{what}: {combination(row)} (p2s ratio {row['p2s_ratio']:.2f})" for what, row in marked.items() if row["p2s_ratio"]
    )
    page.figure(
        path,
        (
            f"Fig. 8: {len(rows)} combinations, one seed. Best and worst: lowest and highest sum of E_A and E_k, each over"
            f" its median; average: the middle one. {told}."
        ),
    )


def marked_rows(rows):
    """The rows that the paper marks in Fig. 8."""
    scores = claims.combined_score(rows, rows)
    order = sorted(rows, key=lambda row: scores[id(row)])
    return {
        "best": order[0],
        "average": order[len(order) // 2],
        "worst": order[-1],
        "best area": min(rows, key=lambda row: row["E_A"]),
        "worst curvature": max(rows, key=lambda row: row["E_k15"]),
    }


def _scatter(axis, rows, column, marked):
    for estimator, colour in style.ESTIMATOR_COLOURS.items():
        for weights, mark in zip("TGM", "o^s"):
            chosen = [r for r in rows if estimator_of(r) == estimator and weights_of(r) == weights and r[column]]
            label = f"{style.ESTIMATOR_NAMES[estimator]}, {style.WEIGHT_NAMES[weights]}"
            axis.plot(
                [r["E_A"] for r in chosen],
                [r[column] for r in chosen],
                mark,
                color=colour,
                markersize=3.6,
                alpha=0.6,
                markeredgewidth=0,
                label=label,
            )
    for what, row in marked.items():
        if row[column]:
            _mark(axis, what, row["E_A"], row[column])
    axis.set(xscale="log", yscale="log", xlabel="E_A")
    axis.margins(0.08)
    style.plain_ticks(axis.xaxis)
    style.plain_ticks(axis.yaxis)


def _mark(axis, what, x, y):
    """Draws a circle with a label beside it."""
    axis.plot(x, y, "o", markersize=9, markerfacecolor="none", markeredgecolor=style.RED, markeredgewidth=1.6)
    axis.annotate(
        what,
        (x, y),
        xytext=WORD_OFFSETS[what],
        textcoords="offset points",
        color=style.RED,
        fontsize=9,
        weight="bold",
        arrowprops={"arrowstyle": "-", "color": style.RED, "linewidth": 0.8},
        bbox={"facecolor": "white", "alpha": 0.8, "edgecolor": "none", "pad": 1},
    )
