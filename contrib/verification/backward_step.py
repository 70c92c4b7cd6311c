# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the flow attaches again behind a step, against Erturk (2008)."""

from single_fluid import METHOD, SPACES
from thalweg import REFERENCE, column, finished, read_rows


# Global levels of two meshes.
LEVELS = (0, 1)
# What linear elements leave to particles alone, the flow would amplify.
SETTINGS = {"Q2-Q2": SPACES["Q2-Q2"],
            "Q1-Q1": {**SPACES["Q1-Q1"], METHOD + "Increment blend": .1}}


def settings(reynolds, level, end):
    """The case with the wall shear averaged over the last part of the run."""
    return {"Fluids/First fluid/Viscosity": repr(2 / reynolds),
            "Refinement/Global levels": level, "Time/End time": end,
            "Postprocess/Models": "surface coefficients",
            "Postprocess/surface coefficients/Interval": repr(end),
            "Postprocess/surface coefficients/Average from": repr(.6 * end)}


def reattachment(output, averaged):
    """Where the wall shear on the floor last changes from negative to
    positive, in step heights."""
    rows = read_rows(output / "surface_coefficients_zero_shear.csv")
    end = max(column(rows, "time [s]"))
    return max((float(row["x [m]"]) for row in rows
                if row["averaged"] == averaged and
                float(row["time [s]"]) == end and
                float(row["sign behind"]) > 0), default=float("nan"))


def verify(runner, report, reduced):
    """Reynolds numbers from 100 to 800."""
    table = {int(r["Re"]): float(r["xr_over_h"]) for r in read_rows(
        REFERENCE / "backward_step_reattachment.csv")
        if r["source"] == "Erturk2008_numeric"}
    numbers = (100,) if reduced else (100, 200, 300, 400, 500, 600, 700, 800)
    levels = LEVELS[:1] if reduced else LEVELS
    spaces = ("Q2-Q2",) if reduced else SETTINGS
    runs = {(re, space, level): runner.start(
        "backward_step", f"backward_step_{re}_{space}_{level}",
        {**SETTINGS[space],
         **settings(re, level, 20. if reduced else 250.)}, 3600)
        for space in spaces for re in numbers for level in levels}
    rows, lengths = [], {}
    for (re, space, level), output in finished(report, runs):
        length, last = (reattachment(output, mean) for mean in "10")
        cells = f"{space}, {4 * 2 ** level} cells a step"
        lengths.setdefault(cells, []).append((re, length))
        rows.append([re, space, 4 * 2 ** level, length, last, table[re],
                     length / table[re] - 1., output.cpu_time])
        if level == levels[-1]:
            report.limit(f"backward step, Re {re}, {space}: the deviation of "
                         "the reattachment length", abs(rows[-1][6]),
                         .12 if reduced else .03)
    report.table("backward_step", "Backward-facing step: reattachment",
                 ["Re", "spaces", "cells a step height", "mean length / step height",
                  "last zero of the shear at the end", "Erturk", "deviation",
                  "CPU s"],
                 rows)
    report.plot("backward_step", [
        (cells, [r for r, _ in points], [x for _, x in points], "o-")
        for cells, points in lengths.items()]
        + [("Erturk (2008)", list(table), list(table.values()), "k--")],
        "Re", "reattachment length / step height")
