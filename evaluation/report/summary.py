# SPDX-License-Identifier: BSD-3-Clause
"""The results of each method on one model and noise: mean and spread over the seeds."""

from study import NUMBERS, mean, ordered

PRESETS = ("default", "fast", "paper")
PEERS = ("APSS", "RIMLS", "WLOP", "LOP", "CGAL jet", "CGAL bilateral", "PCL MLS")
DEFAULT_MARK = " (default)"
MEASURES = [
    name for name in NUMBERS if name not in ("points", "sigma", "seed", "k", "normal_iterations", "point_iterations")
]


class Entry:
    """One method: label, group (noisy, ours, sweep, peer), setting, and its rows (one per seed), or why there are none."""

    def __init__(self, label, group, rows=(), setting="", reason=""):
        self.label, self.group, self.rows, self.setting, self.reason = label, group, list(rows), setting, reason

    def values(self, column):
        return [row[column] for row in self.rows if row[column] is not None]

    def mean(self, column="p2s_ratio"):
        return mean(self.values(column))

    def spread(self, column="p2s_ratio"):
        """Lowest and highest over the seeds, or None."""
        values = self.values(column)
        return (min(values), max(values)) if values else None

    @property
    def seeds(self):
        return len({row["seed"] for row in self.rows})


def setting_of(row):
    """Key that distinguishes the settings of a family."""
    return (row["name"], row["parameters"], row["k"], row["normal_iterations"], row["point_iterations"])


def settings(rows):
    """The rows grouped by setting, one row per seed."""
    groups = {}
    for row in rows:
        groups.setdefault(setting_of(row), []).append(row)
    return list(groups.values())


def ranked(rows, column="p2s_ratio"):
    """Settings sorted by the column at the first seed, lowest first: only the best may have been run with further seeds."""
    first = min((row["seed"] for row in rows if row["seed"] is not None), default=None)
    groups = {}
    for group in settings(rows):
        value = mean(row[column] for row in group if row["seed"] == first)
        if value is not None:
            groups[value, len(groups)] = group
    return [groups[key] for key in sorted(groups)]


def combination(row):
    """The paper's notation: 'PTU7, 32, 5'."""
    return f"{row['name']}, {row['normal_iterations']:.0f}, {row['point_iterations']:.0f}"


def sweep_entries(study, **where):
    rows = study.select(family="sweep", **where)
    order = ranked(rows)
    if not order:
        reason = study.why_missing(family="sweep", **where)
        return [Entry(f"paper's 540: {which}", "sweep", reason=reason) for which in ("best", "mean", "worst")]
    by_seed = []
    for seed in ordered(row["seed"] for row in rows):
        of_seed = [row for row in rows if row["seed"] == seed]
        averaged = {column: mean(row[column] for row in of_seed) for column in MEASURES}
        by_seed.append({**of_seed[0], **averaged})
    return [
        Entry("paper's 540: best", "sweep", order[0], combination(order[0][0])),
        Entry("paper's 540: mean", "sweep", by_seed, f"of {len(order)}"),
        Entry("paper's 540: worst", "sweep", order[-1], combination(order[-1][0])),
    ]


def only_default(rows):
    """Whether all rows of a peer have its default setting: its best was not searched for."""
    return all(row["parameters"].endswith(DEFAULT_MARK) for row in rows)


def peer_entries(study, peer, **where):
    rows = study.select(family="peer", name=peer, **where)
    defaults = [row for row in rows if row["parameters"].endswith(DEFAULT_MARK)]
    order = ranked(rows)
    reason = study.why_missing(family="peer", name=peer, **where)
    best = order[0] if order else []
    if defaults and only_default(rows):
        best, reason = [], "only the default was tried"
    entries = []
    for which, group in (("default", defaults), ("best", best)):
        setting = group[0]["parameters"].removesuffix(DEFAULT_MARK) if group else ""
        entries.append(Entry(f"{peer}: {which}", "peer", group, setting, reason))
    return entries


def entries(study, **where):
    """Every method of the study on model=, noise=, sigma=, in a fixed order; those without a result give the reason."""
    found = [
        Entry(
            "noisy input", "noisy", study.select(family="noisy", **where), reason=study.why_missing(family="noisy", **where)
        )
    ]
    for preset in PRESETS:
        rows = study.select(family="ours", name=preset, **where)
        found.append(Entry(f"ours: {preset}", "ours", rows, reason=study.why_missing(family="ours", name=preset, **where)))
    found += sweep_entries(study, **where)
    named = ordered(row["name"] for row in study.select(status=None, family="peer"))
    for peer in list(PEERS) + [name for name in named if name not in PEERS]:
        found += peer_entries(study, peer, **where)
    return found


def best_peer(found):
    """The entry of the peer with the lowest p2s ratio, or None."""
    peers = [entry for entry in found if entry.group == "peer" and entry.mean() is not None]
    return min(peers, key=lambda entry: entry.mean(), default=None)
