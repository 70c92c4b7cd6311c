"""Rest stays rest, and uniform flow stays uniform, whatever the densities."""

from thalweg import column, read_rows

# case: what the velocity must be in m/s, how far it may be off, steps a s
CASES = {"hydrostatic_two_fluids": (0., 1e-9, 200),
         "drop_in_uniform_flow": (1., 1e-7, 16)}


def verify(runner, report, reduced):
    """200 steps of each, 50 in the reduced run."""
    steps = 50 if reduced else 200
    rows = []
    for case, (wanted, limit, rate) in CASES.items():
        output = runner.run(case, case, {
            "Time/End time": steps / rate, "Time/Time step": 1. / rate,
            "Postprocess/Models": ""})
        statistics = read_rows(output / "statistics.csv")
        deviation = max(abs(v - wanted) for fluid in (1, 2) for v in column(
            statistics, f"max velocity {fluid} [m/s]"))
        rows.append([case, steps, deviation, limit])
        report.limit(f"{case}: the velocity's deviation", deviation, limit)
    report.table("balance", "Rest and uniform flow", [
        "case", "steps", "largest deviation of |V| [m/s]", "limit [m/s]"],
        rows)
