# SPDX-License-Identifier: GPL-2.0-or-later
"""How many discs there are in the last frame of d.txt, and the largest overlap over 4 mm."""
import math

rows = open("d.txt").read().split("ITEM: ATOMS")[-1].splitlines()[1:]
discs = [[float(word) for word in row.split()[2:5]] for row in rows if row]
overlaps = [a[2] + b[2] - math.hypot(a[0] - b[0], a[1] - b[1]) for k, a in enumerate(discs) for b in discs[:k]]
print(len(discs), max(overlaps) / 0.004)
