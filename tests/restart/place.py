# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of one case in a directory of their own, and what they must leave."""

import csv
import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
MPIEXEC = [str(HERE.parent.parent / "contrib" / "mpi_run"), "--shared"]
# Values in base.prm that do not fit into three dimensions.
FLAT = ["set Dimension = 2", "set Repetitions = 4, 4", "set Gravity = 0, -9.81"]
# deal.II writes the time of day into its files.
DATE = re.compile(rb"on \d+/\d+/\d+ at \d+:\d+:\d+")


class Failure(Exception):
    """What is wrong, in a sentence."""


def rows_without_times(path):
    """The rows of a table without what the machine took."""
    with open(path, newline="") as text:
        return [{k: v for k, v in row.items()
                 if not (k or "").startswith("wall")}
                for row in csv.DictReader(text)]


def difference_of_rows(one, other):
    """Where the rows that both tables have differ first: the number of the
    row, from one on, the column and both values; None if they do not."""
    for number, (a, b) in enumerate(zip(one, other), 1):
        for column in a:
            if a[column] != b.get(column):
                return number, column, a[column], b.get(column)
    return None


def step_of(checkpoint):
    """The step in the name of a checkpoint."""
    return int(checkpoint.name.split("_")[1])


class Place:
    """A directory with the input file, and the runs in it."""

    def __init__(self, program, settings, ranks):
        self.program = program
        self.settings = settings
        self.ranks = ranks
        self.directory = pathlib.Path(tempfile.mkdtemp(prefix="restart_"))
        text = (HERE / "base.prm").read_text()
        if "Dimension=3" in settings:
            for line in FLAT:
                text = text.replace(line, "")
        self.input = self.directory / "base.prm"
        self.input.write_text(text)

    def command(self, name, options, ranks=None):
        """The command line of the run whose results are called NAME."""
        ranks = ranks or self.ranks
        words = [] if ranks == 1 else MPIEXEC + [str(ranks)]
        words += [self.program, str(self.input),
                  "--output", str(self.directory / name)]
        # The program wants each parameter once; here the last one counts.
        values, rest, options = {}, [], list(options)
        for setting in self.settings:
            values[setting.split("=")[0]] = setting
        while options:
            word = options.pop(0)
            if word == "--set":
                setting = options.pop(0)
                values[setting.split("=")[0]] = setting
            else:
                rest.append(word)
        for setting in values.values():
            words += ["--set", setting]
        return words + rest

    def run(self, name, *options, ranks=None, code=0):
        """Runs to the end; the text that the program wrote."""
        done = subprocess.run(self.command(name, list(options), ranks),
                              capture_output=True, text=True, timeout=300,
                              check=False)
        if done.returncode != code:
            raise Failure(f"{name}: exit code {done.returncode} instead of "
                          f"{code}:\n{done.stdout}\n{done.stderr}")
        return done.stdout + done.stderr

    def start(self, name, *options, output=subprocess.DEVNULL):
        """Starts a run and does not wait."""
        return subprocess.Popen(self.command(name, list(options)),
                                stdout=output, stderr=subprocess.STDOUT,
                                text=True)

    def table(self, name, file="statistics.csv"):
        """The rows of a table without its timings."""
        return rows_without_times(self.directory / name / file)

    def files(self, name, without=None):
        """All results that must be the same, with their content, but for
        those in the folder WITHOUT."""
        root = self.directory / name
        # Cells and particles in .vtu files stand in the order in which they
        # were made.
        return {str(path.relative_to(root)): DATE.sub(b"", path.read_bytes())
                for path in root.rglob("*")
                if path.suffix in (".csv", ".pvd")
                and path.name not in ("statistics.csv", "timers.csv")
                and without not in path.parts}

    def checkpoints(self, name):
        """The whole checkpoints, the oldest first; not those that a run was
        killed in the middle of."""
        directory = self.directory / name / "checkpoints"
        return sorted((path for path in directory.glob("step_*")
                       if re.fullmatch(r"step_\d+", path.name)),
                      key=step_of)

    def is_over(self, name):
        """Whether the run called NAME came to its end."""
        log = self.directory / name / "log.txt"
        return log.exists() and "Ended after" in log.read_text()

    def expect_equal(self, one, other, without=None):
        """Both runs left the same to the last bit."""
        a, b = self.table(one), self.table(other)
        if len(a) != len(b):
            raise Failure(f"{len(a)} rows in {one}, {len(b)} in {other}")
        found = difference_of_rows(a, b)
        if found:
            row, column, x, y = found
            raise Failure(f"step {a[row - 1]['step']}, {column}: {x} in {one}, "
                          f"{y} in {other}")
        c, d = self.files(one, without), self.files(other, without)
        if c.keys() != d.keys():
            raise Failure(f"only in one: {sorted(c.keys() ^ d.keys())}")
        for name in c:
            if c[name] != d[name]:
                raise Failure(f"{name} differs between {one} and {other}")

    def expect_near(self, one, other, tolerance, columns):
        """The last rows agree but for solver tolerances."""
        a, b = self.table(one)[-1], self.table(other)[-1]
        if len(self.table(one)) != len(self.table(other)):
            raise Failure("not as many rows")
        for column in columns:
            x, y = float(a[column]), float(b[column])
            if abs(x - y) > tolerance * max(abs(x), abs(y)):
                raise Failure(f"{column}: {x} in {one}, {y} in {other}")


def steps(n):
    """An option: the run ends after N steps."""
    return ["--set", f"Time/Maximal number of steps={n}"]
