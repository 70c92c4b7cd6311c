# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth pulses that move with the fluid keep their peak."""

from single_fluid import METHOD, SPACES, last_error, steps
from thalweg import finished, read_rows

TURNS = 10


def peaks(output, quantity):
    """The largest value of all probes, row by row."""
    probes = read_rows(output / "point_probes.csv")
    names = [k for k in probes[0] if k.startswith(quantity)]
    return [max(float(row[name]) for name in names) for row in probes]


def rotation(runner, report, reduced):
    """A level set in a prescribed rotation."""
    runs = {c: runner.start("gaussian_pulse", f"gaussian_pulse_{c:g}", {
        "Postprocess/Models": "point probes", "Time/Courant number": c,
        "Time/End time": 1 if reduced else TURNS})
        for c in ((5.,) if reduced else (.5, 2., 5., 20.))}
    rows = []
    for courant, output in finished(report, runs):
        found = peaks(output, "level set")
        rows.append([courant, len(read_rows(output / "statistics.csv")),
                     len(found) - 1, found[0], found[-1] / found[0] - 1.])
        report.limit(f"Gaussian pulse, Courant {courant:g}: the change of "
                     "the peak", abs(rows[-1][-1]), .005)
    report.table("gaussian_pulse",
                 "A Gaussian pulse in a rotation, 64 by 64 cells",
                 ["Courant number", "steps", "turns", "peak at the start",
                  "relative change of the peak"], rows)


def velocity(runner, report, reduced):
    """A transverse velocity in a uniform flow: the whole method at work."""
    n, passes = 64, 2 if reduced else TURNS
    runs = {(space, projection, c): runner.start(
        "pulse_in_uniform_flow",
        f"pulse_{space}_{projection}_{c:g}".replace(" ", "_"),
        {**SPACES[space], **steps(round(n * passes / c), float(passes)),
         METHOD + "Projection/Model": projection})
        for space in (("Q1-Q1",) if reduced else SPACES)
        for projection in (("l2",) if reduced else (
            "l2", "moving least squares", "weighted average"))
        for c in ((5.,) if reduced else (.3, 1.3, 5., 11.))}
    rows = []
    for (space, projection, c), output in finished(report, runs):
        found = peaks(output, "velocity y")
        errors = read_rows(output / "velocity_error.csv")
        rows.append([space, projection, c, len(errors) - 1, found[0],
                     found[-1] - 1., last_error(output)])
        report.limit(f"pulse in uniform flow, {space}, {projection}, Courant "
                     f"{c:g}: the change of the peak", abs(found[-1] - 1.),
                     .005)
    report.table("pulse_in_uniform_flow",
                 f"A pulse of velocity that passes {passes} times through a "
                 f"box of {n} cells",
                 ["spaces", "projection", "Courant number", "steps",
                  "peak at the start", "relative change of the peak",
                  "relative error"], rows)


def verify(runner, report, reduced):
    """What is left of the peaks after ten turns."""
    rotation(runner, report, reduced)
    velocity(runner, report, reduced)
