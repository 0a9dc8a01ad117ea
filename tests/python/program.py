# SPDX-License-Identifier: GPL-2.0-or-later
"""The program beside the module, and frames for both."""
import os
import subprocess
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.join(os.path.dirname(HERE), "data")
GOOD = {name: os.path.join(DATA, "good", name + ".dump") for name in ("particles", "contacts")}
# One frame of a ring cell.
CELL = {name: os.path.join(DATA, "reference", f"couette_small_{name}.dump.gz") for name in ("particles", "contacts")}
PROGRAM = os.environ["MIKROMAKRO"]


def program(*words):
    """Standard output of a verb, and what it says on stderr."""
    ran = subprocess.run([PROGRAM, *(str(word) for word in words)], capture_output=True, text=True, check=False)
    return ran.stdout, ran.stderr


def dumps(folder, frames, speed=lambda frame: 1.0, decay=1.0):
    """Frames of three discs on a circle around the origin, one in each ring of (1, 4, 3), in two files: 1-2 touch, with a force of
    `frame` N; v_phi is speed(frame),
    times `decay` from each to the next."""
    particles, contacts = os.path.join(folder, "p.dump"), os.path.join(folder, "c.dump")
    head = "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\nITEM: BOX BOUNDS ff ff pp\n-9 9\n-9 9\n-1 1\nITEM: {} "
    with open(particles, "w", encoding="utf-8") as p, open(contacts, "w", encoding="utf-8") as c:
        for frame in range(frames):
            p.write(head.format(frame, "ATOMS", 3, "ATOMS") + "id type x y radius mass vx vy omegaz\n")
            for k in range(3):
                p.write(f"{k + 1} {1 + k % 2} {1.5 + k} 0 0.525 {1 + k} 0 {float(speed(frame) * decay**k)!r} 0\n")
            c.write(head.format(frame, "ENTRIES", 1, "ENTRIES") + "id1 id2 nx ny overlap fx fy\n")
            c.write(f"1 2 1 0 0.05 {-1.0 - frame!r} 0\n")
    return {"particles": particles, "contacts": contacts}


class Case(unittest.TestCase):
    """A folder for each test."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)
