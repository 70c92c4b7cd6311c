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


def mean_period(times):
    """The period from the times of zero crossings."""
    return 2 * (times[-1] - times[0]) / (len(times) - 1)


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
        measured = mean_period(zero)
        peak = max(abs(v) for s, v in zip(t, z)
                   if s > (n_periods - .5) * T) / max(z[:3])
        courant = max(column(read_rows(output / "statistics.csv"),
                             "Courant number"))
        rows.append([steps, courant, measured, measured / T - 1., peak])
        curves.append((f"{steps} steps a period", t, z, "-"))
        report.limit(f"sloshing, {steps} steps a period: the deviation of "
                     "the period", abs(measured / T - 1.), .01)
    report.table("sloshing_inviscid", f"Inviscid sloshing, period {T:.4f} s",
                 ["steps a period", "Courant number", "period [s]",
                  "deviation", f"amplitude after {n_periods} periods"], rows)
    report.plot("sloshing_inviscid", curves, "time [s]",
                "elevation at the wall / amplitude")


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
    output = runner.run("sloshing_viscous", "sloshing_viscous", {})
    t, height = gauges(output)
    z = [(h - 1.) / .05 for h in height]
    reference = [r for r in read_rows(
        REFERENCE / "sloshing_viscous_analytic.csv") if float(r["t"]) <= t[-1]]
    t_exact, z_exact = column(reference, "t"), column(reference, "a_Re200")

    zero, zero_exact = crossings(t, z), crossings(t_exact, z_exact)
    rows = [[i + 1, a, b, a / b - 1.]
            for i, (a, b) in enumerate(zip(zero, zero_exact))]
    report.table("sloshing_viscous_crossings",
                 "Viscous sloshing, Re 200: when the surface passes zero",
                 ["crossing", "Thalweg [s]", "Prosperetti [s]", "deviation"],
                 rows)
    report.limit("viscous sloshing: the deviation of the number of crossings",
                 abs(len(zero) - len(zero_exact)), 0)
    report.limit("viscous sloshing: the deviation of the period", abs(
        mean_period(zero) / mean_period(zero_exact) - 1.), .01)

    peaks = largest_of_each_half_wave(crests(t, z))
    exact = largest_of_each_half_wave(crests(t_exact, z_exact))
    report.table("sloshing_viscous",
                 "Viscous sloshing, Re 200: crests and troughs",
                 ["time [s]", "Thalweg", "Prosperetti", "ratio"],
                 [[b[0], a[1], b[1], a[1] / b[1]]
                  for a, b in zip(peaks, exact)])
    report.plot("sloshing_viscous", [
        ("Thalweg", t, z, "-"), ("Prosperetti", t_exact, z_exact, "ko")],
        "time [s]", "elevation / amplitude")


def verify(runner, report, reduced):
    """The inviscid wave, in full runs the viscous one too."""
    inviscid(runner, report, reduced)
    if not reduced:
        viscous(runner, report)
