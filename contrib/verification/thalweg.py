"""Running Thalweg and reading its tables."""

import csv
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
REFERENCE = pathlib.Path(__file__).resolve().parent / "reference"


class Runner:
    """Runs cases of prm/ with changed settings below one directory."""

    def __init__(self, binary, directory):
        self.binary = binary
        self.directory = pathlib.Path(directory)

    def run(self, case, name, settings):
        """Runs a case; returns the directory of its results."""
        output = self.directory / name
        command = [str(self.binary), str(ROOT / "prm" / (case + ".prm")),
                   "--output", str(output)]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        environment = dict(os.environ, OMP_NUM_THREADS="1")
        result = subprocess.run(command, env=environment, text=True,
                                capture_output=True)
        if result.returncode != 0:
            raise RuntimeError(f"'{' '.join(command)}' failed:\n"
                               + result.stdout[-500:] + result.stderr[-2000:])
        return output


def read_rows(path):
    """The rows of a CSV file as dictionaries, comment lines skipped."""
    with open(path, newline="") as file:
        return list(csv.DictReader(l for l in file if not l.startswith("#")))


def column(rows, name):
    """One column as numbers."""
    return [float(row[name]) for row in rows]
