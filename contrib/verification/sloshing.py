# SPDX-License-Identifier: LGPL-2.1-or-later
"""Standing waves: period and decay against linear theory."""

from math import cos, pi, sin, sqrt, tanh

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


def mean_period(times):
    """The period from the times of zero crossings."""
    return 2 * (times[-1] - times[0]) / (len(times) - 1)


def amplitude(output, depth, shape):
    """Times, and the part of the elevation that has the wave's shape.

    The gauges are spread evenly from wall to wall; shape(s) is the wave at the
    part s of the way between them."""
    rows = read_rows(output / "water_height_gauges.csv")
    n = sum(name.startswith("wet height") for name in rows[0])
    weights = [shape(i / (n - 1)) * (.5 if i in (0, n - 1) else 1.)
               for i in range(n)]
    square = sum(w * shape(i / (n - 1)) for i, w in enumerate(weights))
    return column(rows, "time [s]"), [
        sum(w * (float(row[f"wet height {i} [m]"]) - depth)
            for i, w in enumerate(weights)) / square for row in rows]


def courant_number(output):
    """The largest one of a run."""
    return max(column(read_rows(output / "statistics.csv"),
                      "Courant number"))


def inviscid(runner, report, reduced):
    """The period from the zero crossings, the decay from the last crests."""
    rows, curves = [], []
    T = period()
    for steps in (40,) if reduced else (400, 200, 80, 40, 20):
        n_periods = 2 if reduced else 5
        output = runner.run("sloshing_linear", f"sloshing_{steps}", {
            "Time/Time step": repr(T / steps),
            "Time/End time": repr(n_periods * T)})
        t, a = amplitude(output, DEPTH, lambda s: cos(pi * s))
        z = [v / AMPLITUDE for v in a]
        measured = mean_period(crossings(t, z))
        peak = max(abs(v) for s, v in zip(t, z) if s > (n_periods - .5) * T)
        rows.append([steps, courant_number(output), measured,
                     measured / T - 1., peak])
        curves.append((f"{steps} steps a period", t, z, "-"))
        report.limit(f"sloshing, {steps} steps a period: the deviation of "
                     "the period", abs(measured / T - 1.), .01)
    report.table("sloshing_inviscid", f"Inviscid sloshing, period {T:.4f} s",
                 ["steps a period", "Courant number", "period [s]",
                  "deviation", f"amplitude after {n_periods} periods"], rows)
    report.plot("sloshing_inviscid", curves, "time [s]",
                "amplitude / initial amplitude")


def crests(t, z):
    """The greatest deviations from zero between crossings, from parabolas
    through three points; that of the start is left out."""
    result = []
    for i in range(1, len(z) - 1):
        left, middle, right = (abs(v) for v in z[i - 1:i + 2])
        if middle > left and middle >= right and z[i - 1] * z[i + 1] > 0:
            top = middle + (right - left) ** 2 / (
                8 * (2 * middle - left - right))
            result.append((t[i], top if z[i] > 0 else -top))
    return result


def largest_of_each_half_wave(peaks):
    """One crest for each run of crests on the same side of zero."""
    result = []
    for t, z in peaks:
        if not result or result[-1][1] * z < 0:
            result.append((t, z))
        elif abs(z) > abs(result[-1][1]):
            result[-1] = (t, z)
    return result


def viscous(runner, report):
    """The decaying wave at Re = 200 against Prosperetti (1981)."""
    reference = [r for r in read_rows(
        REFERENCE / "sloshing_viscous_analytic.csv") if float(r["t"]) <= 9.]
    t_exact, z_exact = column(reference, "t"), column(reference, "a_Re200")
    T = mean_period(crossings(t_exact, z_exact))
    exact = largest_of_each_half_wave(crests(t_exact, z_exact))
    rows, curves = [], [("Prosperetti", t_exact, z_exact, "ko")]
    for steps in (200, 100, 40, 20, 10):
        output = runner.run("sloshing_viscous", f"sloshing_viscous_{steps}", {
            "Time/Time step": repr(T / steps), "Time/End time": "9",
            "Time/Hit multiples of": "0"})
        t, a = amplitude(output, 1., lambda s: sin(2 * pi * (s - .25)))
        z = [v / .05 for v in a]
        measured = mean_period(crossings(t, z))
        peaks = largest_of_each_half_wave(crests(t, z))
        rows.append([steps, courant_number(output), measured,
                     measured / T - 1.] + [p[1] for p in peaks[:4]])
        curves.append((f"{steps} steps a period", t, z, "-"))
        report.limit(f"viscous sloshing, {steps} steps a period: the "
                     "deviation of the period", abs(measured / T - 1.), .01)
    rows.append(["Prosperetti", "", T, 0.] + [p[1] for p in exact[:4]])
    report.table("sloshing_viscous", "Viscous sloshing, Re 200",
                 ["steps a period", "Courant number", "period [s]",
                  "deviation", "crest 1", "crest 2", "crest 3", "crest 4"],
                 rows)
    report.plot("sloshing_viscous", curves, "time [s]",
                "amplitude / initial amplitude")


def verify(runner, report, reduced):
    """The inviscid wave, in full runs the viscous one too."""
    inviscid(runner, report, reduced)
    if not reduced:
        viscous(runner, report)
