# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bar that melts from one end, against F. Neumann's solution (Carslaw and
Jaeger 1959, section 11.2)."""

import math

from thalweg import finished, read_rows

# Where the bar is at its melting point and where it is colder at the start:
# initial value, end in s
PROBLEMS = {"at its melting point": (0., .3), "colder": (-.5, .05)}
# Warming the melt to the temperature of the end takes this part of the latent
# heat.
STEFAN = .5


def factor(initial):
    """The front is at this times the square root of time."""
    low, high = 1e-6, 3.
    for _ in range(100):
        middle = .5 * (low + high)
        excess = (math.exp(-middle ** 2)
                  * (STEFAN / math.erf(middle)
                     + initial * STEFAN / math.erfc(middle))
                  - middle * math.sqrt(math.pi))
        low, high = (middle, high) if excess > 0. else (low, middle)
    return 2. * low


def verify(runner, report, reduced):
    """Where the front is at the end, on meshes and in steps of several sizes."""
    meshes = (100,) if reduced else (25, 50, 100, 200)
    numbers = (100,) if reduced else (25, 50, 100, 200, 400)
    runs = {(name, n, steps): runner.start(
        "melting_bar", f"melting_{name.replace(' ', '_')}_{n}_{steps}",
        {"Geometry/box/Repetitions": f"{n}, 5",
         "Methods/temperature/Initial value": repr(initial),
         "Time/End time": repr(end), "Time/Time step": repr(end / steps),
         "Postprocess/Models": ""})
        for name, (initial, end) in PROBLEMS.items()
        for n in meshes for steps in numbers}
    rows = []
    for (name, n, steps), output in finished(report, runs):
        initial, end = PROBLEMS[name]
        row = read_rows(output / "statistics.csv")[-1]
        front = float(row["temperature: molten part"])
        deviation = front / (factor(initial) * math.sqrt(end)) - 1.
        rows.append([name, n, steps, front, deviation,
                     float(row["temperature: unaccounted"])])
        if n >= 100 and steps >= 50:
            report.limit(f"melting of a bar {name}, {n} cells, {steps} steps: "
                         "the front", abs(deviation), .01)
    report.table("melting", "A bar that melts from one end against Neumann",
                 ["bar at the start", "cells", "steps", "front", "deviation",
                  "unaccounted heat"], rows)
