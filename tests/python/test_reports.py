# SPDX-License-Identifier: GPL-2.0-or-later
"""fit, audit, draw and read."""
import json
import math
import os
import unittest
import warnings

import numpy as np

import mikromakro
from program import CELL, DATA, GOOD, Case, program

PROFILE = os.path.join(DATA, "good", "profile.csv")  # v = 2 exp(-(r - 1)/0.5)


def as_json(report):
    """As the program writes it: null for nan."""
    if isinstance(report, dict):
        return {name: as_json(value) for name, value in report.items()}
    if isinstance(report, np.ndarray):
        return [as_json(value) for value in report.tolist()]
    return None if isinstance(report, float) and math.isnan(report) else report


class Reports(Case):
    def test_fit(self):
        report = mikromakro.fit(PROFILE)
        self.assertAlmostEqual(report.v0, 2, delta=1e-9)
        self.assertAlmostEqual(report["s"], 0.5, delta=1e-9)
        self.assertTrue(math.isnan(report.s_err))
        self.assertEqual(str(report) + "\n", program("fit", PROFILE)[0])
        for keywords, words in [({"range": (1, 4), "log": True}, ["--range", 1, 4, "--log"]), ({"omega": 0.5}, ["--omega", 0.5])]:
            self.assertEqual(as_json(mikromakro.fit(PROFILE, **keywords)), json.loads(program("fit", PROFILE, "--json", *words)[0]))
        with self.assertRaisesRegex(mikromakro.Error, "--range: the range is empty"):
            mikromakro.fit(PROFILE, range=(4, 1))

    def test_fit_of_a_result(self):
        result = mikromakro.average(**CELL, rings=(0.1032, 0.1782, 10), bulk_types=[1, 2], fields="velocity")
        result.to_csv(self.path("rings.csv"))
        self.assertEqual(as_json(mikromakro.fit(result, ri=0.1032)),
                         json.loads(program("fit", self.path("rings.csv"), "--ri", 0.1032, "--json")[0]))

    def test_audit(self):
        keywords = {**CELL, "rings": (0.1032, 0.1782, 5), "bulk_types": [1, 2], "wheel_types": [3], "height": 0.006}
        words = ["--particles", CELL["particles"], "--contacts", CELL["contacts"], "--rings", 0.1032, 0.1782, 5, "--bulk-types", "1,2",
                 "--wheel-types", 3, "--height", 0.006]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            report = mikromakro.audit(**keywords)
            with self.assertRaisesRegex(mikromakro.Error, "balances are off"):
                mikromakro.audit(**keywords, bound=0)
        self.assertEqual(as_json(report), json.loads(program("audit", *words, "--json")[0]))
        self.assertEqual(str(report) + "\n", program("audit", *words)[0])
        self.assertEqual(report.balances["torque"].value, report.torque)
        self.assertEqual(report.r.shape, (5,))

    def test_draw(self):
        keywords = {**GOOD, "width": 200, "network": True}
        (picture,) = mikromakro.draw(**keywords)
        program("draw", "--particles", GOOD["particles"], "--contacts", GOOD["contacts"], "--width", 200, "--network", "--out",
                self.path("a.png"))
        with open(self.path("a.png"), "rb") as file:
            self.assertEqual(picture.data, file.read())
        self.assertEqual((picture._repr_png_(), picture._repr_svg_(), picture.file), (picture.data, None, None))
        pictures = mikromakro.draw(**keywords, frames="0:1", out=self.path("f_%d.svg"))
        self.assertEqual([one.file for one in pictures], [self.path("f_0.svg"), self.path("f_1.svg")])
        self.assertIn("<svg", pictures[1]._repr_svg_())

    def test_read(self):
        table = mikromakro.read(PROFILE)
        self.assertEqual(table.columns, ("r_inner", "r_outer", "r", "v_phi"))
        self.assertEqual(table["r"].tolist()[:2], [1.5, 2.5])
        with self.assertRaisesRegex(mikromakro.Error, "nowhere.csv"):
            mikromakro.read("nowhere.csv")
        program("convert", "--particles", GOOD["particles"], "--out", self.path("run.h5"))
        with self.assertRaisesRegex(mikromakro.Error, "no table"):
            mikromakro.read(self.path("run.h5"))


if __name__ == "__main__":
    unittest.main()
