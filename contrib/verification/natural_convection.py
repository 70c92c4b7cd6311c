# SPDX-License-Identifier: LGPL-2.1-or-later
"""Natural convection: a cavity against de Vahl Davis (1983), and the onset in a
layer against Chandrasekhar (1961)."""

import math

from cavity import extremum, line
from thalweg import REFERENCE, finished, read_rows

# Rayleigh number: cells a side, end in s
FULL = {1e3: (64, .5), 1e4: (64, .5), 1e5: (64, .4), 1e6: (128, .3)}
REDUCED = {1e4: (24, .3)}
# Of the Rayleigh number, between two walls that do not slip.
CRITICAL = 1707.76


def settings(rayleigh, n, end, courant):
    """The case with probes on both centre lines."""
    points = ([f"0.5, {y!r}" for y in line(n)]
              + [f"{x!r}, 0.5" for x in line(n)])
    return {"Couplings/buoyancy/Expansion": repr(.71 * rayleigh),
            "Geometry/box/Repetitions": f"{n}, {n}",
            "Time/End time": repr(end), "Time/Courant number": courant,
            "Postprocess/Models": "scalar fluxes, point probes",
            "Postprocess/point probes/Interval": repr(end / 10),
            "Postprocess/point probes/Points": "; ".join(points)}


def results(output, n):
    """What the reference has, and how far the mean fluxes of both walls
    differ, which in steady state is nothing."""
    fluxes = read_rows(output / "temperature_fluxes.csv")[-1]
    probes = read_rows(output / "point_probes.csv")[-1]
    names = {axis: [k for k in probes if k.startswith("velocity " + axis)]
             for axis in "xy"}
    u = [float(probes[k]) for k in names["x"]][:n - 1]
    v = [float(probes[k]) for k in names["y"]][n - 1:]
    in_, out = -float(fluxes["mean left"]), float(fluxes["mean right"])
    return {"Nu_mean": in_, "Nu_max": -float(fluxes["least left"]),
            "u_max": extremum(u, 1), "v_max": extremum(v, 1)}, abs(in_ - out)


def cavity(runner, report, reduced):
    """Nusselt numbers and velocities at Rayleigh numbers from 1e3 to 1e6."""
    cases = REDUCED if reduced else FULL
    runs = {(ra, n, c): runner.start(
        "natural_convection", f"natural_convection_{ra:g}_{c:g}",
        settings(ra, n, end, c), 3600)
        for ra, (n, end) in cases.items()
        for c in ((2.,) if reduced else (2., 5.))}
    published = {float(r["Ra"]): r for r in
                 read_rows(REFERENCE / "natural_convection.csv")}
    rows = []
    for (ra, n, courant), output in finished(report, runs):
        found, imbalance = results(output, n)
        statistics = read_rows(output / "statistics.csv")
        reference = {k: float(published[ra][k]) for k in found}
        deviations = {k: found[k] / reference[k] - 1. for k in found}
        rows.append([ra, n, courant, len(statistics) - 1]
                    + [w for k in found for w in (found[k], deviations[k])]
                    + [imbalance, output.cpu_time])
        report.limit(f"natural convection, Ra {ra:g}, Courant {courant:g}: "
                     "the largest deviation",
                     max(abs(d) for d in deviations.values()),
                     .03 if reduced else .01)
    report.table(
        "natural_convection",
        "Natural convection in a square cavity against de Vahl Davis",
        ["Ra", "cells a side", "Courant number", "steps"]
        + [w for k in ("mean Nu", "largest Nu", "largest u", "largest v")
           for w in (k, "deviation")]
        + ["difference of the walls", "CPU s"], rows)


def growth(output):
    """The rate at which velocities grow in the last third of a run, 1/s."""
    rows = read_rows(output / "statistics.csv")
    first, last = rows[2 * len(rows) // 3], rows[-1]
    energies = [float(r["fluid: kinetic energy [J]"]) for r in (first, last)]
    return (.5 * math.log(energies[1] / energies[0])
            / (float(last["time [s]"]) - float(first["time [s]"])))


def onset(runner, report, reduced):
    """Whether a layer that is warm below turns over."""
    runs = {ra: runner.start(
        "rayleigh_benard", f"rayleigh_benard_{ra:g}",
        {"Couplings/buoyancy/Expansion": repr(ra),
         "Time/End time": "1.5" if reduced else "3",
         "Postprocess/Models": ""})
        for ra in ((1700., 1716.) if reduced else (1650., 1700., 1716., 1770.))}
    rows = [[ra, growth(output)] for ra, output in finished(report, runs)]
    for ra, rate in rows:
        report.limit(f"convection of a layer, Ra {ra:g}: the rate at which it "
                     + ("grows" if ra < CRITICAL else "dies away"),
                     rate if ra < CRITICAL else -rate, 0.)
    report.table("rayleigh_benard", "The onset of convection in a layer that is "
                 "warm below, at Rayleigh number 1707.76",
                 ["Ra", "rate of growth [1/s]"], rows)


def verify(runner, report, reduced):
    """A cavity with walls of two temperatures, and a layer on a warm plate."""
    cavity(runner, report, reduced)
    onset(runner, report, reduced)
