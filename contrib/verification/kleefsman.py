# SPDX-License-Identifier: LGPL-2.1-or-later
"""A column of water onto a box in 3D against Kleefsman et al. (2005)."""

from math import nan, sqrt

from thalweg import REFERENCE, column, read_rows

CASE = "dam_break_kleefsman"
# The order of the case's gauges, and their columns in the experiment's table.
GAUGES = {"H1": "h_x0.496_m", "H2": "h_x0.992_m", "H3": "h_x1.488_m",
          "H4": "h_x2.638_m"}
# The order of the case's probes that were digitised.
PROBES = {"P1": 0, "P3": 2}
HEIGHT, GRAVITY, DENSITY = .55, 9.81, 1000.
# The water has arrived when it is so deep, in m: one cell of the case's mesh. H1,
# behind the box, first meets single splashes, and the bore that comes back from
# the wall only later.
FRONTS, SPLASHES, BORE = (("H3", .02), ("H2", .02)), ("H1", .02), ("H1", .1)
# Maximum level of the mesh: edges of 4 and 2 cm.
LEVELS = (2, 3)


class Series:
    """A quantity against time."""

    def __init__(self, t, values):
        self.t, self.values = t, values

    def at(self, time):
        """Linear between the samples, constant beyond."""
        if time <= self.t[0]:
            return self.values[0]
        for i in range(1, len(self.t)):
            if time <= self.t[i]:
                part = (time - self.t[i - 1]) / (self.t[i] - self.t[i - 1])
                return (1 - part) * self.values[i - 1] + part * self.values[i]
        return self.values[-1]

    def passes(self, value):
        """When the series first reaches a value."""
        for i in range(1, len(self.t)):
            if self.values[i - 1] < value <= self.values[i]:
                return self.t[i - 1] + (self.t[i] - self.t[i - 1]) * (
                    value - self.values[i - 1]) / (
                        self.values[i] - self.values[i - 1])
        return nan

    def peak(self):
        """(value, time) of the maximum."""
        return max(zip(self.values, self.t))

    def earlier(self, delay):
        """The same, shifted."""
        return Series([t - delay for t in self.t], self.values)


def measured_heights():
    """The experiment's heights, by gauge."""
    rows = read_rows(REFERENCE / "dambreak3d_kleefsman_heights.csv")
    return {gauge: Series(column(rows, "t_s"), column(rows, name))
            for gauge, name in GAUGES.items()}


def measured_pressures():
    """The experiment's pressures in Pa, by probe."""
    rows = read_rows(REFERENCE / "dambreak3d_kleefsman_pressures.csv")
    result = {}
    for probe in PROBES:
        own = [r for r in rows if r["probe"] == probe]
        result[probe] = Series(
            [t * sqrt(HEIGHT / GRAVITY) for t in column(own, "T")],
            [p * DENSITY * GRAVITY * HEIGHT for p in column(own, "P")])
    return result


def heights(output):
    """A run's heights, by gauge."""
    rows = read_rows(output / "water_height_gauges.csv")
    return {gauge: Series(column(rows, "time [s]"),
                          column(rows, f"wet height {i} [m]"))
            for i, gauge in enumerate(GAUGES)}


def pressures(output):
    """A run's pressures, by probe."""
    rows = read_rows(output / "point_probes.csv")
    return {probe: Series(column(rows, "time [s]"),
                          column(rows, f"pressure {i} [Pa]"))
            for probe, i in PROBES.items()}


def rms(a, b, begin, end):
    """Of the difference, every hundredth of a second."""
    n = round((end - begin) / .01)
    return sqrt(sum((a.at(begin + .01 * i) - b.at(begin + .01 * i)) ** 2
                    for i in range(n + 1)) / (n + 1))


def delay(computed, measured):
    """By how much the experiment's clock is ahead of the release, from the
    fall of the reservoir's gauge alone, far from fronts and impacts."""
    return min((rms(computed["H4"].earlier(.001 * ms), measured["H4"],
                    .1, .4), .001 * ms) for ms in range(-20, 81))[1]


def books_deviation(output):
    """The largest one of what particles carry and what has left from what
    there was, relative to it."""
    rows = read_rows(output / "statistics.csv")
    inside = [c + o - i - w for c, o, i, w in zip(
        column(rows, "carried volume 1 [m^d]"),
        column(rows, "volume 1 out [m^d]"), column(rows, "volume 1 in [m^d]"),
        column(rows, "volume 1 owed [m^d]"))]
    return max(abs(v / inside[0] - 1.) for v in inside)


def volume_deviation(output):
    """The largest one of the mesh's from the target, relative to it."""
    rows = read_rows(output / "statistics.csv")
    return max(abs(v / target - 1.) for v, target in zip(
        column(rows, "volume 1 [m^d]"), column(rows, "target volume 1 [m^d]")))


def particles_lost(output):
    """In all steps together; those that flow out do not count."""
    return sum(column(read_rows(output / "statistics.csv"), "particles lost"))


def tabulate_arrivals(report, outputs):
    """When the water reaches the gauges."""
    measured, rows = measured_heights(), []
    for level, output in outputs.items():
        computed = heights(output)
        shift = delay(computed, measured)
        for gauge, depth in (*FRONTS, SPLASHES, BORE):
            exact = measured[gauge].passes(depth)
            arrival = computed[gauge].passes(depth)
            rows.append([level, gauge, depth, exact, arrival,
                         arrival / exact - 1., shift,
                         (arrival - shift) / exact - 1.])
    report.table("kleefsman",
                 "Dam break with a box in 3D: when the water arrives",
                 ["maximum level", "gauge", "depth [m]", "experiment [s]",
                  "computed [s]", "deviation", "delay by H4 [s]",
                  "deviation after delay"],
                 rows)
    return rows


def tabulate_heights(report, outputs):
    """Heights at some times, and the mean deviation."""
    measured, rows = measured_heights(), []
    for gauge in GAUGES:
        times = [.5 * i for i in range(1, 7)]
        rows.append(["experiment", gauge] +
                    [measured[gauge].at(t) for t in times] + [""])
        for level, output in outputs.items():
            own = heights(output)[gauge]
            end = min(own.t[-1], 3.)
            rows.append([level, gauge] +
                        [own.at(t) if t <= end + 1e-6 else "" for t in times] +
                        [rms(own, measured[gauge], 0., end)])
    report.table("kleefsman_heights",
                 "Dam break with a box in 3D: water heights in m",
                 ["maximum level", "gauge"] + [f"{.5 * i} s" for i in
                                               range(1, 7)] + ["rms"], rows)


def tabulate_pressures(report, outputs):
    """Peaks, and the mean after the impact."""
    measured, rows = measured_pressures(), []

    def row(name, probe, series, end):
        value, time = series.peak()
        mean = sum(series.at(.6 + .01 * i) for i in range(41)) / 41
        if end < 1.:
            return [name, probe, "", "", ""]
        return [name, probe, value, time, mean]

    for probe in PROBES:
        rows.append(row("experiment", probe, measured[probe], 3.))
        for level, output in outputs.items():
            own = pressures(output)[probe]
            rows.append(row(level, probe, own, own.t[-1]))
    report.table("kleefsman_pressures",
                 "Dam break with a box in 3D: pressures on the box",
                 ["maximum level", "probe", "peak [Pa]", "at [s]",
                  "mean from 0.6 s to 1 s [Pa]"], rows)


def tabulate_runs(report, outputs):
    """What the runs were, and whether water or particles got lost."""
    rows = []
    for level, output in outputs.items():
        steps = read_rows(output / "statistics.csv")
        before = float(steps[-1]["volume 1 before shift [m^d]"])
        target = float(steps[-1]["target volume 1 [m^d]"])
        rows.append([level, column(steps, "time [s]")[-1], len(steps),
                     int(max(column(steps, "cells"))),
                     int(max(column(steps, "particles"))),
                     volume_deviation(output), before / target - 1.,
                     int(particles_lost(output))])
    report.table("kleefsman_runs", "Dam break with a box in 3D: the runs",
                 ["maximum level", "end [s]", "steps", "most cells",
                  "most particles", "volume's deviation",
                  "the same before the last shift", "particles lost"], rows)


def plot(report, outputs):
    """Heights and pressures beside the experiment, as dots; the finest mesh
    as a line, coarser ones dashed."""
    for name, measured, evaluate_run, label, every in (
            ("kleefsman", measured_heights(), heights, "water height [m]", 4),
            ("kleefsman_pressures", measured_pressures(), pressures,
             "pressure [Pa]", 1)):
        runs = [evaluate_run(output) for output in outputs.values()]
        curves = []
        for i, key in enumerate(measured):
            end = max(1., *(run[key].t[-1] for run in runs))
            points = [(t, v) for t, v in zip(measured[key].t,
                                             measured[key].values)
                      if t <= end][::every]
            curves.append((f"{key}, experiment", *zip(*points), f"C{i}."))
            for run in runs:
                finest = run is runs[-1]
                curves.append((key if finest else "_nolegend_", run[key].t,
                               run[key].values, f"C{i}" + "-" if finest
                               else f"C{i}--"))
        report.plot(name, curves, "time [s]", label)


def check(report, outputs, arrivals, in_time):
    """What must hold; in_time: those of the arrivals that have a limit."""
    for level, output in outputs.items():
        report.limit(f"kleefsman, level {level}: the deviation of the volume",
                     books_deviation(output), 1e-9)
        report.limit(f"kleefsman, level {level}: what the mesh does not show "
                     "of the volume", volume_deviation(output), .01)
        report.limit(f"kleefsman, level {level}: the number of particles lost",
                     particles_lost(output), 0)
    for level, gauge, depth, *_, deviation in arrivals:
        if (gauge, depth) in in_time:
            report.limit(f"kleefsman, level {level}: the deviation of the "
                         f"arrival at {gauge} ({depth} m deep) after the "
                         "delay", abs(deviation), .1 if level == 2 else .05)


def evaluate(report, outputs, in_time=(*FRONTS, BORE)):
    """Tables, plots and limits; outputs: {maximum level: directory}."""
    arrivals = tabulate_arrivals(report, outputs)
    tabulate_heights(report, outputs)
    tabulate_pressures(report, outputs)
    tabulate_runs(report, outputs)
    plot(report, outputs)
    check(report, outputs, arrivals, in_time)


def short(runner, report):
    """Cells of 4 cm until the water has met the box."""
    output = runner.run(CASE, "kleefsman_short", {
        "Refinement/Adaptive/Maximum level": "2", "Time/End time": "0.45",
        "Time/First step": "0.01", "Time/Maximum step": "0.02",
        "Particles/Particles per direction": "2",
        "Postprocess/fields/Interval": "1"})
    evaluate(report, {2: output}, in_time=FRONTS)
    pressure = pressures(output)["P1"]
    report.within("kleefsman: when the water presses on the box, in s",
                  pressure.passes(1e3), .39, .45)
    report.at_least("kleefsman: the greatest pressure at P1 in Pa",
                    pressure.peak()[0], 5e3)


def verify(runner, report, reduced):
    """Two meshes to the end; reduced: the coarse one to the impact."""
    if reduced:
        short(runner, report)
        return
    evaluate(report, {level: runner.run(
        CASE, f"kleefsman_{level}",
        {"Refinement/Adaptive/Maximum level": str(level)}, limit=14400)
        for level in LEVELS})
