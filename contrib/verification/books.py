# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volumes: what is inside is what was there, came in and went out."""

from thalweg import column, finished, read_rows

OPEN_TOP = {"Boundary conditions/Open": "top: 0"}
DRAIN = dict(OPEN_TOP, **{
    "Boundary conditions/Flow rate": "bottom: -0.02",
    "Boundary conditions/Inflow fluids": "top: air"})
HYDROSTATIC = "right: if(y<0.2, 9810*(0.2-y)+1.2*9.81*0.2, 1.2*9.81*(0.4-y))"

# name: settings, end in s, water inside at the time t (None: not known)

CASES = {
    "fill an empty tank": (
        {}, 4., lambda t: .02 * t),
    "drain a full tank": (
        dict(DRAIN, **{"Initial conditions/Level set": "y-1"}), 4.,
        lambda t: .16 - .02 * t),
    "pump dry": (
        dict(DRAIN, **{"Initial conditions/Level set": "y-0.1"}), 3.,
        lambda t: max(.04 - .02 * t, 0.)),
    "jet": (
        dict(OPEN_TOP, **{
            "Boundary conditions/Flow rate": "",
            "Boundary conditions/Velocity":
            "left: if(abs(y-0.26)<0.02, 0.5, 0); 0",
            "Boundary conditions/Inflow fluids": "left: water, top: air",
            "Initial conditions/Level set": "y-0.1"}), 1., None),
    "spill": (
        dict(OPEN_TOP, **{
            "Boundary conditions/Flow rate": "",
            "Boundary conditions/Inflow fluids": "top: air",
            "Initial conditions/Level set": "y-0.36-0.3*(x-0.2)"}), 1., None),
    "channel": (
        {"Boundary conditions/Flow rate": "left: 0.02",
         "Boundary conditions/Open": HYDROSTATIC + " | top: 0",
         "Boundary conditions/Inflow fluids":
         "left: y-0.2, right: y-0.2, top: air",
         "Initial conditions/Level set": "y-0.2"}, 1., None),
    "U-tube": (
        {"Geometry/Model": "box with obstacles",
         "Geometry/box with obstacles/Upper corner": "0.4, 0.4",
         "Geometry/box with obstacles/Obstacles": "0.16, 0.12 : 0.24, 0.4",
         "Boundary conditions/Flow rate": "",
         "Boundary conditions/Open": "top: 0",
         "Boundary conditions/Inflow fluids": "top: air",
         "Initial conditions/Level set": "if(x<0.2, y-0.3, y-0.22)"},
        1., None),
}
COURANT = .05, .5, 2., 5.


def settings(name, n, courant):
    """Those of a case on n x n cells."""
    changes, end, _ = CASES[name]
    return dict(changes, **{
        "Geometry/box/Repetitions": f"{n}, {n}",
        "Geometry/box with obstacles/Cell size": .4 / n,
        "Time/Courant number": courant,
        "Time/Maximum step": .02 * courant,
        "Time/End time": end, "Postprocess/Models": ""})


def errors(output, exact):
    """The largest errors of the books, and of the volume inside, in parts of
    the tank."""
    rows = read_rows(output / "statistics.csv")
    volume = 0.4 ** 2
    books = 0.
    for f in (1, 2):
        inside, came_in, out, lost = (column(rows, name) for name in (
            f"carried volume {f} [m^d]", f"volume {f} in [m^d]",
            f"volume {f} out [m^d]", f"volume {f} lost [m^d]"))
        changes = [a - b + c + d
                   for a, b, c, d in zip(inside, came_in, out, lost)]
        books = max(books, max(changes) - min(changes))
    deviation = ""
    if exact:
        deviation = max(abs(v - exact(t)) for t, v in zip(
            column(rows, "time [s]"),
            column(rows, "carried volume 1 [m^d]"))) / volume
    last = rows[-1]
    return (len(rows), max(column(rows, "Courant number")), books / volume,
            deviation, float(last["carried volume 1 [m^d]"]),
            float(last["debt of volume 1 [m^d]"]) / volume,
            float(last["volume 2 owed [m^d]"]) / volume)


def verify(runner, report, reduced):
    """Filling, draining, jets, spills, channels at four step sizes."""
    names = list(CASES)[:3] if reduced else CASES
    runs = {(name, n, courant): runner.start(
        "fill_tank", f"{name}_{n}_{courant}".replace(" ", "_"),
        settings(name, n, courant))
        for name in names for n in ((20,) if reduced else (10, 20))
        for courant in ((2.,) if reduced else COURANT)}
    rows = []
    for (name, n, courant), output in finished(report, runs):
        found = errors(output, CASES[name][2])
        rows.append([name, n, *found])
        where = f"{name}, {n} cells, Courant number {courant}: "
        report.limit(where + "the books' error", found[2], 1e-10)
        if CASES[name][2] and (n >= 20 or reduced):
            report.limit(where + "the volume's error", found[3], 1e-3)
    report.table("books", "Books of volumes", [
        "case", "cells", "steps", "Courant number",
        "error of the books / tank", "largest error of the water inside / tank",
        "water inside at the end [m^2]", "not shown by the mesh / tank",
        "air owed / tank"], rows)
