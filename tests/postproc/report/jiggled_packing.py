# SPDX-License-Identifier: GPL-2.0-or-later
"""Text dumps of discs on a square lattice that jiggle, so that every number differs from frame to frame."""
import math
import random

SIDE, RADIUS, APART = 6, 0.5, 0.98
HEAD = "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\nITEM: BOX BOUNDS {}\n{} {}\n{} {}\n-1 1\nITEM: {}\n"


class Packing:
    """frames[k] = (step, discs by id, contacts); a disc: dict of its columns, a contact: id1, id2, nx, ny, overlap, fx, fy."""

    def __init__(self, frames, periodic=False, seed=1):
        self.random = random.Random(seed)
        self.periodic = periodic
        length = SIDE * APART
        self.box = (0.0, length) if periodic else (-1.0, length + 1)
        self.frames = [self.frame(100 * (k + 1), latecomer=k >= frames // 2) for k in range(frames)]

    def frame(self, step, latecomer):
        discs = {}
        for i in range(SIDE * SIDE):
            discs[3 * i + 7] = self.disc(1 + i % 2, (i % SIDE + 0.5) * APART, (i // SIDE + 0.5) * APART, RADIUS)
        contacts = [row for i in range(SIDE * SIDE) for row in self.contacts_of(i, discs)]
        if latecomer:  # in the middle of four others, touching none: ids change
            discs[8] = self.disc(2, APART, APART, 0.15)
        return step, discs, contacts

    def disc(self, kind, x, y, radius):
        shake = lambda size: self.random.uniform(-size, size)
        return {"type": kind, "x": x + shake(0.004), "y": y + shake(0.004), "radius": radius, "vx": shake(1), "vy": shake(1), "omegaz": shake(3), "mass": 2.0}

    def contacts_of(self, i, discs):
        """With the neighbours to the right and above, and with the walls left and below."""
        own = 3 * i + 7
        column, row = i % SIDE, i // SIDE
        for ahead, last, step, wall, normal in ((column, column == SIDE - 1, 1, -1, (-1, 0)), (row, row == SIDE - 1, SIDE, -3, (0, -1))):
            if not last or self.periodic:
                other = 3 * (i + step - (SIDE * step if last else 0)) + 7
                yield self.row(own, other, discs)
            if ahead == 0 and not self.periodic:
                yield self.with_force(own, wall, normal[0], normal[1], 0.01)

    def row(self, own, other, discs):
        d = [discs[other][axis] - discs[own][axis] for axis in "xy"]
        length = self.box[1] - self.box[0]
        if self.periodic:
            d = [part - length * round(part / length) for part in d]
        distance = math.hypot(*d)
        return self.with_force(own, other, d[0] / distance, d[1] / distance, 2 * RADIUS - distance)

    def with_force(self, own, other, nx, ny, overlap):
        fn, ft = 1000 * overlap * self.random.uniform(0.5, 1.5), 100 * overlap * self.random.uniform(-1, 1)
        return own, other, nx, ny, overlap, -fn * nx - ft * ny, -fn * ny + ft * nx

    def write(self, particles, contacts):
        low, high = self.box
        ends = "pp pp pp" if self.periodic else "ff ff pp"
        columns = ["type", "x", "y", "radius", "vx", "vy", "omegaz", "mass"]
        with open(particles, "w", encoding="utf-8") as discs_file, open(contacts, "w", encoding="utf-8") as contacts_file:
            for step, discs, rows in self.frames:
                discs_file.write(HEAD.format(step, "ATOMS", len(discs), ends, low, high, low, high, "ATOMS id " + " ".join(columns)))
                for identity, disc in discs.items():
                    discs_file.write(" ".join([str(identity)] + [repr(disc[column]) for column in columns]) + "\n")
                contacts_file.write(HEAD.format(step, "ENTRIES", len(rows), ends, low, high, low, high, "ENTRIES id1 id2 nx ny overlap fx fy"))
                contacts_file.writelines(" ".join(map(repr, row)) + "\n" for row in rows)
