# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the plotting tools share: reading the tables and fields of a run."""

import csv
import os
import sys
import xml.etree.ElementTree

try:
    import matplotlib
    matplotlib.use("Agg")
    import numpy
except ImportError:
    sys.exit("This tool needs the Debian packages python3-matplotlib and "
             "python3-numpy: apt install python3-matplotlib")

HERE = os.path.dirname(os.path.abspath(__file__))

# A colour-blind safe sequence.
COLORS = ["#0b62a4", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]


def fail(message):
    """Ends the tool with a message."""
    sys.exit("Error: " + message)


def read_rows(path):
    """The rows of a CSV file as dictionaries, comment lines skipped."""
    try:
        with open(path, newline="") as file:
            lines = [line for line in file if not line.startswith("#")]
    except OSError as error:
        fail(f"cannot read '{path}': {error.strerror}.")
    return list(csv.DictReader(lines))


def read_table(path):
    """The columns of a CSV file of numbers; empty cells become NaN."""
    rows = read_rows(path)
    if not rows:
        fail(f"'{path}' has no rows yet.")

    def number(text):
        try:
            return float(text)
        except (TypeError, ValueError):
            return numpy.nan

    return {name: numpy.array([number(row[name]) for row in rows])
            for name in rows[0]}


def time_column(table, path):
    """The times in s."""
    for name in table:
        if name.startswith("time [s]"):
            return table[name]
    fail(f"'{path}' has no column 'time [s]'.")


def label(directory):
    """How a run is called in a legend."""
    return os.path.basename(os.path.normpath(directory))


def read_series(directory, name):
    """The (time, file) pairs of the record `name`.pvd."""
    path = os.path.join(directory, name + ".pvd")
    try:
        root = xml.etree.ElementTree.parse(path).getroot()
    except (OSError, xml.etree.ElementTree.ParseError) as error:
        fail(f"cannot read '{path}': {error}. Does the run write '{name}'?")
    return [(float(entry.get("timestep")),
             os.path.join(directory, entry.get("file")))
            for entry in root.iter("DataSet")]


def save(figure, path):
    """Writes the picture and says so."""
    figure.savefig(path, dpi=160, bbox_inches="tight")
    print(f"Wrote {path}")
