# SPDX-License-Identifier: GPL-2.0-or-later
# %% [markdown]
# # A field of one's own
# How much of the kinetic energy in a shear zone is rotation, averaged like every other field; and the distribution of normal forces,
# from the frames themselves. From the top folder: PYTHONPATH=build/python python3 docs/examples/own_field.py

# %%
import os
import subprocess

import matplotlib.pyplot as plt
import numpy as np

import mikromakro

FOLDER = "out/python"
RUN = f"{FOLDER}/run.h5"
if not os.path.exists(RUN):  # half a minute of computing
    os.makedirs(FOLDER, exist_ok=True)
    subprocess.run(["build/bin/liggghts-disc", "-in", "inputs/couette/in.couette", "-screen", "none", "-var", "run", "small", "-var", "snapshot", "on",
                    "-var", "discard_time", "20", "-var", "measure_time", "60", "-var", "snap_time", "0.5", "-var", "out", FOLDER], check=True)


# %% A value for each disc of a frame; two columns, energy per mass.
def energy(frame):
    """Kinetic energy per mass, translation and rotation of a disc (J = m a^2/2)."""
    p = frame.particles
    return np.stack([0.5 * (p["vx"]**2 + p["vy"]**2), 0.25 * (p["radius"] * p["omegaz"])**2], axis=1)


field = mikromakro.Field(energy, columns=("translation", "rotation"), unit="m^2/s^2", mean="discs", needs=("vx", "vy", "omegaz"))
profile = mikromakro.average(RUN, rings=(0.1032, 0.1782, 10), bulk_types=[1, 2], fields=["velocity", field])
print("rotation/translation next to the wheel:", (profile["rotation"] / profile["translation"])[:3].round(2))

# %% Normal forces of all contacts of all frames, over their mean.
forces = []
for frame in mikromakro.frames(RUN):
    c = frame.contacts
    forces.append(-(c["fx"] * c["nx"] + c["fy"] * c["ny"]))
forces = np.concatenate(forces)
density, edges = np.histogram(forces / forces.mean(), bins=np.linspace(0, 8, 41), density=True)

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
for name, marker in (("translation", "o"), ("rotation", "s")):
    left.errorbar(1000 * profile["r"], profile[name], profile.errors[name], fmt=marker, ms=4, color="black", mfc="white" if marker == "s" else "black",
                  label=name)
left.set(xlabel="r in mm", ylabel=f"energy per mass in {profile.units['rotation'].replace('^2', '²')}", yscale="log")
left.legend()
right.step(0.5 * (edges[1:] + edges[:-1]), density, where="mid", color="black")
right.set(xlabel=r"$f_n/\langle f_n\rangle$", ylabel="probability density", yscale="log")
figure.savefig(f"{FOLDER}/own_field.png", dpi=110)
