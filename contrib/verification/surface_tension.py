# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface tension: drops at rest, oscillating and on a wall, a capillary wave,
and a rising bubble."""

import cmath
from math import cos, erfc, exp, pi, sin, sqrt

from thalweg import column, order, read_rows

# S. Hysing et al., Int. J. Numer. Methods Fluids 60, 2009, case 1: group 3
# (MooNMD), finest level: time, circularity, height of the centre, rise velocity.
BUBBLE = [
    (.3, .999973, .521220, .133826), (.6, .997899, .575401, .217477),
    (.9, .980720, .645502, .241568), (1.2, .946417, .717195, .233793),
    (1.5, .916041, .785088, .218605), (1.8, .902084, .848501, .204736),
    (2.1, .903822, .908394, .195465), (2.4, .912377, .966342, .191737),
    (2.7, .919087, 1.023856, .192154), (3., .920707, 1.081753, .193798)]


def read_columns(path):
    """The columns of a CSV file by their names, as numbers."""
    rows = read_rows(path)
    return {name: column(rows, name) for name in rows[0]}


def growing_erfc(z):
    """exp(z^2) erfc(z) for a complex z, by its integral:
    2 / sqrt(pi) int_0^inf exp(-s^2 - 2 z s) ds, mirrored for Re z < 0."""
    if z.real < 0.:
        return 2. * cmath.exp(z * z) - growing_erfc(-z)
    n, end = 4000, 6.5
    h = end / n
    total = 0.
    for i in range(n + 1):
        s = i * h
        weight = 1. if i in (0, n) else 4. if i % 2 else 2.
        total += weight * cmath.exp(-s * s - 2. * z * s)
    return 2. / sqrt(pi) * total * h / 3.


def roots(coefficients):
    """Of a polynomial with first coefficient 1 (Durand and Kerner)."""
    n = len(coefficients) - 1
    z = [(.4 + .9j) ** i * abs(coefficients[-1]) ** (1. / n) for i in range(n)]
    for _ in range(200):
        for i in range(n):
            value = 0.
            for c in coefficients:
                value = value * z[i] + c
            others = 1.
            for j in range(n):
                if j != i:
                    others *= z[i] - z[j]
            z[i] -= value / others
    return z


def prosperetti(time, nu, k, density_1, density_2, sigma):
    """The height of a standing wave in parts of the first (A. Prosperetti,
    Phys. Fluids 24, 1981): two deep fluids with the same nu, at rest at first."""
    beta = density_1 * density_2 / (density_1 + density_2) ** 2
    squared = sigma * k ** 3 / (density_1 + density_2)
    e = nu * k * k
    a = (1. - 4. * beta) * e * e
    total = 4. * a / (8. * a + squared) * erfc(sqrt(e * time))
    z = roots([1., -4. * beta * sqrt(e), 2. * (1. - 6. * beta) * e,
               4. * (1. - 3. * beta) * e ** 1.5, a + squared])
    for i in range(4):
        others = 1.
        for j in range(4):
            if j != i:
                others *= z[j] - z[i]
        total += (z[i] / others * squared / (z[i] ** 2 - e) * exp(-e * time)
                  * growing_erfc(z[i] * sqrt(time))).real
    return total


def at_rest(runner, report, reduced):
    """Velocities that errors of the curvature drive, and the pressure."""
    rows = []
    for n in (16,) if reduced else (16, 32, 64):
        output = runner.run("static_drop", f"static_drop_{n}", {
            "Geometry/box/Repetitions": f"{n}, {n}"})
        last = read_rows(output / "statistics.csv")[-1]
        probes = read_rows(output / "point_probes.csv")[-1]
        pressure = [float(probes[k]) for k in probes if "pressure" in k]
        rows.append([n, (pressure[0] - pressure[1]) / 4. - 1.,
                     float(last["max velocity 1 [m/s]"]),
                     float(last["max velocity 2 [m/s]"])])
    report.limit("Drop at rest: error of the pressure inside",
                 max(abs(r[1]) for r in rows), .01)
    report.limit("Drop at rest: velocity in m/s, where the gas could have 2",
                 max(r[3] for r in rows), 2e-3)
    output = runner.run("static_drop", "static_drop_exact", {
        "Interface/Surface tension/Curvature": "4", "Time/End time": "2"})
    last = read_rows(output / "statistics.csv")[-1]
    rows.append(["32, exact curvature", 0.,
                 float(last["max velocity 1 [m/s]"]),
                 float(last["max velocity 2 [m/s]"])])
    report.limit("Drop at rest with its exact curvature: velocity",
                 rows[-1][3], 1e-9)
    report.table("static_drop", "A drop at rest",
                 ["cells", "error of the pressure", "velocity in the drop [m/s]",
                  "in the gas [m/s]"], rows)


def wave(runner, report, reduced):
    """The height of a capillary wave against Prosperetti's."""
    rows, curves, previous = [], [], None
    for n in (16, 32) if reduced else (16, 32, 64):
        output = runner.run("capillary_wave", f"capillary_wave_{n}", {
            "Geometry/box/Repetitions": f"{n // 2}, {2 * n}"})
        gauges = read_columns(output / "water_height_gauges.csv")
        times = gauges["time [s]"]
        heights = [h - 1. for h in gauges["wet height 0 [m]"]]
        every = max(1, len(times) // 100)
        times, heights = times[::every], heights[::every]
        exact = [.01 * prosperetti(t, .0182571749236, 2. * pi, 1., 1., 1.)
                 if t > 0. else .01 for t in times]
        norm = sqrt(sum((a - b) ** 2 for a, b in zip(heights, exact))
                    / len(times)) / .01
        rows.append([n, norm, order(previous, norm, 2.) if previous else ""])
        previous = norm
        if n == 32:
            curves.append((f"{n} cells", times, heights, "."))
            curves.append(("exact", times, exact, "k-"))
    report.limit("Capillary wave: RMS of the error in parts of the amplitude, "
                 "finest mesh", previous, .02 if reduced else .005)
    report.table("capillary_wave", "A capillary wave",
                 ["cells a wavelength", "RMS error / amplitude", "order"], rows)
    report.plot("capillary_wave", curves, "time [s]", "height [m]")


def frequency(times, energies):
    """Half of that with which an energy swings: the best fit of a - b cos(2 w
    t + c), by golden section."""
    def misfit(w):
        sums = [[0.] * 4 for _ in range(3)]
        for t, e in zip(times, energies):
            row = (1., cos(2. * w * t), sin(2. * w * t), e)
            for i in range(3):
                for j in range(4):
                    sums[i][j] += row[i] * row[j]
        for i in range(3):
            for j in range(i + 1, 3):
                factor = sums[j][i] / sums[i][i]
                for k in range(i, 4):
                    sums[j][k] -= factor * sums[i][k]
        u = [0.] * 3
        for i in (2, 1, 0):
            u[i] = (sums[i][3] - sum(sums[i][j] * u[j]
                                     for j in range(i + 1, 3))) / sums[i][i]
        return sum((u[0] + u[1] * cos(2. * w * t) + u[2] * sin(2. * w * t) - e)
                   ** 2 for t, e in zip(times, energies))

    candidates = [.4 + .002 * i for i in range(201)]
    best = min(candidates, key=misfit)
    low, high = best - .002, best + .002
    for _ in range(40):
        a, b = low + .382 * (high - low), low + .618 * (high - low)
        if misfit(a) < misfit(b):
            high = b
        else:
            low = a
    return .5 * (low + high)


def oscillation(runner, report, reduced):
    """The frequency of a drop."""
    exact, rows = sqrt(6. / 1001. / .25 ** 3), []
    for n in (16,) if reduced else (16, 32, 64):
        output = runner.run("oscillating_drop", f"oscillating_drop_{n}", {
            "Geometry/box/Repetitions": f"{n}, {n}"})
        columns = read_columns(output / "statistics.csv")
        found = frequency(columns["velocity time [s]"],
                          columns["kinetic energy [J]"])
        rows.append([n, found, found / exact - 1.])
    report.limit("Oscillating drop: error of the frequency, finest mesh",
                 abs(rows[-1][2]), .03 if reduced else .01)
    report.table("oscillating_drop", "An oscillating drop",
                 ["cells", "frequency [1/s]", "relative error"], rows)


def difference(times, values, quantity):
    """The largest one from a column of BUBBLE, between two steps linearly."""
    largest = 0.
    for row in BUBBLE:
        after = next((i for i, t in enumerate(times) if t >= row[0]),
                     len(times) - 1)
        part = (row[0] - times[after - 1]) / (times[after] - times[after - 1])
        value = values[after - 1] + part * (values[after] - values[after - 1])
        largest = max(largest, abs(value - row[quantity]))
    return largest


def bubble(runner, report, reduced):
    """Centre, velocity and circularity against those of Hysing et al."""
    rows, curves = [], []
    for n in (20,) if reduced else (20, 40, 80):
        output = runner.run("rising_bubble", f"rising_bubble_{n}", {
            "Geometry/box/Repetitions": f"{n}, {2 * n}"})
        mass = read_columns(output / "center_of_mass.csv")
        area = read_columns(output / "interface_area.csv")
        times = mass["time [s]"]
        # Velocities are those of the middle of a step.
        later = [0.] + read_columns(output / "statistics.csv")[
            "velocity time [s]"]

        y = difference(times, mass["gas center y [m]"], 2) / BUBBLE[-1][2]
        v = difference(later, mass["gas velocity y [m/s]"], 3) / .2417
        c = difference(times, area["gas roundness"], 1)
        rows.append([n, len(times) - 1, y, v, c,
                     max(mass["gas velocity y [m/s]"]),
                     min(area["gas roundness"][2:])])
        curves.append((f"{n} x {2 * n} cells", later,
                       mass["gas velocity y [m/s]"], "-"))
    curves.append(("Hysing et al.", [r[0] for r in BUBBLE],
                   [r[3] for r in BUBBLE], "ko"))
    report.limit("Rising bubble: error of the centre", rows[-1][2], .01)
    report.limit("Rising bubble: error of the velocity", rows[-1][3],
                 .05 if reduced else .01)
    report.table("rising_bubble", "A rising bubble",
                 ["cells across", "steps", "error of the centre",
                  "of the velocity", "of the circularity",
                  "greatest velocity [m/s]", "least circularity"], rows)
    report.plot("rising_bubble", curves, "time [s]", "rise velocity [m/s]")


def on_wall(runner, report, reduced):
    """The height of a drop on the floor, by its contact angle."""
    rows = []
    for angle in (60,) if reduced else (30, 60, 90, 120, 150):
        theta = angle * pi / 180.
        radius = sqrt(pi * .25 ** 2 / 2. / (theta - sin(theta) * cos(theta)))
        exact = radius * (1. - cos(theta))
        output = runner.run("drop_on_wall", f"drop_on_wall_{angle}", {
            "Geometry/box/Upper corner": "2, 0.5",
            "Geometry/box/Repetitions": "64, 16",
            "Initial conditions/Level set": "sqrt((x - 1)^2 + y^2) - 0.25",
            "Postprocess/water height gauges/Positions": "1",
            "Interface/Surface tension/Contact angles": f"bottom: {angle}",
            "Time/End time": "10" if reduced else "60"})
        top = float(read_rows(output / "water_height_gauges.csv")[-1]
                    ["top 0 [m]"])
        rows.append([angle, top, exact, top / exact - 1.])
    report.limit("Drop on a wall: error of its height at 60 degrees",
                 abs([r for r in rows if r[0] == 60][0][3]), .02)
    report.table("drop_on_wall", "A drop on a wall",
                 ["contact angle [degrees]", "height [m]", "exact [m]",
                  "relative error"], rows)


def verify(runner, report, reduced):
    """All of them."""
    at_rest(runner, report, reduced)
    wave(runner, report, reduced)
    oscillation(runner, report, reduced)
    on_wall(runner, report, reduced)
    bubble(runner, report, reduced)
