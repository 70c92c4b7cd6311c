# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two inviscid shear layers: what energy and momentum are lost."""

from single_fluid import METHOD, SPACES, boxes, errors, steps
from thalweg import column, finished, read_rows

PROJECTIONS = ("l2", "moving least squares", "weighted average")


def momentum(output):
    """The largest change of momentum over the fluid's mass in m/s; the step
    before the first is not in the statistics."""
    rows = read_rows(output / "statistics.csv")
    names = [k for k in rows[0] if k.startswith("momentum")]
    return max(abs(v - column(rows, name)[0]) for name in names
               for v in column(rows, name))


def verify(runner, report, reduced):
    """Each projection at several Courant numbers, one turnover."""
    n = 32 if reduced else 64
    courants = (2.,) if reduced else (.5, 2., 5., 10.)
    runs = {(space, projection, c): runner.start(
        "shear_layer", f"shear_layer_{space}_{projection}_{c:g}"
        .replace(" ", "_"),
        {**SPACES[space], **boxes(n), **steps(max(1, round(n / c)), 1.),
         METHOD + "Projection/Model": projection,
         "Postprocess/Models": "velocity error"}, 3600)
        for space in (("Q1-Q1",) if reduced else SPACES)
        for projection in (PROJECTIONS[:1] if reduced else PROJECTIONS)
        for c in courants}
    rows, curves = [], {}
    for (space, projection, c), output in finished(report, runs):
        energy = errors(output, "relative kinetic energy")
        loss = 1. - energy[-1] / energy[0]
        rows.append([space, projection, c, len(energy) - 1, loss,
                     momentum(output), output.cpu_time])
        curves.setdefault(f"{space}, {projection}", []).append((c, abs(loss)))
        report.limit(f"shear layer, {space}, {projection}, Courant {c:g}: "
                     "the change of the mean velocity", rows[-1][5], 1e-3)
    report.table("shear_layer", "Inviscid shear layers after one turnover, "
                 f"{n} by {n} cells",
                 ["spaces", "projection", "Courant number", "steps",
                  "part of the energy lost",
                  "change of the mean velocity [m/s]", "CPU s"], rows)
    report.plot("shear_layer", [
        (name, [c for c, _ in points], [e for _, e in points], "o-")
        for name, points in curves.items()], "Courant number",
        "|loss| of kinetic energy", "log")
