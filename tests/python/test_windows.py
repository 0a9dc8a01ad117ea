# SPDX-License-Identifier: GPL-2.0-or-later
"""Averages as functions of time."""
import unittest

import numpy as np

import mikromakro
from program import Case, dumps, program


class Windows(Case):
    def setUp(self):
        super().setUp()
        self.files = dumps(self.folder, 6, lambda frame: 1.0 + frame)
        self.keywords = {**self.files, "fields": ["velocity", "stress"], "rings": (1, 4, 3), "timestep": 0.5}

    def test_tables_are_those_of_the_program(self):
        for option, words in [({"every": 2}, ["--every", 2]), ({"per_frame": True}, ["--per-frame"]), ({"moving": 4}, ["--moving", 4])]:
            text, _ = program("average", "--particles", self.files["particles"], "--contacts", self.files["contacts"], "--fields",
                              "velocity,stress", "--rings", 1, 4, 3, "--timestep", 0.5, *words)
            result = mikromakro.average(**self.keywords, **option)
            self.assertEqual(result.to_csv(), text)

    def test_time_is_an_axis(self):
        # windows of the frames 0 1, 2 3, 4 5 in steps of 0.5 s; v_phi = 1 + frame
        for result in (mikromakro.average(**self.keywords, every=2), self.through_a_file("w.csv"), self.through_a_file("w.h5")):
            data = result.to_xarray()
            self.assertEqual(data["v_phi"].sizes, {"time": 3, "r": 3})
            self.assertEqual(data["time"].values.tolist(), [0.25, 1.25, 2.25])
            np.testing.assert_allclose(data["v_phi"].values, [[1.5] * 3, [3.5] * 3, [5.5] * 3], rtol=1e-14)
            self.assertEqual(data["r_outer"].values.tolist(), [2, 3, 4])
            self.assertEqual(data["step_first"].dims, ("time",))
            self.assertEqual(float(data["v_phi"].sel(time=1.25, r=2.5)), float(result["v_phi"][4]))

    def test_fits_and_audits(self):
        files = dumps(self.folder, 6, lambda frame: 1.0 + frame, decay=0.5)
        result = mikromakro.average(particles=files["particles"], fields="velocity", rings=(1, 4, 3), weight="centre", every=2)
        fits = mikromakro.fit(result, ri=1.0)
        result.to_csv(self.path("w.csv"))
        self.assertEqual(fits.columns[:4], ("step", "time", "step_first", "step_last"))
        np.testing.assert_allclose(fits["s"], [1 / np.log(2)] * 3, rtol=1e-9)
        self.assertEqual(fits.to_csv().replace(dict(fits.header)["table"], self.path("w.csv")),
                         program("fit", self.path("w.csv"), "--ri", 1.0)[0])
        audits = mikromakro.audit(**self.files, rings=(1, 4, 3), every=3)
        self.assertEqual(audits.to_csv(), program("audit", "--particles", self.files["particles"], "--contacts", self.files["contacts"],
                                                  "--rings", 1, 4, 3, "--every", 3)[0])

    def through_a_file(self, name):
        mikromakro.average(**self.keywords, every=2, out=self.path(name))
        return mikromakro.read(self.path(name))


if __name__ == "__main__":
    unittest.main()
