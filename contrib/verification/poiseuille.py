# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steady flow of two layers between plates."""

from math import log, sqrt

from thalweg import read_rows

MU = (100., 1.)


def exact(y):
    """The velocity in m/s for the pressure gradient 1 Pa/m."""
    mu = MU[0] if y < 0 else MU[1]
    total = MU[0] + MU[1]
    return (2 * mu / total + (MU[0] - MU[1]) / total * y - y * y) / (2 * mu)


def profile(runner, n):
    """(y, velocity) at the nodes away from the cut row of n rows of cells."""
    heights = [-1. + 2. * j / n for j in range(1, n)
               if abs(-1. + 2. * j / n) > 1.1 / n]
    points = "; ".join(f"0.125, {y!r}" for y in heights)
    output = runner.run("poiseuille_two_fluids", f"poiseuille_{n}", {
        "Geometry/box/Repetitions": f"{max(2, n // 8)}, {n}",
        "Postprocess/Models": "point probes",
        "Postprocess/point probes/Points": points})
    last = read_rows(output / "point_probes.csv")[-1]
    names = [k for k in last if k.startswith("velocity x")]
    return heights, [float(last[k]) for k in names]


def verify(runner, report, reduced):
    """Norms of the error on three meshes and their order."""
    rows, curves, previous = [], [], None
    for n in (9, 17, 33) if reduced else (17, 33, 65):
        y, u = profile(runner, n)
        wanted = [exact(v) for v in y]
        norm = sqrt(sum((a - b) ** 2 for a, b in zip(u, wanted))
                    / sum(b * b for b in wanted))
        order = log(previous[1] / norm) / log(n / previous[0]) \
            if previous else ""
        rows.append([n, norm, order])
        previous = (n, norm)
        curves.append((f"{n} rows", u, y, "o"))
    curves.append(("exact", wanted, y, "k-"))
    report.limit("two-layer Poiseuille: the relative error on the finest mesh",
                 previous[1], 0.01)
    report.table("poiseuille", "Two-layer Poiseuille flow, viscosities 100:1",
                 ["rows of cells", "relative error", "order"], rows)
    report.plot("poiseuille", curves, "velocity [m/s]", "y [m]")
