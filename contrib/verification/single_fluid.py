# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the parts for single-fluid flows have in common."""

from thalweg import column, order, read_rows

METHOD = "Method/single fluid pfem2/"



def spaces(velocity, pressure, per_direction):
    """Settings of the spaces and of as many particles as they need."""
    return {
        METHOD + "Velocity degree": velocity,
        METHOD + "Pressure degree": pressure,
        METHOD + "Stabilization/Model":
        "oss" if velocity == pressure else "none",
        "Particles/Particles per direction": per_direction,
        "Particles/Minimum per cell": per_direction ** 2 * 2 // 3,
        "Particles/Maximum per cell": per_direction ** 2 * 2}


# name in tables: settings
SPACES = {"Q1-Q1": spaces(1, 1, 3), "Q2-Q2": spaces(2, 2, 4)}
TAYLOR_HOOD = {"Q2-Q1": spaces(2, 1, 4)}
# All steps made alike, without which there is no order in the step; else they are
# made again where the prediction failed.
ONCE = {METHOD + "Maximal corrector iterations": 0}
# Paths as exact as the fields are.
PATHS = {"Particles/Integrator": "rk4",
         "Particles/Substep Courant number": .25}


def theta(value):
    """The setting of how implicit viscosity is."""
    return {METHOD + "Viscous theta": value}


def boxes(n, m=None):
    """A box of n by m cells without refinement."""
    return {"Geometry/box/Repetitions": f"{n}, {m or n}",
            "Refinement/Global levels": 0}


def steps(number, end):
    """So many equal time steps."""
    return {"Time/Time step": repr(end / number), "Time/End time": repr(end),
            "Time/Hit multiples of": 0}


def last_error(output, name="relative L2 error"):
    """A number of the last row of velocity_error.csv."""
    return float(read_rows(output / "velocity_error.csv")[-1][name])


def errors(output, name="relative L2 error"):
    """A column of velocity_error.csv."""
    return column(read_rows(output / "velocity_error.csv"), name)


def with_orders(points):
    """(size, error) of falling size: a row of size, error and order each."""
    rows, previous = [], None
    for size, error in points:
        rows.append([size, error, order(previous[1], error,
                                        previous[0] / size)
                     if previous else ""])
        previous = (size, error)
    return rows
