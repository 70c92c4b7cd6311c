# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Bingham fluid between plates: the plug and the layers beside it."""

from math import sqrt

from thalweg import order, read_rows

PLUG = .4  # half of its height, m


def exact(y):
    """The velocity in m/s for the force density 1 N/m^3, mu = 1 Pa s."""
    beside = max(abs(y) - PLUG, 0.)
    return .5 * (1. - PLUG) ** 2 - .5 * beside ** 2


def verify(runner, report, reduced):
    """Norms of the error at the nodes, and their order."""
    rows, curves, previous = [], [], None
    for n in (16, 32) if reduced else (16, 32, 64):
        heights = [-1. + 2. * j / n for j in range(1, n)]
        output = runner.run("bingham_channel", f"bingham_{n}", {
            "Geometry/box/Repetitions": f"{max(2, n // 8)}, {n}",
            "Time/End time": "6" if reduced else "12",
            "Fluids/First fluid/Rheology/bingham/Growth time": "10000",
            "Postprocess/point probes/Points":
                "; ".join(f"0.125, {y!r}" for y in heights)})
        last = read_rows(output / "point_probes.csv")[-1]
        u = [float(last[k]) for k in last if k.startswith("velocity x")]
        norm = sqrt(sum((a - exact(y)) ** 2 for a, y in zip(u, heights))
                    / sum(exact(y) ** 2 for y in heights))
        steps = read_rows(output / "statistics.csv")
        iterations = sum(float(r["rheology iterations"]) for r in steps)
        rows.append([n, norm,
                     order(previous, norm, 2.) if previous else "",
                     u[n // 2 - 1] / exact(0.) - 1., iterations / len(steps)])
        previous = norm
        curves.append((f"{n} rows", u, heights, "o"))
    curves.append(("exact", [exact(y) for y in heights], heights, "k-"))
    report.limit("Bingham fluid in a channel: the relative error on the finest "
                 "mesh", previous, .005 if reduced else .002)
    report.table("bingham", "A Bingham fluid between plates",
                 ["rows of cells", "relative error", "order",
                  "deviation of the plug", "Newton iterations a step"], rows)
    report.plot("bingham", curves, "velocity [m/s]", "y [m]")
