# SPDX-License-Identifier: GPL-2.0-or-later
# %% [markdown]
# # A shear profile, from Python
# A small shear cell: the velocity of the discs against the distance from the wheel, with errors and a fit, and the shear stress next to
# the wheel as a function of time. From the top folder: PYTHONPATH=build/python python3 docs/examples/shear_profile.py

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

# %% The profile over 60 s; types 3 and 4 are the discs of the wheel and of the ring.
rings = dict(rings=(0.1032, 0.1782, 10), bulk_types=[1, 2])
profile = mikromakro.average(RUN, **rings, fields=["solid_fraction", "velocity", "stress"])
fitted = mikromakro.fit(profile, ri=0.1032, omega=0.1)
print(fitted)

# %% The same in windows of ten frames, 5 s: time is the first axis. The last frame, the 121st, would fill no window.
series = mikromakro.average(RUN, **rings, fields=["stress"], frames="0:119", every=10, error_blocks=0).to_xarray()
near = series["sigma_phir"].sel(r=slice(0.105, 0.120)).mean("r")
print(f"sigma_phir near the wheel: {float(near.mean()):.3g} {series['sigma_phir'].attrs['units']}, varies by {float(near.std()):.2g}")

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
left.errorbar(1000 * profile["r"], 1000 * profile["v_phi"], 1000 * profile.errors["v_phi"], fmt="o", ms=4, color="black", label="discs")
r = np.linspace(0.1032, 0.1782, 200)
left.plot(1000 * r, 1000 * fitted.v0 * np.exp(-(r - fitted.r_i) / fitted.s), "--", color="black", label=f"s = {1000 * fitted.s:.1f} mm")
left.set(xlabel="r in mm", ylabel=r"$v_\varphi$ in mm/s")
left.legend()
right.plot(series["time"], near, "o-", ms=4, color="black")
right.set(xlabel="t in s", ylabel=rf"$\sigma_{{\varphi r}}$ near the wheel in {series['sigma_phir'].attrs['units']}")
figure.savefig(f"{FOLDER}/shear_profile.png", dpi=110)
