"""Standing waves: period and decay against linear theory."""

from math import pi, sqrt, tanh

from thalweg import REFERENCE, column, read_rows

LENGTH, DEPTH, GRAVITY, AMPLITUDE = .584, .25, 9.81, .01


def period():
    """Linear theory's period in s."""
    k = pi / LENGTH
    return 2 * pi / sqrt(GRAVITY * k * tanh(k * DEPTH))


def crossings(t, z):
    """When z passes zero, interpolated linearly."""
    return [t[i] + (t[i + 1] - t[i]) * z[i] / (z[i] - z[i + 1])
            for i in range(len(z) - 1) if z[i] * z[i + 1] < 0]


def gauges(output):
    """Times, and the difference of the first gauge from its mean level."""
    rows = read_rows(output / "water_height_gauges.csv")
    return column(rows, "time [s]"), column(rows, "wet height 0 [m]")


def inviscid(runner, report, reduced):
    """The period from the last crossing, the decay from the last peak."""
    rows, curves = [], []
    T = period()
    for steps in (40,) if reduced else (400, 200, 80, 40, 20):
        n_periods = 2 if reduced else 5
        output = runner.run("sloshing_linear", f"sloshing_{steps}", {
            "Time/Time step": repr(T / steps),
            "Time/End time": repr(n_periods * T)})
        t, height = gauges(output)
        z = [(h - DEPTH) / AMPLITUDE for h in height]
        zero = crossings(t, z)
        measured = 2 * (zero[-1] - zero[0]) / (len(zero) - 1)
        peak = max(abs(v) for s, v in zip(t, z)
                   if s > (n_periods - .5) * T) / max(z[:3])
        courant = max(column(read_rows(output / "statistics.csv"),
                             "Courant number"))
        rows.append([steps, courant, measured, measured / T - 1., peak])
        curves.append((f"{steps} steps a period", t, z, "-"))
        if steps >= 40:
            report.limit(f"sloshing, {steps} steps a period: the deviation of "
                         "the period", abs(measured / T - 1.), .01)
    report.table("sloshing_inviscid", f"Inviscid sloshing, period {T:.4f} s",
                 ["steps a period", "Courant number", "period [s]",
                  "deviation", f"amplitude after {n_periods} periods"], rows)
    report.plot("sloshing_inviscid", curves, "time [s]",
                "elevation at the wall / amplitude")


def viscous(runner, report):
    """The decaying wave at Re = 200 against Prosperetti (1981)."""
    output = runner.run("sloshing_viscous", "sloshing_viscous", {})
    t, height = gauges(output)
    z = [(h - 1.) / .05 for h in height]
    reference = [r for r in read_rows(
        REFERENCE / "sloshing_viscous_analytic.csv") if float(r["t"]) <= t[-1]]
    rows = []
    for r in reference:
        i = min(range(len(t)), key=lambda j: abs(t[j] - float(r["t"])))
        rows.append([float(r["t"]), z[i], float(r["a_Re200"])])
    report.table("sloshing_viscous", "Viscous sloshing, Re 200",
                 ["time [s]", "Thalweg", "Prosperetti"], rows)
    report.plot("sloshing_viscous", [
        ("Thalweg", t, z, "-"),
        ("Prosperetti", [r[0] for r in rows], [r[2] for r in rows], "ko")],
        "time [s]", "elevation / amplitude")


def verify(runner, report, reduced):
    """The inviscid wave, in full runs the viscous one too."""
    inviscid(runner, report, reduced)
    if not reduced:
        viscous(runner, report)
