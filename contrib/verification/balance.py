"""Rest stays rest, and uniform flow stays uniform, whatever the densities."""

from thalweg import column, read_rows

HALF = {"Refinement/Local levels": "if(x < 0.4, 1, 0)"}
PLANE = {"Particles/Distance band": 100, "Projection/Model": "least squares"}
TILTED = dict(PLANE, **{
    "Body forces/Gravity": "3, -9.5",
    "Initial conditions/Level set": "0.95*(y - 0.513) - 0.3*(x - 0.5)"})

# name: case and settings; those of the reduced run come first
REST = {
    "flat": ("hydrostatic_two_fluids", {}),
    "tilted by 17.5 degrees, locally refined":
    ("hydrostatic_two_fluids", dict(TILTED, **HALF)),
    "flat, locally refined": ("hydrostatic_two_fluids", dict(PLANE, **HALF)),
    "tilted by 17.5 degrees": ("hydrostatic_two_fluids", TILTED),
    "flat, 3D": ("hydrostatic_two_fluids_3d", {
        "Refinement/Local levels": 0, "Refinement/Global levels": 2,
        "Particles/Distance band": 1,
        "Projection/Model": "weighted average"}),
    "flat, 3D, locally refined": ("hydrostatic_two_fluids_3d", {}),
}
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


def rest(runner, report, reduced):
    """Water under air: rows of the table."""
    steps = 50 if reduced else 200
    rows = []
    for name, (case, settings) in list(REST.items())[:2 if reduced else None]:
        output = runner.run(
            case, "rest_" + name.replace(" ", "_"),
            dict(settings, **{"Time/End time": steps / 200,
                              "Time/Time step": 1 / 200,
                              "Postprocess/Models": ""}))
        largest = deviation(output, 0.)
        rows.append(["rest, " + name, steps, 0, largest, 1e-9])
        report.limit(f"rest, {name}: the velocity", largest, 1e-9)
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
