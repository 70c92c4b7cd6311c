"""Where the flow attaches again behind a step, against Erturk (2008)."""

from single_fluid import METHOD, SPACES
from thalweg import REFERENCE, finished, read_rows


def settings(reynolds, level, end):
    """The case with the wall shear ten times during the run."""
    return {"Fluids/First fluid/Viscosity": repr(2 / reynolds),
            "Refinement/Global levels": level, "Time/End time": end,
            "Time/Hit multiples of": repr(end / 10),
            "Postprocess/Models": "surface coefficients",
            "Postprocess/surface coefficients/Interval": repr(end / 10)}


def reattachment(output):
    """At each time the last place where the wall shear on the floor changes
    from negative to positive, in step heights."""
    lengths = {}
    for row in read_rows(output / "surface_coefficients_zero_shear.csv"):
        if row["averaged"] == "0" and float(row["sign behind"]) > 0:
            time, x = float(row["time [s]"]), float(row["x [m]"])
            lengths[time] = max(x, lengths.get(time, 0.))
    return [lengths[time] for time in sorted(lengths)]


def verify(runner, report, reduced):
    """Reynolds numbers from 100 to 800."""
    table = {int(r["Re"]): float(r["xr_over_h"]) for r in read_rows(
        REFERENCE / "backward_step_reattachment.csv")
        if r["source"] == "Erturk2008_numeric"}
    numbers = (100,) if reduced else (100, 200, 300, 400, 500, 600, 700, 800)
    levels = (1,) if reduced else (1, 2, 3)
    runs = {(re, level): runner.start(
        "backward_step", f"backward_step_{re}_{level}",
        {**SPACES["Q1-Q1"],
         METHOD + "Mass": "lumped", "Time/Courant number": 10,
         **settings(re, level, 30. if reduced else 60. + .4 * re)}, 3600)
        for re in numbers for level in levels}
    rows, lengths = [], {}
    for (re, level), output in finished(report, runs):
        before, length = reattachment(output)[-2:]
        lengths.setdefault(level, []).append((re, length))
        rows.append([re, 4 * 2 ** level, length, length - before, table[re],
                     length / table[re] - 1., output.cpu_time])
        if level == levels[-1]:
            report.limit(f"backward step, Re {re}: the deviation of the "
                         "reattachment length", abs(rows[-1][5]),
                         .12 if reduced else .03)
    report.table("backward_step", "Backward-facing step: reattachment",
                 ["Re", "cells a step height", "length / step height",
                  "change in the last tenth", "Erturk", "deviation", "CPU s"],
                 rows)
    report.plot("backward_step", [
        (f"{4 * 2 ** level} cells a step", [r for r, _ in points],
         [x for _, x in points], "o-") for level, points in lengths.items()]
        + [("Erturk (2008)", list(table), list(table.values()), "k--")],
        "Re", "reattachment length / step height")
