# SPDX-License-Identifier: LGPL-2.1-or-later
"""A progressive wave: does it keep its energy, height and speed?"""

import cmath
from math import pi

from thalweg import column, read_rows

DEPTH, GRAVITY, AMPLITUDE = .5, 9.81, .02
WATER, AIR = 1000., 1.2
PERIOD = 0.796452
GAUGES = 40


def energy(rows):
    """That of the wave: what is above water and air at rest, in J/m."""
    rest = GRAVITY / 2 * (WATER * DEPTH**2 + AIR * (1 - DEPTH**2))
    return [k + p - rest for k, p in zip(column(rows, "kinetic energy [J]"),
                                         column(rows,
                                                "potential energy [J]"))]


def harmonics(rows):
    """The first harmonic of the elevation at each time, and the root mean
    square of what is left without the first four."""
    places = [(i + .5) / GAUGES for i in range(GAUGES)]
    waves = [[cmath.exp(2j * pi * m * x) for x in places] for m in range(5)]
    first, rough = [], []
    for row in rows:
        z = [float(row[f"top {i} [m]"]) - DEPTH for i in range(GAUGES)]
        for m, wave in enumerate(waves):
            c = sum(v * w for v, w in zip(z, wave)) / GAUGES * (2 if m else 1)
            if m == 1:
                first.append(c)
            z = [v - (c * w.conjugate()).real for v, w in zip(z, wave)]
        rough.append((sum(v * v for v in z) / GAUGES) ** .5)
    return first, rough


def phase(first, times):
    """By how many wavelengths the wave is ahead at the end."""
    turns = sum(cmath.phase(b / a) for a, b in zip(first, first[1:]))
    return turns / (2 * pi) - (times[-1] - times[0]) / PERIOD


def mean(values):
    """The mean of a list."""
    return sum(values) / len(values)


def progressive(runner, report, reduced):
    """Energies are means over the first quarter and the last period, heights
    over the first and last half of one."""
    rows, curves = [], []
    n_periods = 2 if reduced else 10
    settings = [(20, 80)] if reduced else [(20, 80), (40, 80), (40, 40),
                                           (40, 20), (80, 80)]
    for cells, steps in settings:
        output = runner.run("wave_periodic", f"wave_{cells}_{steps}", {
            "Geometry/box/Repetitions": f"{cells}, {cells}",
            "Time/Time step": repr(PERIOD / steps),
            "Time/End time": repr(n_periods * PERIOD)}, 1800)
        table = read_rows(output / "statistics.csv")
        e = energy(table)
        gauges = read_rows(output / "water_height_gauges.csv")
        first, rough = harmonics(gauges)
        change = mean(e[-steps:]) / mean(e[:steps // 4]) - 1
        ahead = phase(first, column(gauges, "time [s]"))
        rows.append([cells, steps, change,
                     mean([abs(c) for c in first[-steps // 2:]]) / AMPLITUDE,
                     ahead, mean(rough[1:10]), mean(rough[-10:])])
        curves.append((f"{cells} cells, {steps} steps",
                       [t / PERIOD for t in column(table, "time [s]")],
                       [v / e[0] for v in e], "-"))
        where = f"progressive wave, {cells} cells a wavelength, {steps} steps " \
                "a period: "
        if reduced:
            report.limit(where + "the change of energy", abs(change), .03)
            continue
        report.limit(where + "the change of energy", abs(change),
                     .02 if cells > 20 and steps > 20 else .05)
        if cells == 40:
            report.limit(where + "the wavelengths that it is ahead",
                         abs(ahead), .015)
    report.table("wave_periodic",
                 f"Progressive wave, {n_periods} periods",
                 ["cells a wavelength", "steps a period", "change of energy",
                  "amplitude at the end", "wavelengths ahead",
                  "roughness at the start [m]", "at the end [m]"], rows)
    report.plot("wave_periodic", curves, "periods", "energy / at the start")


def verify(runner, report, reduced):
    """Everything above."""
    progressive(runner, report, reduced)
