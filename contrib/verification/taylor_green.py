# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decaying vortices: orders in space and time, errors of large steps."""

from math import pi

from single_fluid import (METHOD, ONCE, PATHS, SPACES, boxes, errors, last_error,
                          steps, with_orders)
from thalweg import REFERENCE, column, finished, read_rows

COURANT = (.25, .5, 1., 2., 5., 10., 20.)
REYNOLDS = (100, 1000)
# All steps made alike, and as exactly as those whose prediction failed.
TWICE = {METHOD + "Corrector iterations": 1}
# Courant numbers of finer and finer meshes, the large one with equal steps.
MESH_COURANT = ((.5, {}), (4., TWICE))


def settings(reynolds):
    """The case with another viscosity."""
    nu = 1 / reynolds
    x, y = "2*pi*x", "2*pi*y"
    decay = f"*exp(-8*pi^2*{nu!r}*t)"
    return {"Fluids/First fluid/Viscosity": repr(nu),
            "Postprocess/Models": "velocity error",
            "Postprocess/velocity error/Velocity":
            f"sin({x})*cos({y}){decay}; -cos({x})*sin({y}){decay}"}


def start(runner, reynolds, space, n, n_steps, more={}):
    """One run on n by n cells until t = 1 s, one turnover."""
    names = [f"{key.rsplit('/')[-1]} {value}" for key, value in more.items()]
    return runner.start(
        "taylor_green", "_".join(["taylor_green", str(reynolds), space, str(n),
                                  str(n_steps), *names]).replace(" ", "_"),
        {**settings(reynolds), **SPACES[space], **PATHS, **boxes(n),
         **steps(n_steps, 1.), **more}, 1800)


def energy(output):
    """How much the kinetic energy deviates from the exact one."""
    return last_error(output, "relative kinetic energy") - 1.


def against_mesh(runner, report, reduced):
    """Errors on finer and finer meshes, with time steps that are a fixed part
    of the cells' size: so small that they do not matter, and large ones."""
    meshes = (8, 16) if reduced else (16, 32, 64, 128)
    spaces = ("Q2-Q2",) if reduced else SPACES
    runs = {(re, space, c, n): start(runner, re, space, n, round(n / c), more)
            for re in (REYNOLDS[:1] if reduced else REYNOLDS)
            for space in spaces
            for c, more in MESH_COURANT[:1 if reduced else 2] for n in meshes}
    found = {key: last_error(output)
             for key, output in finished(report, runs)}
    rows = []
    curves = sorted({key[:3] for key in found})
    for re, space, c in curves:
        table = with_orders([(1 / n, found[re, space, c, n]) for n in meshes
                             if (re, space, c, n) in found])
        rows += [[re, space, c, round(1 / h), e, o] for h, e, o in table]
        report.at_least(f"Taylor-Green, Re {re}, {space}, Courant {c:g}: the "
                        "order in h", table[-1][2] or 0., 1.9)
    report.table("taylor_green_mesh",
                 "Taylor-Green vortices: error at t = 1 s",
                 ["Re", "spaces", "Courant number", "cells a side",
                  "relative error", "order"], rows)
    report.plot("taylor_green_mesh", [
        (f"Re {re}, {space}, Courant {c:g}",
         [r[3] for r in rows if r[:3] == [re, space, c]],
         [r[4] for r in rows if r[:3] == [re, space, c]], "o-")
        for re, space, c in curves],
        "cells a side", "relative error", "log")


def against_step(runner, report, reduced):
    """Errors of smaller and smaller steps on one fine mesh."""
    n = 32 if reduced else 96
    numbers = (4, 8) if reduced else (4, 8, 16, 32)
    runs = {(re, k): start(runner, re, "Q2-Q2", n, k, ONCE)
            for re in ((100,) if reduced else REYNOLDS) for k in numbers}
    found = {key: last_error(output)
             for key, output in finished(report, runs)}
    rows = []
    for re in sorted({key[0] for key in found}):
        table = with_orders([(1 / k, found[re, k]) for k in numbers
                             if (re, k) in found])
        rows += [[re, round(1 / dt), n * dt, e, o] for dt, e, o in table]
        # At Re 1000 the errors in time are below those in space at once.
        if re == 100 and len(table) > 1:
            report.at_least(f"Taylor-Green, Re {re}: the order in dt",
                            table[1][2], 1.9)
    report.table("taylor_green_step",
                 f"Taylor-Green vortices: error at t = 1 s, {n} by {n} cells, "
                 "Q2-Q2",
                 ["Re", "steps", "Courant number", "relative error", "order"],
                 rows)


def against_courant(runner, report, name, more={}):
    """Equal meshes, steps of very different size; the energy too."""
    n = 64
    runs = {(re, space, c): start(runner, re, space, n, max(1, round(n / c)), more)
            for re in REYNOLDS for space in SPACES for c in COURANT}
    found = {key: (last_error(output), energy(output),
                   output.cpu_time)
             for key, output in finished(report, runs)}
    rows = [[re, space, n / max(1, round(n / c)), max(1, round(n / c)),
             *found[re, space, c]]
            for re, space, c in runs if (re, space, c) in found]
    for re in REYNOLDS:
        for space in SPACES:
            one, ten = (found.get((re, space, c)) for c in (1., 10.))
            if one and ten and not more:
                report.limit(f"Taylor-Green, Re {re}, {space}: the error at "
                             "Courant 10 over that at Courant 1",
                             ten[0] / one[0], 1.5)
            for c in COURANT:
                if re == 1000 and c <= 10. and (re, space, c) in found:
                    report.limit(f"Taylor-Green, Re {re}, {space}, Courant "
                                 f"{c:g}: the deviation of the kinetic energy",
                                 abs(found[re, space, c][1]), .01)
    report.table(name,
                 f"Taylor-Green vortices: {n} by {n} cells, t = 1 s",
                 ["Re", "spaces", "Courant number", "steps", "relative error",
                  "relative deviation of the kinetic energy", "CPU s"], rows)
    report.plot(name, [
        (f"Re {re}, {space}", [r[2] for r in rows if r[:2] == [re, space]],
         [r[4] for r in rows if r[:2] == [re, space]], "o-")
        for re in REYNOLDS for space in SPACES],
        "Courant number", "relative error", "log")


def beltrami(runner, report, reduced):
    """Ethier and Steinman's flow: an exact solution in 3D."""
    meshes = (6, 12) if reduced else (4, 8, 16)
    runs = {(space, n): runner.start(
        "beltrami_3d", f"beltrami_{space}_{n}",
        {**SPACES[space], **steps(n, .2), **TWICE,
         "Refinement/Global levels": 0,
         "Geometry/generator/Arguments": f"{n} : -1 : 1 : false"})
        for space in (("Q1-Q1",) if reduced else SPACES) for n in meshes}
    found = {key: last_error(output)
             for key, output in finished(report, runs)}
    rows = []
    for space in SPACES:
        points = [(1 / n, found[space, n]) for n in meshes
                  if (space, n) in found]
        table = with_orders(points)
        rows += [[space, round(1 / h), e, o] for h, e, o in table]
        if table:
            report.at_least(f"Ethier-Steinman, {space}: the order",
                            table[-1][2] or 0., 1.9)
    report.table("beltrami",
                 "Ethier and Steinman's flow in a cube: error at t = 0.2 s",
                 ["spaces", "cells a side", "relative error", "order"], rows)


def breakdown(runner, report):
    """The vortices of 1937 in 3D at Re = 100 against a spectral method."""
    reference = read_rows(REFERENCE / "taylor_green_3d.csv")
    t_exact = column(reference, "time [s]")
    e_exact = column(reference, "relative kinetic energy")
    curves, rows = [("spectral", t_exact, e_exact, "k-")], []
    runs = {(n, k): runner.start(
        "taylor_green_3d", f"taylor_green_3d_{n}_{k}",
        {**steps(k, 10.), "Geometry/box/Repetitions": f"{n}, {n}, {n}",
         "Refinement/Global levels": 0,
         "Postprocess/Models": "velocity error"}, 3600)
        for n, k in ((16, 50), (32, 100), (32, 25))}
    for (n, k), output in finished(report, runs):
        t = column(read_rows(output / "velocity_error.csv"), "time [s]")
        e = errors(output, "relative kinetic energy")
        # The first row is the interpolant's energy, 1.9 % below on 32^3.
        largest = max(abs(a - interpolate(t_exact, e_exact, s))
                      for s, a in zip(t[1:], e[1:]))
        rows.append([n, k, 10. / k * n / (2 * pi), largest, output.cpu_time])
        curves.append((f"{n}^3 cells, {k} steps", t, e, "o"))
    report.table("taylor_green_3d",
                 "Taylor-Green vortices in 3D, Re 100, until t = 10 s",
                 ["cells a side", "steps", "Courant number",
                  "largest deviation of E/E(0)", "CPU s"], rows)
    report.plot("taylor_green_3d", curves, "time [s]", "E/E(0)")


def interpolate(x, y, at):
    """Linear interpolation in a table of rising x."""
    for i in range(1, len(x)):
        if at <= x[i]:
            part = (at - x[i - 1]) / (x[i] - x[i - 1])
            return y[i - 1] + part * (y[i] - y[i - 1])
    return y[-1]


def verify(runner, report, reduced):
    """Two and three dimensions."""
    against_mesh(runner, report, reduced)
    against_step(runner, report, reduced)
    if not reduced:
        against_courant(runner, report, "taylor_green_courant")
        against_courant(runner, report, "taylor_green_courant_once", ONCE)
        breakdown(runner, report)
    beltrami(runner, report, reduced)
