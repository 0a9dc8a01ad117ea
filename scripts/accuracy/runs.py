# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of the engine and of mikromakro with the processor time that they took, kept in out/accuracy."""
import json
import os
import shutil
import subprocess
import sys

KEPT = os.path.join("out", "accuracy")
ENGINE, MIKROMAKRO = (os.path.join("build", "bin", name) for name in ("liggghts-disc", "mikromakro"))


def timed(command, output):
    """Runs a command; its processor time (s), which other programs on the machine change less than the time on the wall."""
    with open(output, "w") as file:
        process = subprocess.Popen(command, stdout=file, stderr=file, stdin=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"accuracy_cost: {' '.join(command)} failed, see {output}")
    return usage.ru_utime + usage.ru_stime


def engine(name, script, **variables):
    """Folder of a run of an input script, which is done once; `seconds` of seconds.json is its processor time."""
    folder = os.path.join(KEPT, name)
    record = {"script": script, **{key: str(value) for key, value in variables.items()}}
    done = os.path.join(folder, "done.json")
    if os.path.exists(done):
        with open(done) as file:
            kept = json.load(file)
        if kept["record"] == record:
            return folder
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    command = [ENGINE, "-in", script, "-log", "none"]
    for key, value in (*variables.items(), ("out", folder)):
        command += ["-var", key, str(value)]
    print(f"accuracy_cost: {name}", file=sys.stderr)
    seconds = timed(command, os.path.join(folder, "screen.txt"))
    with open(done, "w") as file:
        json.dump({"record": record, "seconds": seconds}, file)
    return folder


def seconds(folder):
    with open(os.path.join(folder, "done.json")) as file:
        return json.load(file)["seconds"]


def mikromakro(*arguments):
    return subprocess.run([MIKROMAKRO, *arguments], check=True, capture_output=True, text=True).stdout
