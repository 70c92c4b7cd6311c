# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables, plots and the limits that a result must keep."""

import csv

try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    pyplot = None


def text(value):
    """A cell of a table."""
    return f"{value:.4g}" if isinstance(value, float) else str(value)


class Report:
    """Collects what one part of the verification found."""

    def __init__(self, directory):
        self.directory = directory
        self.faults = []
        directory.mkdir(parents=True, exist_ok=True)

    def table(self, name, title, columns, rows):
        """Writes NAME.csv and NAME.md, and prints the latter."""
        with open(self.directory / (name + ".csv"), "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(columns)
            writer.writerows([text(v) for v in row] for row in rows)
        lines = [f"# {title}", "", "| " + " | ".join(columns) + " |",
                 "|" + " --- |" * len(columns)]
        lines += ["| " + " | ".join(text(v) for v in row) + " |"
                  for row in rows]
        (self.directory / (name + ".md")).write_text("\n".join(lines) + "\n")
        print("\n".join(lines), end="\n\n", flush=True)

    def limit(self, what, value, largest):
        """Remembers a fault if a value, or not a number, passes a limit."""
        if not value <= largest:
            self.faults.append(f"{what} is {value:.4g}, above {largest:.4g}")

    def at_least(self, what, value, smallest):
        """Remembers a fault if a value is below a limit, or not a number."""
        if not value >= smallest:
            self.faults.append(f"{what} is {value:.4g}, below {smallest:.4g}")

    def within(self, what, value, lower, upper):
        """Remembers a fault if a value lies outside of an interval."""
        if not lower <= value <= upper:
            self.faults.append(f"{what} is {value:.4g}, not within "
                               f"{lower:.4g} and {upper:.4g}")

    def plot(self, name, curves, x_label, y_label, scale="linear"):
        """Draws curves (label, x, y, style), if matplotlib is installed;
        SCALE is that of both axes, or 'x scale, y scale'."""
        if pyplot is None:
            return
        figure, axes = pyplot.subplots(figsize=(7.5, 4))
        for label, x, y, style in curves:
            axes.plot(x, y, style, label=label)
        scales = scale.split(", ")
        axes.set_xscale(scales[0])
        axes.set_yscale(scales[-1])
        axes.set_xlabel(x_label)
        axes.set_ylabel(y_label)
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.), frameon=False)
        figure.tight_layout()
        figure.savefig(self.directory / (name + ".png"), dpi=120)
        pyplot.close(figure)
