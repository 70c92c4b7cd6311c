# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lid-driven cavity against Ghia, Ghia and Shin (1982) and others."""

from single_fluid import SPACES
from thalweg import REFERENCE, column, finished, read_rows

# Reynolds number: time until the flow is steady, in s
FULL = {100: 20., 400: 40., 1000: 60.}


def line(n):
    """Where the nodes of a centre line are."""
    return [i / n for i in range(1, n)]


def settings(reynolds, n, courant, end, u, v):
    """The case with probes at U on the vertical, V on the horizontal line."""
    points = ([f"0.5, {y!r}" for y in u + line(n)]
              + [f"{x!r}, 0.5" for x in v + line(n)])
    return {"Fluids/First fluid/Viscosity": repr(1 / reynolds),
            "Geometry/cavity/Repetitions": f"{n}, {n}",
            "Refinement/Global levels": 0, "Time/End time": repr(end),
            "Time/Courant number": courant,
            "Postprocess/Models": "point probes",
            "Postprocess/point probes/Interval": repr(end / 20),
            "Postprocess/point probes/Points": "; ".join(points)}


def extremum(values, sign):
    """The largest of SIGN times VALUES, from a parabola through three."""
    z = [sign * v for v in values]
    i = max(range(1, len(z) - 1), key=z.__getitem__)
    left, middle, right = z[i - 1:i + 2]
    bend = 2 * middle - left - right
    return sign * (middle + (right - left) ** 2 / (8 * bend)
                   if bend > 0 else middle)


def profiles(output, n_u, n_v, n):
    """(u at the published places, u on the line, v ..., v ..., change)."""
    rows = read_rows(output / "point_probes.csv")
    names = {axis: [k for k in rows[0] if k.startswith("velocity " + axis)]
             for axis in "xy"}
    last, before = rows[-1], rows[-2]
    u = [float(last[k]) for k in names["x"]][:n_u + n - 1]
    v = [float(last[k]) for k in names["y"]][n_u + n - 1:]
    change = max(abs(float(last[k]) - float(before[k]))
                 for axis in "xy" for k in names[axis])
    return u[:n_u], u[n_u:], v[:n_v], v[n_v:], change


def verify(runner, report, reduced):
    """Profiles and extrema at Re 100, 400 and 1000."""
    ghia_u = [r for r in read_rows(REFERENCE / "cavity_ghia1982_u.csv")
              if 0 < float(r["y"]) < 1]
    ghia_v = [r for r in read_rows(REFERENCE / "cavity_ghia1982_v.csv")
              if 0 < float(r["x"]) < 1]
    y, x = column(ghia_u, "y"), column(ghia_v, "x")
    n = 32 if reduced else 128
    courants = (5.,) if reduced else (5., 10., 20.)
    runs = {(re, c, space): runner.start(
        "cavity", f"cavity_{re}_{c:g}_{space}",
        {**settings(re, n, c, 15. if reduced else end, y, x),
         **SPACES[space]}, 3600)
        for re, end in list(FULL.items())[:1 if reduced else None]
        for c in courants
        for space in ("Q1-Q1",)}
    rows, extrema, curves = [], [], {}
    for (re, c, space), output in finished(report, runs):
        u, u_line, v, v_line, change = profiles(output, len(y), len(x), n)
        largest = max(
            [abs(a - b) for a, b in zip(u, column(ghia_u, f"u_Re{re}"))]
            + [abs(a - b) for a, b in zip(v, column(ghia_v, f"v_Re{re}"))])
        rows.append([re, n, space, c, largest, change, output.cpu_time])
        extrema.append([re, f"{space}, Courant {c:g}",
                        extremum(u_line, -1), extremum(v_line, 1),
                        extremum(v_line, -1)])
        if reduced or c == 10.:
            report.limit(f"cavity, Re {re}, {space}, Courant {c:g}: the "
                         "largest deviation from Ghia", largest,
                         .04 if reduced else .01)
        if c == courants[len(courants) // 2] and space == "Q1-Q1":
            curves[re] = (u, v)
    report.table("cavity", "Lid-driven cavity against Ghia, Ghia and Shin",
                 ["Re", "cells a side", "spaces", "Courant number",
                  "largest deviation [m/s]",
                  "change in the last twentieth [m/s]", "CPU s"], rows)
    published = read_rows(REFERENCE / "cavity_extrema.csv")
    for re in sorted({r[0] for r in extrema}):
        for source in sorted({r["source"] for r in published
                              if r["Re"] == str(re)}):
            extrema.append([re, source.split(" (")[0]] + [
                next((float(r["value"]) for r in published
                      if (r["Re"], r["source"], r["quantity"])
                      == (str(re), source, quantity)), "")
                for quantity in ("u_min", "v_max", "v_min")])
    report.table("cavity_extrema", "Lid-driven cavity: extrema on the centre "
                 "lines", ["Re", "source", "u min [m/s]", "v max [m/s]",
                           "v min [m/s]"],
                 sorted((r for r in extrema if r[2] != ""),
                        key=lambda r: (r[0], r[1])))
    for axis, places, index, rows_ in (("u", y, 0, ghia_u),
                                       ("v", x, 1, ghia_v)):
        report.plot(f"cavity_{axis}", [
            (f"Re {re}", places, found[index], "-")
            for re, found in curves.items()] + [
            (f"Ghia, Re {re}", places, column(rows_, f"{axis}_Re{re}"), "o")
            for re in curves],
            "y [m]" if axis == "u" else "x [m]", f"{axis} [m/s]")
