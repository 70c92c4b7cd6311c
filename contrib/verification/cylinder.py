# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cylinder in a channel against Schaefer and Turek (1996)."""

from single_fluid import SPACES, TAYLOR_HOOD
from thalweg import (REFERENCE, column, finished, read_rows,
                     steps_and_courant)

ALL_SPACES = {**SPACES, **TAYLOR_HOOD}
# The global levels of three meshes; runs on the finest take ten minutes at most.
MESHES = {"2D-1": {"Q1-Q1": (2, 3, 4), "Q2-Q2": (1, 2, 3),
                   "Q2-Q1": (1, 2, 3)},
          "2D-2": {"Q1-Q1": (1, 2, 3), "Q2-Q2": (0, 1, 2),
                   "Q2-Q1": (0, 1, 2)}}
# The mesh on which steps differ.
COURANT_MESH = 3
COURANT = (1., 3., 10.)
# On all meshes; with 3.5 the periodic flow takes a third of 8,000 steps.
COURANT_OF_MESH = {"2D-1": 5., "2D-2": 3.5}


def intervals(case):
    """quantity: (lower, upper) of the published intervals."""
    return {r["quantity"]: (float(r["lower_1996"]), float(r["upper_1996"]))
            for r in read_rows(REFERENCE / "cylinder_schaefer_turek.csv")
            if r["case"] == case}


def pressure_difference(row):
    """That of the two probes in Pa."""
    return float(row["pressure 0 [Pa]"]) - float(row["pressure 1 [Pa]"])


def steady(output):
    """(c_D, c_L, pressure difference), means over the time that the case
    says, and the rms of c_L; forces by the residual."""
    row = read_rows(output / "body_forces_summary.csv")[-1]
    probes = [pressure_difference(r)
              for r in read_rows(output / "point_probes.csv")
              if float(r["time [s]"]) >= float(row["from [s]"])]
    return (float(row["residual c_D mean"]), float(row["residual c_L mean"]),
            sum(probes) / len(probes), float(row["residual c_L rms"]))


def periodic(output):
    """(largest c_D, largest c_L, Strouhal number, pressure difference half a
    period after the last maximum of the lift but one), by the residual."""
    row = read_rows(output / "body_forces_summary.csv")[-1]
    strouhal = float(row["Strouhal number by zero crossings"] or "nan")
    forces = read_rows(output / "body_forces.csv")
    t, lift = column(forces, "time [s]"), column(forces, "residual c_L")
    period = .1 / strouhal
    window = [i for i in range(len(t)) if t[-1] - 2 * period < t[i]
              <= t[-1] - period]
    top = t[max(window, key=lift.__getitem__)]
    probes = read_rows(output / "point_probes.csv")
    nearest = min(probes, key=lambda r: abs(
        float(r["time [s]"]) - top - period / 2))
    return (float(row["residual c_D maximum"]),
            float(row["residual c_L maximum"]), strouhal,
            pressure_difference(nearest))


CASES = {
    "2D-1": ("cylinder_2d_1", steady, ("c_D", "c_L", "delta_p"),
             ["rms of c_L"]),
    "2D-2": ("cylinder_2d_2", periodic,
             ("c_D_max", "c_L_max", "St", "delta_p"), []),
}


def study(runner, report, name, reduced):
    """Three meshes of each pair of spaces, and three Courant numbers on one."""
    case, evaluate, quantities, more = CASES[name]
    of_mesh = COURANT_OF_MESH[name]
    keys = [(space, m, of_mesh)
            for space, meshes in MESHES[name].items() for m in meshes]
    keys += [("Q1-Q1", COURANT_MESH, c) for c in COURANT]
    if reduced:
        keys = [("Q1-Q1", 2, of_mesh), ("Q2-Q1", 1, of_mesh)]
    runs = {(space, m, c): runner.start(
        case, f"{case}_{space}_{m}_{c:g}",
        {**ALL_SPACES[space], "Refinement/Global levels": m,
         "Time/Courant number": c,
         "Postprocess/Models": "body forces, point probes"}, 3600)
        for space, m, c in keys}
    wanted = intervals(name)
    rows = []
    for (space, m, c), output in finished(report, runs):
        values = evaluate(output)
        n_steps, _ = steps_and_courant(output)
        cells = read_rows(output / "statistics.csv")[-1]["cells"]
        rows.append([space, cells, c, n_steps, *values, output.cpu_time])
        if m == MESHES[name][space][-1] and c == of_mesh:
            for quantity, value in zip(quantities, values):
                report.within(f"cylinder {name}, {space}, {cells} cells: "
                              f"{quantity}", value, *wanted[quantity])
            report.limit(f"cylinder {name}, {space}, {cells} cells: the CPU "
                         "time", output.cpu_time, 600)
        if reduced:
            report.within(f"cylinder {name}, {space}, {cells} cells: c_D",
                          values[0],
                          .9 * wanted[quantities[0]][0],
                          1.1 * wanted[quantities[0]][1])
    for limit, which in (("lower limit", 0), ("upper limit", 1)):
        rows.append(["Schaefer and Turek, " + limit, "", "", "",
                     *(wanted[q][which] for q in quantities),
                     *("" for _ in more), ""])
    report.table("cylinder_" + name.lower().replace("-", "_"),
                 f"Cylinder in a channel, {name}",
                 ["spaces", "cells", "Courant number", "steps",
                  *quantities, *more, "CPU s"], rows)


def verify(runner, report, reduced):
    """Steady flow at Re 20, periodic flow at Re 100."""
    study(runner, report, "2D-1", reduced)
    if not reduced:
        study(runner, report, "2D-2", reduced)
