# SPDX-License-Identifier: LGPL-2.1-or-later
"""Running Thalweg and reading its tables."""

import csv
import math
import os
import pathlib
import subprocess
import threading
import time
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[2]
REFERENCE = pathlib.Path(__file__).resolve().parent / "reference"


class CaseFailed(RuntimeError):
    """A run that ended with an error or took too long."""


class Output(type(pathlib.Path())):
    """The directory of a run's results; knows what the run cost."""

    cpu_time = math.nan


class Runner:
    """Runs cases of prm/ with changed settings below one directory."""

    def __init__(self, binary, directory, jobs=1, log=print):
        self.binary = binary
        self.directory = pathlib.Path(directory)
        self.log = log
        self.pool = ThreadPoolExecutor(jobs)
        self.cpu_time = 0.
        self.lock = threading.Lock()

    def start(self, case, name, settings, limit=900):
        """Runs a case when its turn comes; result() of what this returns is
        the directory of its results. After LIMIT seconds it is stopped."""
        return self.pool.submit(self.run, case, name, settings, limit)

    def run(self, case, name, settings, limit=900):
        """Runs a case now; returns the directory of its results."""
        output = Output(self.directory / name)
        output.mkdir(parents=True, exist_ok=True)
        command = [str(self.binary), str(ROOT / "prm" / (case + ".prm")),
                   "--output", str(output)]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        begin = time.time()
        with open(output / "terminal.txt", "w+") as text:
            code, output.cpu_time = wait(
                subprocess.Popen(command, stdout=text, stderr=text,
                                 env=dict(os.environ, OMP_NUM_THREADS="1")),
                limit)
            text.seek(0)
            message = text.read()[-2000:]
        with self.lock:
            self.cpu_time += output.cpu_time
        self.log(f"{name}: {time.time() - begin:.0f} s, "
                 f"{output.cpu_time:.0f} CPU s")
        if code != 0:
            reason = "failed" if code > 0 else f"was stopped ({limit} s)"
            raise CaseFailed(f"'{' '.join(command)}' {reason}:\n{message}")
        return output


def wait(process, limit):
    """Waits for a process; returns its exit code, negative if it was stopped
    after LIMIT seconds, and its CPU time in s."""
    timer = threading.Timer(limit, process.kill)
    timer.start()
    _, status, usage = os.wait4(process.pid, 0)
    timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


def finished(report, runs):
    """Those of RUNS (key: what Runner.start() returned) that ended well, as
    (key, directory); the others become faults of the report."""
    for key, run in runs.items():
        try:
            yield key, run.result()
        except CaseFailed as error:
            name = " ".join(map(str, key)) if isinstance(key, tuple) else key
            report.faults.append(f"{name}: {error}")


def read_rows(path):
    """The rows of a CSV file as dictionaries, comment lines skipped."""
    with open(path, newline="") as file:
        return list(csv.DictReader(l for l in file if not l.startswith("#")))


def column(rows, name):
    """One column as numbers, not-a-number where it is empty."""
    return [float(row[name] or "nan") for row in rows]


def steps_and_courant(output):
    """The number of steps of a run, and its largest Courant number."""
    rows = read_rows(output / "statistics.csv")
    return len(rows), max(column(rows, "Courant number"))


def order(coarse, fine, ratio):
    """The order at which an error falls when the size falls by RATIO."""
    if not (coarse > 0 and fine > 0):
        return math.nan
    return math.log(coarse / fine) / math.log(ratio)
