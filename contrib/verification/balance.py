# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rest stays rest, and uniform flow stays uniform, whatever the densities."""

import math

import irregular_mesh
from thalweg import column, read_rows

HALF = {"Refinement/Local levels": "if(x < 0.4, 1, 0)"}
WAVE = "if(abs(x - 5*t) < 0.2, 1, 0)"
NO_SLIP = {"Boundary conditions/Otherwise": "no slip"}

# name: dimension and settings; a callable makes them in a directory
MESHES = {
    "uniform": (2, {"Refinement/Global levels": 2}),
    "hanging nodes": (2, dict(HALF, **{"Refinement/Global levels": 2})),
    "adapting each step": (2, {
        "Geometry/box/Repetitions": "10, 10",
        "Refinement/Adaptive/Criteria": "region",
        "Refinement/Adaptive/Maximum level": 1,
        "Refinement/Adaptive/region/At least": WAVE,
        "Refinement/Adaptive/region/At most": WAVE}),
    "moved nodes": (2, lambda directory: from_file(directory, 2, 16, .3, False)),
    "triangles": (2, lambda directory: from_file(directory, 2, 8, .2, True)),
    "disc": (2, {"Geometry/Model": "generator",
                 "Geometry/generator/Function": "hyper_ball",
                 "Geometry/generator/Arguments": "0.5, 0.5 : 0.5 : true",
                 "Refinement/Global levels": 3}),
    "obstacle": (2, {"Geometry/Model": "box with obstacles",
                     "Geometry/box with obstacles/Upper corner": "1, 1",
                     "Geometry/box with obstacles/Cell size": 0.0625,
                     "Geometry/box with obstacles/Obstacles":
                     "0.25, 0.375 : 0.5, 0.625"}),
    "uniform, 3D": (3, {"Refinement/Local levels": 0,
                        "Refinement/Global levels": 1}),
    "hanging nodes, 3D": (3, {"Refinement/Global levels": 1}),
    "moved nodes, 3D":
    (3, lambda directory: from_file(directory, 3, 5, .25, False)),
    "tetrahedra": (3, lambda directory: from_file(directory, 3, 2, .1, True)),
}
ANGLES = (0, 1, 5, 17, 20, 40, 45)
# name: normal
DIRECTIONS = {"flat": (0., 0., 1.),
              "17 degrees": (-math.sin(math.radians(17)), 0.,
                             math.cos(math.radians(17))),
              "general": (.36, .48, .8)}
REDUCED = (("moved nodes", 17), ("triangles", 40))
# name: case, settings and time steps; the velocity is 1 m/s
TRANSLATION = {
    "drop": ("drop_in_uniform_flow", {}, (1 / 16, 1 / 3200, 1 / 3.2)),
    "drop, locally refined": ("drop_in_uniform_flow", HALF, (1 / 16, 1 / 6400, 1 / 6.4)),
    "drop, 3D": ("drop_in_uniform_flow_3d", {}, (1 / 8, 1 / 1600, 1 / 1.6)),
}


def deviation(output, wanted):
    """The largest deviation of |V| from a value in all steps of a run."""
    statistics = read_rows(output / "statistics.csv")
    return max(abs(v - wanted) for fluid in (1, 2)
               for v in column(statistics, f"max velocity {fluid} [m/s]"))


def from_file(directory, dim, n, amplitude, simplices):
    """The settings of a mesh with moved nodes."""
    directory.mkdir(parents=True, exist_ok=True)
    path = directory / f"irregular_{dim}d_{'simplices' if simplices else 'cells'}.msh"
    irregular_mesh.write(path, dim, n, amplitude, simplices)
    return {"Geometry/Model": "file", "Geometry/file/File name": path,
            "Geometry/file/Divide cells": "true" if simplices else "false",
            "Refinement/Global levels": 0, "Refinement/Local levels": 0}


def rest_case(runner, mesh, normal, steps):
    """The settings of water at rest below a plane with this normal."""
    settings = MESHES[mesh][1]
    if callable(settings):
        settings = settings(runner.directory)
    plane = "".join(f"+ ({n!r})*({x} - {c})" for n, x, c in
                    zip(normal, "xyz", (.513, .526, .539)))
    return dict({"Refinement/Global levels": 0}, **settings) | {
        "Body forces/Gravity": ", ".join(repr(-9.81 * n) for n in normal),
        "Initial conditions/Level set": "0 " + plane,
        "Time/End time": steps / 200, "Time/Time step": 1 / 200,
        "Postprocess/Models": ""}


def rest(runner, report, reduced):
    """Water under air: rows of the table."""
    steps = 50 if reduced else 200
    cases = []
    for mesh, (dim, _) in MESHES.items():
        for angle in ANGLES if dim == 2 else DIRECTIONS:
            if not reduced or (mesh, angle) in REDUCED:
                cases.append((mesh, dim, angle, {}))
    if not reduced:
        cases += [(mesh, 2, 17, NO_SLIP) for mesh in ("uniform", "moved nodes")]
    rows = []
    for mesh, dim, angle, walls in cases:
        a = math.radians(angle) if dim == 2 else 0.
        normal = ((-math.sin(a), math.cos(a)) if dim == 2
                  else DIRECTIONS[angle])
        name = f"rest, {mesh}, " + (f"{angle} degrees" if dim == 2 else angle)
        name += ", no slip" if walls else ""
        output = runner.run(
            "hydrostatic_two_fluids" if dim == 2
            else "hydrostatic_two_fluids_3d",
            name.replace(", ", "_").replace(" ", "_"),
            dict(rest_case(runner, mesh, normal, steps), **walls))
        largest = deviation(output, 0.)
        rows.append([name, steps, 0, largest, 1e-9])
        report.limit(f"{name}: the velocity", largest, 1e-9)
    return rows


def translation(runner, report, reduced):
    """A drop that moves with its surroundings: rows of the table."""
    rows = []
    for name, (case, settings, time_steps) in list(
            TRANSLATION.items())[:1 if reduced else None]:
        for dt in time_steps:
            steps = 20 if dt != time_steps[0] else round(1 / dt)
            output = runner.run(
                case,
                f"{name}_{dt:.2g}".replace(", ", "_").replace(" ", "_"),
                dict(settings, **{"Time/End time": steps * dt,
                                  "Time/Time step": dt,
                                  "Postprocess/Models": "center of mass"}))
            largest = deviation(output, 1.)
            courant = column(read_rows(output / "statistics.csv"),
                             "Courant number")[-1]
            rows.append([name, steps, courant, largest, 1e-7])
            report.limit(f"{name}, Courant {courant:.2g}: the velocity's "
                         "deviation", largest, 1e-7)
    return rows


def verify(runner, report, reduced):
    """200 steps of rest, uniform flow at Courant numbers 0.01 to 10."""
    report.table("balance", "Rest and uniform flow", [
        "case", "steps", "Courant number", "largest deviation of |V| [m/s]",
        "limit [m/s]"],
        rest(runner, report, reduced) + translation(runner, report, reduced))
