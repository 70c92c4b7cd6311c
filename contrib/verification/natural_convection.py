# SPDX-License-Identifier: LGPL-2.1-or-later
"""Natural convection in a square cavity against de Vahl Davis (1983)."""

from cavity import extremum, line
from thalweg import REFERENCE, finished, read_rows

# Rayleigh number: cells a side, end in s
FULL = {1e3: (64, .5), 1e4: (64, .5), 1e5: (64, .4), 1e6: (128, .3)}
REDUCED = {1e4: (24, .3)}


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


def verify(runner, report, reduced):
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
