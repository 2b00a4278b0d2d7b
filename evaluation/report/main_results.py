# SPDX-License-Identifier: BSD-3-Clause
"""Main results: the distance to the surface for every method, model and noise, with the spread over the seeds."""

import math

import matplotlib.pyplot as plt

import style
from page import Gap, escape, format_number
from study import geometric_mean
from summary import best_peer, entries


COLUMNS = (
    ("p2s max", "p2s_max"),
    ("exact ratio", "exact_ratio"),
    ("p2p ratio", "p2p_ratio"),
    ("normals, °", "normal_angle"),
    ("edge error", "edge_error"),
    ("edge fraction", "edge_fraction"),
    ("spacing", "spacing_p01"),
    ("seconds", "seconds"),
)


def add(study, page, folder):
    page.section("results", "Distance to the surface: the main results")
    page.text(
        "<b>p2s ratio</b>: mean distance of the smoothed points to the clean surface over that of the noisy points. 1 means"
        " that nothing was gained, 0.3 that 70 % of the noise is gone, above 1 that the cloud is farther from the truth than"
        " before. &ldquo;Default&rdquo; is a method as it comes; &ldquo;best&rdquo; is its best setting on that very model"
        " and noise, found by looking at the truth, which a user cannot do."
    )
    if not study.select():
        page.gap("main results", "the study has no finished row")
        return
    for sigma in study.sigmas:
        for noise in study.noises:
            if study.select(status=None, noise=noise, sigma=sigma):
                _add_noise(study, page, folder, noise, sigma)


def _add_noise(study, page, folder, noise, sigma):
    by_model = {model: entries(study, model=model, noise=noise, sigma=sigma) for model in study.models}
    title = f"{style.NOISE_NAMES.get(noise, noise)}, sigma {format_number(sigma)} mean edge lengths"
    page.heading(title[0].upper() + title[1:])
    path = dots(by_model, folder, f"results_{noise}_{format_number(sigma)}")
    page.figure(
        path,
        (
            f"p2s ratio, {title}. Dots: mean over the seeds (hollow: a peer as it comes); bars: lowest and highest seed. The"
            " dashed line at 1 is the noisy input."
        ),
    )
    _ratio_table(page, study, by_model)
    for model in study.models:
        page.parts.append(f"<details><summary>{escape(style.model_title(model))}: settings, times, edges</summary>")
        _model_table(page, by_model[model])
        page.parts.append("</details>")


def dots(by_model, folder, name):
    models = list(by_model)
    labels = [entry.label for entry in by_model[models[0]]][1:]
    columns = min(4, len(models))
    rows = math.ceil(len(models) / columns)
    figure, axes = plt.subplots(
        rows,
        columns,
        figsize=(1.9 + 2.35 * columns, rows * (0.7 + 0.19 * len(labels))),
        sharey=True,
        squeeze=False,
        layout="constrained",
    )
    highest = max((e.spread()[1] for found in by_model.values() for e in found[1:] if e.spread()), default=1)
    for axis, model in zip(axes.flat, models):
        _draw_dots(axis, by_model[model][1:], highest)
        axis.set_title(style.model_title(model))
    for axis in list(axes.flat)[len(models) :]:
        axis.set_visible(False)
    for axis in axes[:, 0]:
        axis.set_yticks(range(len(labels)), labels)
    axes[0, 0].invert_yaxis()
    figure.supxlabel("p2s ratio (logarithmic)", fontsize=9)
    return style.save(figure, folder, name)


def _draw_dots(axis, found, highest):
    for place, entry in enumerate(found):
        colour = style.GROUP_COLOURS[entry.group]
        if entry.mean() is None:
            axis.text(
                0.03,
                place,
                "no result",
                transform=axis.get_yaxis_transform(),
                color="#9a9a9a",
                fontsize=7,
                style="italic",
                va="center",
            )
            continue
        axis.plot(entry.spread(), [place, place], color=colour, linewidth=2, solid_capstyle="butt")
        inside = "white" if entry.group == "peer" and entry.label.endswith("default") else colour
        axis.plot(entry.mean(), place, "o", color=colour, markerfacecolor=inside, markersize=5)
    axis.axvline(1, color=style.DARK, linewidth=0.9, linestyle="--")
    axis.set_xscale("log")
    axis.set_xlim(0.1, max(2, highest * 1.2))
    ticks = [tick for tick in (0.2, 0.5, 1, 2, 5, 10, 20, 50) if tick <= max(2, highest * 1.2)]
    axis.set_xticks(ticks, [format_number(tick) for tick in ticks])
    axis.minorticks_off()
    axis.grid(axis="y", visible=False)


def ratio_cell(entry):
    """The mean, and half the width of the spread if there are several seeds."""
    if entry.mean() is None:
        return Gap("–")
    low, high = entry.spread()
    return f"{entry.mean():.3f}" + (f" ± {(high - low) / 2:.3f}" if entry.seeds > 1 else "")


def _ratio_table(page, study, by_model):
    first = next(iter(by_model.values()))
    rows, strong = [], []
    for index, entry in enumerate(first):
        cells = [found[index] for found in by_model.values()]
        means = [cell.mean() for cell in cells]
        there = sum(value is not None for value in means)
        whole = (
            f"{geometric_mean(means):.3f}"
            if there == len(means)
            else Gap(f"{there} of {len(means)} models" if there else "–")
        )
        rows.append([entry.label] + [ratio_cell(cell) for cell in cells] + [whole])
        if entry.group == "ours":
            strong.append(index)
    page.table(
        ["method"] + [style.model_title(model) for model in by_model] + ["geometric mean"],
        rows,
        strong=strong,
        caption=(
            "p2s ratio, mean over the seeds ± half the distance between the lowest and the highest seed; "
            "the geometric mean only where every model has a value."
        ),
    )
    _list_gaps(page, by_model)


def _list_gaps(page, by_model):
    """Lists each reason once, with the methods and models that it applies to."""
    reasons = {}
    for model, found in by_model.items():
        for entry in found:
            if entry.mean() is None:
                methods, models = reasons.setdefault(entry.reason or "not in this study", ({}, {}))
                methods[entry.label.split(":")[0]] = models[style.model_title(model)] = None
    if reasons:
        page.points(
            [
                f"Gap: {escape(', '.join(methods))} on {escape(', '.join(models))}: {escape(reason)}"
                for reason, (methods, models) in reasons.items()
            ]
        )


def _model_table(page, found):
    """A table of all quality measures; columns without any value are left out."""
    columns = [(title, name) for title, name in COLUMNS if any(entry.mean(name) is not None for entry in found)]
    rows = []
    for entry in found:
        if entry.mean() is None:
            rows.append([entry.label, Gap(entry.reason or "not in this study")] + [Gap("–")] * (len(columns) + 2))
            continue
        numbers = [format_number(entry.mean(name)) for _, name in columns]
        rows.append([entry.label, entry.setting or "", ratio_cell(entry), str(entry.seeds), *numbers])
    page.table(
        ["method", "setting", "p2s ratio", "seeds", *(title for title, _ in columns)],
        rows,
        strong=[i for i, entry in enumerate(found) if entry.group == "ours"],
        caption=(
            "Lengths in mean edge lengths of the clean mesh. Edge error: mean distance of the points beside a sharp edge;"
            " edge fraction: share of them farther than 0.1 from the surface. Exact ratio: as p2s, to the surface that the"
            " model was made of. Spacing: 1st percentile of the distance to the nearest neighbour, over that of the noisy"
            " cloud."
        ),
    )


def conclusions(study):
    """Sentences for the top of the page, computed from the rows."""
    said = []
    for noise in study.noises:
        by_model = {m: entries(study, model=m, noise=noise, sigma=study.sigma) for m in study.models}
        pairs = []
        for found in by_model.values():
            ours, peer = next(e for e in found if e.label == "ours: default"), best_peer(found)
            if ours.mean() is not None and peer is not None:
                pairs.append((ours, peer))
        if pairs:
            said.append(_compare(noise, pairs))
    return said


def _compare(noise, pairs):
    wins = sum(ours.spread()[1] < peer.spread()[0] for ours, peer in pairs)
    losses = sum(ours.spread()[0] > peer.spread()[1] for ours, peer in pairs)
    ours = geometric_mean([pair[0].mean() for pair in pairs])
    peer = geometric_mean([pair[1].mean() for pair in pairs])
    seeds = max(pair[0].seeds for pair in pairs)
    searched = any(pair[1].label.endswith("best") for pair in pairs)
    tried = "at the best setting tried" if searched else "as it comes: no other setting was tried"
    return (
        f"With {style.NOISE_NAMES.get(noise, noise)}, our default leaves a p2s ratio of {ours:.3f} (geometric mean over"
        f" {len(pairs)} model(s)); the best peer of each model, {tried}, {peer:.3f}. Our default is ahead"
        f" of every peer on {wins} model(s), behind the best on {losses}, and within the spread of {seeds} seed(s) on"
        f" {len(pairs) - wins - losses}."
    )
