# SPDX-License-Identifier: GPL-2.0-or-later
"""The time of a run over the skin of its neighbour lists, which changes nothing else."""
import numpy as np

from accuracy import runs, scene

TITLE = "Skin"
SKINS, REPETITIONS, DT, SHEAR_TIME = (0.0002, 0.0004, 0.0008, 0.0016, 0.0032), 5, 4e-5, 4
CELLS = {"small": 1131, "B": 2939}  # free discs


def section():
    """Whole runs, from the dilute start on, in turn."""
    times = {(cell, skin): [] for cell in CELLS for skin in SKINS}
    steps = (2.5 + SHEAR_TIME) / DT
    for k in range(1, REPETITIONS + 1):
        for cell, skin in times:
            folder = runs.engine(f"skin_{cell}_{1e3 * skin:g}_{k}", scene.COUETTE, run=cell, law="cundall_strack", skin=skin, discard_time=0,
                                 measure_time=SHEAR_TIME, snap_time=SHEAR_TIME)
            times[cell, skin].append(1e6 * runs.seconds(folder) / steps)
    yield (f"`inputs/couette`, t_c/54, law with spring, from the dilute start through {SHEAR_TIME} s of shear: processor time per step in us as a function of the skin of the "
           f"neighbour lists, median (least to most) of {REPETITIONS} alternating runs. The skin changes the order of summation, and thus the last digits, nothing else.")
    yield ""
    yield "| free discs | " + " | ".join(f"{1e3 * skin:g} mm" for skin in SKINS) + " |"
    yield "| --- " * (len(SKINS) + 1) + "|"
    for cell, discs in CELLS.items():
        yield f"| {discs} | " + " | ".join(f"{np.median(took):.1f} ({min(took):.1f} to {max(took):.1f})" for took in (times[cell, skin] for skin in SKINS)) + " |"
