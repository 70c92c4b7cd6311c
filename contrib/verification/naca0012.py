# SPDX-License-Identifier: LGPL-2.1-or-later
"""NACA 0012 at Re 10,000 and 4 degrees: means of lift, drag and pressure."""

from single_fluid import SPACES
from thalweg import column, finished, read_rows, steps_and_courant

WINDOW = (15., 25.)


def verify(runner, report, reduced):
    """Two meshes; there are no limits but that the flow develops."""
    levels = (0,) if reduced else (1, 2)
    start, end = (0., .5) if reduced else WINDOW
    runs = {level: runner.start(
        "naca0012", f"naca0012_{level}",
        {**SPACES["Q1-Q1"], "Refinement/Global levels": level,
         "Time/End time": end,
         "Postprocess/body forces/Average from": start,
         "Postprocess/surface coefficients/Average from": start,
         "Postprocess/Models": "body forces, surface coefficients"}, 5400)
        for level in levels}
    rows, curves = [], []
    for _, output in finished(report, runs):
        surface = read_rows(output / "surface_coefficients.csv")
        row = read_rows(output / "body_forces_summary.csv")[-1]
        n_steps, courant = steps_and_courant(output)
        cells = read_rows(output / "statistics.csv")[-1]["cells"]
        rows.append([cells, n_steps, courant,
                     f"{float(row['from [s]']):g} to "
                     f"{float(row['until [s]']):g}"]
                    + [float(row[f"residual {c} {kind}"])
                       for c in ("c_L", "c_D") for kind in ("mean", "rms")]
                    + [float(row["Strouhal number by spectrum"] or "nan"),
                       output.cpu_time])
        curves.append((f"{cells} cells", column(surface, "x [m]"),
                       [-v for v in column(surface, "mean c_p")], "-"))
    report.table("naca0012", "NACA 0012, Re 10,000, 4 degrees",
                 ["cells", "steps", "Courant number", "averaged over [s]",
                  "mean c_L", "rms of c_L", "mean c_D", "rms of c_D",
                  "Strouhal number", "CPU s"], rows)
    report.plot("naca0012", curves, "x / chord", "- mean c_p")
