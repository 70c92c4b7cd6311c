"""A smooth pulse that turns with its surroundings keeps its peak."""

from thalweg import column, finished, read_rows

TURNS = 10


def verify(runner, report, reduced):
    """What is left of the peak after ten turns at several Courant numbers."""
    settings = {"Postprocess/Models": "point probes"}
    runs = {c: runner.start("gaussian_pulse", f"gaussian_pulse_{c:g}", {
        **settings, "Time/Courant number": c,
        "Time/End time": 1 if reduced else TURNS})
        for c in ((5.,) if reduced else (.5, 2., 5., 20.))}
    rows = []
    for courant, output in finished(report, runs):
        probes = read_rows(output / "point_probes.csv")
        names = [k for k in probes[0] if k.startswith("level set")]
        peaks = [max(float(row[name]) for name in names) for row in probes]
        width = [sum(float(row[name]) for name in names[1:]) /
                 (4 * float(row[names[0]])) for row in probes]
        rows.append([courant, len(read_rows(output / "statistics.csv")),
                     round(column(probes, "time [s]")[-1]), peaks[0],
                     peaks[-1] / peaks[0] - 1., width[-1] - width[0]])
        report.limit(f"Gaussian pulse, Courant {courant:g}: the change of "
                     "the peak", abs(peaks[-1] / peaks[0] - 1.), .005)
    report.table("gaussian_pulse",
                 "A Gaussian pulse in a rotation, 64 by 64 cells",
                 ["Courant number", "steps", "turns", "peak at the start",
                  "relative change of the peak",
                  "change of the neighbours' mean over the peak"], rows)
