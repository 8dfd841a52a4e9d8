"""Groups of shapes, and a permutation test at each vertex of whether their means differ.

The guide Correspondence.md names the sources of the test: Anderson2001, NicholsHolmes2002 and PhipsonSmyth2010 in
Documentation/references.bib.
"""
import typing

import numpy as np

from .scan_tables import rows_of

BATCH = 16  # permutations at once
ROUNDING = 1e-9  # relative difference of statistics that counts as none


class Test(typing.NamedTuple):
    """Results of a permutation test: arrays with a number for each vertex."""
    statistic: np.ndarray  # pseudo-F, at least 0
    p: np.ndarray  # in (0, 1], of each vertex alone
    corrected: np.ndarray  # in (0, 1], corrected for all vertices


def read_groups(path, names):
    """The group of each name, by a table with the columns scan and group; raises ValueError for an unsuitable one.

    A scan may be called by its name or its file.
    """
    groups = {}
    for _, name, (cell, group) in rows_of(path, ("scan", "group"), names):
        if name in groups:
            raise ValueError(f"{path}: {cell} has two rows")
        if not group:
            raise ValueError(f"{path}: {cell} has no group")
        groups[name] = group
    missing = [name for name in names if name not in groups]
    if missing:
        raise ValueError(f"{path}: no group for {', '.join(missing[:5])}" + (" and others" if missing[5:] else ""))
    found = [groups[name] for name in names]
    sizes = {group: found.count(group) for group in found}
    if len(sizes) < 2:
        raise ValueError(f"{path}: all scans are in the group {found[0]}; two groups or more are needed")
    small = [group for group, size in sizes.items() if size < 2]
    if small:
        raise ValueError(f"{path}: the group {small[0]} has one scan; each group needs two or more")
    return found


def test_groups(shapes, groups, permutations, seed, advanced=lambda fraction: None):
    """Test at each vertex whether the means of groups differ.

    shapes: n x #V x 3 aligned points. groups: n names. permutations: number of random permutations of the groups.

    The statistic is the pseudo-F of distances (Anderson 2001). The maximum over all vertices in each permutation
    corrects for the number of vertices (Nichols and Holmes 2002). The given order counts as one of the permutations,
    so that no p is 0 (Phipson and Smyth 2010).
    """
    shapes = np.asarray(shapes, dtype=float)
    number, vertices = shapes.shape[:2]
    flat = (shapes - shapes.mean(axis=0)).reshape(number, -1)
    names = sorted(set(groups))
    labels = np.array([names.index(group) for group in groups])
    sizes = np.bincount(labels)
    total = (flat**2).sum(axis=0).reshape(vertices, 3).sum(axis=1)
    total[total <= 1e-20 * total.max()] = 0.0  # rounding
    factor = (number - len(names)) / (len(names) - 1)

    def statistic(sums):
        between = sum(part**2 / size for part, size in zip(sums, sizes)).reshape(vertices, 3).sum(axis=1)
        within = np.maximum(total - between, 1e-12 * total)
        return factor * np.divide(between, within, out=np.zeros(vertices), where=total > 0.0)

    observed = statistic([flat[labels == k].sum(axis=0) for k in range(len(names))])
    enough = observed * (1.0 - ROUNDING)
    above, above_all = np.zeros(vertices, dtype=int), np.zeros(vertices, dtype=int)
    random = np.random.RandomState(seed)
    for first in range(0, permutations, BATCH):
        mixed = [random.permutation(labels) for _ in range(min(BATCH, permutations - first))]
        sums = np.concatenate([labels_ == k for labels_ in mixed for k in range(len(names))]).reshape(-1, number) @ flat
        for part in sums.reshape(len(mixed), len(names), -1):
            values = statistic(part)
            above += values >= enough
            above_all += values.max() >= enough
        advanced(first / permutations)
    return Test(observed, (1 + above) / (1 + permutations), (1 + above_all) / (1 + permutations))
