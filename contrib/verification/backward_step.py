"""Where the flow attaches again behind a step, against Erturk (2008)."""

from thalweg import REFERENCE, column, finished, read_rows


# Global levels of two meshes.
LEVELS = (1, 2)


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
    runs = {(re, level): runner.start(
        "backward_step", f"backward_step_{re}_{level}",
        settings(re, level, 20. if reduced else 250.), 3600)
        for level in levels for re in numbers}
    rows, lengths = [], {}
    for (re, level), output in finished(report, runs):
        length, last = (reattachment(output, mean) for mean in "10")
        lengths.setdefault(level, []).append((re, length))
        rows.append([re, 4 * 2 ** level, length, last, table[re],
                     length / table[re] - 1., output.cpu_time])
        if level == levels[-1]:
            report.limit(f"backward step, Re {re}: the deviation of the "
                         "reattachment length", abs(rows[-1][5]),
                         .12 if reduced else .03)
    rows.sort(key=lambda row: row[:2])
    report.table("backward_step", "Backward-facing step: reattachment",
                 ["Re", "cells a step height", "mean length / step height",
                  "last zero of the shear at the end", "Erturk", "deviation",
                  "CPU s"],
                 rows)
    report.plot("backward_step", [
        (f"{4 * 2 ** level} cells a step", [r for r, _ in points],
         [x for _, x in points], "o-") for level, points in lengths.items()]
        + [("Erturk (2008)", list(table), list(table.values()), "k--")],
        "Re", "reattachment length / step height")
