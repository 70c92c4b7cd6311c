# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flows with exact solutions: Poiseuille, Couette, Womersley, Kovasznay."""

from math import pi

from single_fluid import (ONCE, PATHS, SPACES, boxes, errors, last_error, steps,
                          theta, with_orders)
from thalweg import finished

# case: end time, cells along x for one along y, steps for one row of cells
FLOWS = {"poiseuille": (.5, 1 / 4, 2), "couette": (.1, 1 / 4, 2),
         "womersley": (1., 1 / 4, 4), "kovasznay": (1., 3 / 2, 4)}
MESHES = (8, 16, 32)
# With one cell along a flow that all columns share, particles stay where they
# are in their row of cells: what is left is the error of the equations. On more
# cells their even distribution is sheared, which leaves noise of 3e-6.
ALONE, ALONE_MESHES = "couette, one cell long", (8, 16, 32, 64, 128)
# The largest velocity of Womersley's flow is that of the unit's amplitude.
EXACT_START = {"poiseuille": {"Initial conditions/Velocity": "1 - y^2; 0"}}


def label(name):
    """A name for files."""
    return name.replace(", ", "_").replace(" ", "_")


def cells(name, n):
    """The mesh of a flow with N rows."""
    return boxes(1 if name == ALONE else round(FLOWS[name][1] * n), n)


def worst(output, case):
    """The error: at the end, for oscillating flow over the last period."""
    if case != "womersley":
        return last_error(output)
    found = errors(output, "L2 error [m/s]")
    return max(found[len(found) // 2:]) * 2 * pi


def against_mesh(runner, report, reduced):
    """Orders where the time step falls with the cells' size."""
    meshes = {case: MESHES[:2] if reduced else MESHES for case in FLOWS}
    if not reduced:
        meshes[ALONE] = ALONE_MESHES
    spaces = ("Q2-Q2",) if reduced else SPACES
    runs = {}
    for name, numbers in meshes.items():
        case = name.split(",")[0]
        end, _, rate = FLOWS[case]
        for space in spaces:
            for n in numbers:
                runs[name, space, n] = runner.start(
                    case, f"{label(name)}_{space}_{n}",
                    {**SPACES[space], **ONCE, **PATHS, **cells(name, n),
                     **steps(rate * n, end), **EXACT_START.get(case, {}),
                     "Postprocess/Models": "velocity error"})
    found = {key: worst(output, key[0])
             for key, output in finished(report, runs)}
    rows = []
    for name, numbers in meshes.items():
        for space in spaces:
            table = with_orders([(1 / n, found[name, space, n])
                                 for n in numbers
                                 if (name, space, n) in found])
            rows += [[name, space, round(1 / h), e, o] for h, e, o in table]
            # What is exact to round-off has no order.
            if table and table[-1][1] > 1e-6:
                report.at_least(f"{name}, {space}: the order",
                                table[-1][2] or 0., 1.9)
    report.table("exact_flows", "Flows with exact solutions",
                 ["flow", "spaces", "rows of cells", "error", "order"], rows)


def against_step(runner, report):
    """The order in time alone, on a mesh that is fine enough."""
    numbers, cases = (10, 20, 40, 80), ("couette", ALONE, "womersley")
    runs = {}
    for name in cases:
        case = name.split(",")[0]
        end = FLOWS[case][0]
        for k in numbers:
            runs[name, k] = runner.start(
                case, f"{label(name)}_step_{k}",
                {**SPACES["Q2-Q2"], **ONCE, **cells(name, 32),
                 **steps(k, end), "Postprocess/Models": "velocity error"})
    found = {key: worst(output, key[0])
             for key, output in finished(report, runs)}
    rows = []
    for name in cases:
        table = with_orders([(1 / k, found[name, k]) for k in numbers
                             if (name, k) in found])
        rows += [[name, round(1 / dt), e, o] for dt, e, o in table]
        if len(table) > 1:
            report.at_least(f"{name}: the order in dt from {numbers[0]} to "
                            f"{numbers[1]} steps", table[1][2], 1.9)
    report.table("exact_flows_step", "Flows with exact solutions: time steps",
                 ["flow", "steps", "error", "order"], rows)


def fourier(runner, report, reduced):
    """Starts from rest with Fourier numbers up to 10,000."""
    n, n_steps = 32, 200
    runs = {}
    for value in ((1.,) if reduced else (.5, 1.)):
        for number in ((100.,) if reduced else (1., 10., 100., 1e3, 1e4)):
            dt = number * (2 / n) ** 2
            runs[value, number] = runner.start(
                "poiseuille", f"fourier_{value:g}_{number:g}",
                {**boxes(8, n), **theta(value),
                 **steps(n_steps, n_steps * dt),
                 "Postprocess/Models": "velocity error"})
    rows = []
    for (value, number), output in finished(report, runs):
        found = errors(output, "maximal error [m/s]")
        rows.append([value, number, max(found), found[-1]])
        # Rest is wrong by 1; oscillations of theta = 1/2 stay below that.
        report.limit(f"Poiseuille from rest, theta {value:g}, Fourier number "
                     f"{number:g}: the largest error", max(found), 1.001)
    report.table("fourier", f"Poiseuille flow from rest, {n_steps} steps",
                 ["theta", "Fourier number", "largest error [m/s]",
                  "last error [m/s]"], rows)


def verify(runner, report, reduced):
    """Orders in space and in time, and stability."""
    against_mesh(runner, report, reduced)
    if not reduced:
        against_step(runner, report)
    fourier(runner, report, reduced)
