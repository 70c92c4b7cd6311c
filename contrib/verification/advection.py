# SPDX-License-Identifier: LGPL-2.1-or-later
"""Interfaces in prescribed velocities against published errors."""

from thalweg import REFERENCE, read_rows

# case: reference test, dimension, end time, steps for Courant number 1 on one
# cell a side, column of the error, what keeps reversing flows symmetric.
CASES = {
    "single_vortex": ("vortex_T8", 2, 8., 8., "error [m^2]"),
    "zalesak_disk": ("zalesak_unit_box", 2, 1., 3.14159265, "relative error"),
    "leveque_3d": ("leveque3d_T3", 3, 3., 6., "error [m^3]"),
}
# Cells a side: Courant numbers; meshes beyond the published ones' take larger
# steps alone.
FULL = {"single_vortex": {32: (.5, 2., 5., 10.), 64: (.5, 2., 5., 10.),
                          128: (.5, 2., 5., 10.)},
        "zalesak_disk": {50: (.5, 2., 5., 10.), 100: (.5, 2., 5., 10.),
                         200: (2., 10.)},
        "leveque_3d": {32: (.5, 2., 5., 10.), 64: (10.,)}}
REDUCED = {"single_vortex": {64: (2.,)}, "zalesak_disk": {50: (2.,)}}


def run_one(runner, case, n, courant):
    """The rows of one run's interface_error.csv, and its number of steps."""
    _, dim, end, rate, _ = CASES[case]
    steps = 2 * max(1, round(rate * n / courant / 2))  # symmetric about T/2
    output = runner.run(case, f"{case}_{n}_{courant:g}", {
        "Geometry/box/Repetitions": ", ".join([str(n)] * dim),
        "Refinement/Global levels": 0,
        "Time/Time step": repr(end / steps),
        "Time/Hit multiples of": 0,
        "Postprocess/Models": "interface error"})
    return read_rows(output / "interface_error.csv"), steps


def verify(runner, report, reduced):
    """Runs all cases; ours must be below all that was published."""
    published = read_rows(REFERENCE / "interface_advection_errors.csv")
    rows = []
    curves = {}
    for case, resolutions in (REDUCED if reduced else FULL).items():
        test, _, _, _, column = CASES[case]
        for n, courants in resolutions.items():
            others = sorted((float(r["error"]), r["method"])
                            for r in published
                            if r["test"] == test and int(r["N"]) == n)
            for courant in courants:
                result, steps = run_one(runner, case, n, courant)
                error = float(result[-1][column])
                rows.append([test, f"Thalweg, Courant {courant:g}, "
                             f"{steps} steps", n, error,
                             float(result[0][column]),
                             float(result[-1]["relative volume error"])])
                report.limit(f"{test} on {n} cells a side, Courant "
                             f"{courant:g}: the error", error, others[0][0])
                if courant == courants[-1]:
                    curves.setdefault(case, []).append((n, error, others))
            rows += [[test, method, n, error, "", ""]
                     for error, method in others]
    report.table("advection", "Errors of interface advection",
                 ["test", "method", "cells a side", "error",
                  "error at the start", "relative volume error"], rows)
    for case, points in curves.items():
        sizes = [n for n, _, _ in points]
        report.plot("advection_" + case, [
            ("Thalweg", sizes, [e for _, e, _ in points], "o-"),
            ("best published", sizes, [o[0][0] for _, _, o in points], "s--"),
            ("worst published", sizes, [o[-1][0] for _, _, o in points],
             "^--")], "cells a side", CASES[case][4])
