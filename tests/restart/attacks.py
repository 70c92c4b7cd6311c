# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that others disturb: by signals, kills, full disks, and more."""

import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import time

from place import Failure, step_of, steps

OFTEN = ["--set", "Checkpoint/Steps between=2"]


def family(pid):
    """The process PID and all that it has started, directly or not."""
    children = {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                parent = (entry / "stat").read_text().rsplit(")", 1)[1]
            except OSError:
                continue
            children.setdefault(int(parent.split()[1]), []).append(
                int(entry.name))
    found = [pid]
    for member in found:
        found += children.get(member, [])
    return found


def end(process):
    """Kills a run with all its processes, and waits for their end."""
    members = family(process.pid)
    for member in members:
        try:
            os.kill(member, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.wait()
    while any(pathlib.Path(f"/proc/{member}").exists() and
              "Z" != state(member) for member in members):
        time.sleep(.01)


def state(pid):
    """The letter that says what a process does."""
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(
            ")", 1)[1].split()[0]
    except OSError:
        return "Z"


def wait_for_steps(place, name, n, process):
    """Until the run called NAME has done N steps."""
    table = place.directory / name / "statistics.csv"
    while not (table.exists() and len(table.read_text().splitlines()) > n):
        if process.poll() is not None:
            raise Failure(f"{name} ended with {process.returncode} before it "
                          "was disturbed")
        time.sleep(.001)


def terminated(place, arguments):
    """Signals in the middle of a step; on several processes through mpiexec,
    which kills them a second after all others but passes this one on."""
    place.run("straight", *steps(150))
    for number in (signal.SIGUSR2, signal.SIGTERM, signal.SIGINT,
                   signal.SIGHUP):
        name = number.name
        if place.ranks > 1 and number != signal.SIGUSR2:
            continue
        process = place.start(name, *steps(150), output=subprocess.PIPE)
        wait_for_steps(place, name, 3, process)
        process.send_signal(number)
        said = process.communicate(timeout=200)[0]
        if place.ranks == 1 and process.returncode != 128 + number:
            raise Failure(f"exit code {process.returncode} after {name}")
        if place.ranks == 1 and f"Stopped by {name}" not in said:
            raise Failure(f"{name} is not named:\n{said}")
        if not len(place.table(name)) < len(place.table("straight")):
            raise Failure(f"the run was over before {name} came")
        if step_of(place.checkpoints(name)[-1]) != len(place.table(name)):
            raise Failure(f"{name}: the last step is not saved")
        place.run(name, "--resume", *steps(150))
        place.expect_equal("straight", name)


def terminated_early(place, arguments):
    """A signal during set-up ends the run at once; nohup's stays ignored."""
    long = ["--set", "Refinement/Global levels=6",
            "--set", "Refinement/Adaptive/Maximum level=7"]
    process = place.start("early", *long, output=subprocess.PIPE)
    log = place.directory / "early" / "log.txt"
    while not (log.exists() and log.read_text()):
        time.sleep(.001)
    process.send_signal(signal.SIGTERM)
    begin = time.monotonic()
    said = process.communicate(timeout=100)[0]
    if process.returncode != 128 + signal.SIGTERM or "Stopped" not in said:
        raise Failure(f"exit code {process.returncode}:\n{said}")
    if time.monotonic() - begin > 5:
        raise Failure("the run did not stop at once")

    command = place.command("nohup", [])
    process = subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    wait_for_steps(place, "nohup", 2, process)
    process.send_signal(signal.SIGHUP)
    if process.wait(timeout=200) != 0:
        raise Failure("SIGHUP ended a run that was told to ignore it")


def piped(place, arguments):
    """A pipe that is closed after the first line."""
    place.run("straight")
    process = place.start("piped", output=subprocess.PIPE)
    process.stdout.readline()
    process.stdout.close()
    if process.wait(timeout=200) != 0:
        raise Failure(f"exit code {process.returncode} with a closed pipe")
    place.expect_equal("straight", "piped")
    log = (place.directory / "piped" / "log.txt").read_text()
    if "Ended after" not in log:
        raise Failure("the log has no end:\n" + log)


def locked(place, arguments):
    """A second run into the same directory is refused and does no harm."""
    place.run("straight", *OFTEN)
    process = place.start("both", *OFTEN)
    while not place.checkpoints("both"):
        time.sleep(.001)
    for member in family(process.pid):
        os.kill(member, signal.SIGSTOP)
    for option in ([], ["--resume"]):
        said = place.run("both", *option, code=1)
        if "Another run is writing" not in said or "--output" not in said:
            raise Failure(said)
    for member in family(process.pid):
        os.kill(member, signal.SIGCONT)
    if process.wait(timeout=200) != 0:
        raise Failure("the first run was disturbed")
    place.expect_equal("straight", "both")


def again(place, name):
    """What a run called NAME needs to go on, or to begin anew."""
    if place.checkpoints(name):
        return ["--resume"]
    shutil.rmtree(place.directory / name, ignore_errors=True)
    return []


def killed(place, arguments):
    """SIGKILL at any time, again and again."""
    begin = time.monotonic()
    place.run("straight", *OFTEN)
    duration = time.monotonic() - begin
    chance = random.Random(arguments.seed)
    for i in range(arguments.times):
        process = place.start("killed", *OFTEN, *again(place, "killed"))
        try:
            process.wait(timeout=chance.uniform(.2, 1.) * duration)
        except subprocess.TimeoutExpired:
            end(process)
        if len(place.checkpoints("killed")) and place.is_over("killed"):
            place.expect_equal("straight", "killed")
            shutil.rmtree(place.directory / "killed")
    place.run("killed", *OFTEN, *again(place, "killed"))
    place.expect_equal("straight", "killed")


def limit_files(process, n_bytes):
    """From now on files of a run cannot grow beyond N_BYTES."""
    for member in family(process.pid)[1:] or [process.pid]:
        try:
            resource.prlimit(member, resource.RLIMIT_FSIZE,
                             (n_bytes, resource.RLIM_INFINITY))
        except ProcessLookupError:
            pass


def full_disk(place, arguments):
    """From some moment on nothing can be written any more, or no large file;
    then there is room again."""
    begin = time.monotonic()
    place.run("straight", *OFTEN)
    duration = time.monotonic() - begin
    chance = random.Random(arguments.seed)
    for i in range(arguments.times):
        resume = again(place, "full")
        log = place.directory / "full" / "log.txt"
        old = log.read_text() if log.exists() else ""
        process = place.start("full", *OFTEN, *resume,
                              output=subprocess.PIPE)
        # Before that MPI is not ready, which needs files of its own.
        while not (log.exists() and len(log.read_text()) > len(old)):
            time.sleep(.001)
        time.sleep(chance.uniform(0., .9) * duration)
        limit_files(process, chance.choice((0, 1000, 10000, 100000)))
        said = process.communicate(timeout=200)[0]
        check_failure(place, said, process.returncode)
        if process.returncode == 0:
            place.run("full", *OFTEN, *again(place, "full"))
            place.expect_equal("straight", "full")
            shutil.rmtree(place.directory / "full")
    place.run("full", *OFTEN, *again(place, "full"))
    place.expect_equal("straight", "full")


def check_failure(place, said, code):
    """A run that could not write says so in one message with a file."""
    if code not in (0, 1):
        raise Failure(f"exit code {code}:\n{said}")
    errors = [line for line in said.splitlines() if line.startswith("Error")]
    if code == 1 and (len(errors) != 1 or str(place.directory) not in
                      errors[0]):
        raise Failure("no message with a file:\n" + said)
    for words in ("abort", "Abort", "signal", "terminate called"):
        if words in said and place.ranks == 1:
            raise Failure(f"'{words}' is in:\n{said}")


def vanished(place, arguments):
    """The directory, or a file in it, is removed or moved during the run."""
    def remove(path):
        shutil.rmtree(path)

    def move(path):
        path.rename(path.with_name("moved"))

    def remove_table(path):
        (path / "front_position.csv").unlink()

    def full_table(path):
        table = path / "fields"
        shutil.rmtree(table)
        table.write_text("")

    for how in (remove, move, remove_table, full_table):
        process = place.start("gone", output=subprocess.PIPE)
        wait_for_steps(place, "gone", 3, process)
        process.send_signal(signal.SIGSTOP)
        how(place.directory / "gone")
        process.send_signal(signal.SIGCONT)
        said = process.communicate(timeout=100)[0]
        if process.returncode != 1:
            raise Failure(f"exit code {process.returncode}:\n{said}")
        check_failure(place, said, 1)
        for name in ("gone", "moved"):
            shutil.rmtree(place.directory / name, ignore_errors=True)
