# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tanks that are shaken, turned and spun against linear theory and exact
surfaces; all seen from the tank."""

from math import cos, pi, sin, sqrt, tan, tanh

from sloshing import DEPTH, GRAVITY, LENGTH, amplitude
from thalweg import column, read_rows

HEIGHT, ACCELERATION, DENSITY_OF_AIR = .438, .1, 1e-3


def frequency(n):
    """Of a mode between water and air, rad/s."""
    k = n * pi / LENGTH
    return sqrt((1 - DENSITY_OF_AIR) * GRAVITY * k / (
        1 / tanh(k * DEPTH) + DENSITY_OF_AIR / tanh(k * (HEIGHT - DEPTH))))


def mode(n, t, shaking):
    """Amplitude of an odd mode, m, when a tank at rest is shaken with
    ACCELERATION sin(shaking t)."""
    w = frequency(n)
    force = 4 * LENGTH * w ** 2 / ((n * pi) ** 2 * GRAVITY) * ACCELERATION
    return force * (sin(shaking * t) - shaking / w * sin(w * t)) / (
        w ** 2 - shaking ** 2)


def wall(output, gauge):
    """The elevation at a gauge."""
    rows = read_rows(output / "water_height_gauges.csv")
    return [float(row[f"wet height {gauge} [m]"]) - DEPTH for row in rows]


def root_mean_square(values):
    """Of a list."""
    return sqrt(sum(v * v for v in values) / len(values))


def shaken(runner, report, reduced):
    """The first mode and the wall at 0.8 and 1.2 of the first frequency."""
    rows, curves = [], []
    period = 2 * pi / frequency(1)
    runs = [(40, 2)] if reduced else [(160, 2), (80, 2), (40, 2), (20, 2),
                                      (80, 10), (40, 10)]
    for ratio in (.8, 1.2):
        for steps, n_periods in runs:
            shaking = ratio * frequency(1)
            output = runner.run(
                "sloshing_forced",
                f"sloshing_forced_{ratio}_{steps}_{n_periods}", {
                    "Time/Time step": repr(period / steps),
                    "Time/End time": repr(n_periods * period),
                    "Moving frame/Displacement":
                        f"-{ACCELERATION}*sin({shaking!r}*t)/{shaking!r}^2; 0"})
            t, a = amplitude(output, DEPTH, lambda s: cos(pi * s))
            exact = [mode(1, s, shaking) for s in t]
            largest = max(abs(v) for v in exact)
            error = root_mean_square(
                [u - v for u, v in zip(a, exact)]) / root_mean_square(exact)
            peak = max(abs(v) for v in a) / largest - 1
            walls = [sum(mode(n, s, shaking) for n in range(1, 60, 2))
                     for s in t]
            walls_error = root_mean_square(
                [u - v for u, v in zip(wall(output, 0), walls)]
            ) / root_mean_square(walls)
            rows.append([ratio, n_periods, steps, largest, peak, error,
                         walls_error])
            report.limit(f"shaken at {ratio} w for {n_periods} periods, "
                         f"{steps} steps a period: the deviation of the "
                         "largest amplitude", abs(peak), .02)
            if steps == 80 and n_periods == 10:
                curves += [(f"{ratio}", t, a, "-"),
                           (f"{ratio}, theory", t, exact, "k:")]
    report.table("sloshing_forced",
                 f"Shaken tank, first period {period:.4f} s, from rest",
                 ["frequency / first one", "periods", "steps a period",
                  "largest amplitude [m]", "its deviation",
                  "error of the first mode (RMS)",
                  "error at the wall (RMS)"], rows)
    report.plot("sloshing_forced", curves, "time [s]", "first mode [m]")


def turned(runner, report):
    """The surface stays level in space while the tank turns."""
    rows = []
    for steps in (.0125, .025):
        output = runner.run("tank_turning", f"tank_turning_{steps}",
                            {"Time/Time step": repr(steps)})
        table = read_rows(output / "water_height_gauges.csv")
        worst = 0.
        for row in table:
            angle = .05 * (1 - cos(.1 * pi * float(row["time [s]"])))
            for i in range(17):
                level = DEPTH - tan(angle) * LENGTH * (i / 16 - .5)
                worst = max(worst,
                            abs(float(row[f"wet height {i} [m]"]) - level))
        part = worst / (tan(.1) * LENGTH / 2)
        rows.append([steps, worst, part])
        report.limit(f"turned tank, steps of {steps} s: the deviation from "
                     "level at some gauge as a part of the rise at the wall",
                     part, .02)
    report.table("tank_turning", "A tank turned by 0.1 rad and back in 20 s",
                 ["step [s]", "largest deviation from level [m]",
                  "part of the rise at the wall"], rows)


def spun(runner, report, reduced):
    """A paraboloid that turns with the tank."""
    rows = []
    for cells in (8,) if reduced else (8, 16, 24):
        output = runner.run("tank_rotating_3d", f"tank_rotating_{cells}", {
            "Geometry/box/Repetitions":
                f"{cells}, {cells}, {cells * 3 // 4}",
            "Time/End time": ".2" if reduced else "1"})
        table = read_rows(output / "water_height_gauges.csv")
        places = [(0, 0), (.1, 0), (0, .1), (.1, .1), (-.15, 0), (.19, 0),
                  (.15, .15), (-.19, .19), (.19, -.19)]
        exact = [25 * (x * x + y * y) / (2 * GRAVITY) for x, y in places]
        last = [float(table[-1][f"wet height {i} [m]"]) - .12
                for i in range(len(places))]
        height = 25 * .08 / (2 * GRAVITY)
        error = root_mean_square(
            [u - v for u, v in zip(last, exact)]) / height
        worst = max(abs(u - v) for u, v in zip(last, exact)) / height
        speed = max(column(read_rows(output / "statistics.csv"),
                           "max velocity 1 [m/s]"))
        rows.append([cells, error, worst, speed])
        report.limit(f"spun tank, {cells} cells: the deviation of the "
                     "parabola (RMS)", error, .005 if cells > 20 else .02)
    report.table("tank_rotating", "A tank that turns with 5 rad/s, its water "
                 f"at rest in it; surface after {'0.2' if reduced else '1'} s, "
                 "0.102 m high",
                 ["cells a side", "error / height (RMS)",
                  "largest error / height", "largest velocity [m/s]"], rows)


def verify(runner, report, reduced):
    """Shaken and spun; in full runs turned, too."""
    shaken(runner, report, reduced)
    spun(runner, report, reduced)
    if not reduced:
        turned(runner, report)
