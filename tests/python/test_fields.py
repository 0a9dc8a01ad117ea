# SPDX-License-Identifier: GPL-2.0-or-later
"""Fields written in Python."""
import unittest
import warnings

import numpy as np

import mikromakro
from mikromakro import Field
from program import CELL, GOOD, Case, dumps

RINGS = {**CELL, "rings": (0.1, 0.18, 7), "bulk_types": [1, 2]}


def one(frame):
    """One for each disc."""
    return np.ones(len(frame.particles))


def contacts(frame):
    return frame.sum_over_contacts(np.ones(len(frame.contacts)))


class Fields(Case):
    def test_are_averaged_like_ours(self):
        """1/V sum w V 1 is nu, the mean of the spin over discs is the spin, of the contacts the coordination: the same sums in the
        same order, so the same bits."""
        for weight in ("sliced", "centre", "gauss:0.004"):
            own = [Field(one, "my_nu"), Field(lambda frame: frame.particles["omegaz"], "my_spin", unit="1/s", mean="discs"),
                   Field(contacts, "my_coordination", mean="discs")]
            result = mikromakro.average(**RINGS, weight=weight, fields=["solid_fraction", "coordination", "spin", *own])
            for mine, ours in [("my_nu", "nu"), ("my_spin", "spin"), ("my_coordination", "coordination")]:
                with self.subTest(weight=weight, field=ours):
                    self.assertTrue(np.isfinite(result[mine]).any())
                    np.testing.assert_array_equal(result[mine], result[ours])
            self.assertEqual((result.units["my_spin"], result.texts["my_nu"]), ("1/s", "One for each disc."))

    def test_errors_too(self):
        files = dumps(self.folder, 64, lambda frame: [1.0, -1.0, 0.5, 2.0, -0.75][frame * frame % 5])
        own = Field(lambda frame: frame.particles["vy"], "v", mean="discs")  # all discs lie on the x axis
        for threads in (1, 2):
            result = mikromakro.average(particles=files["particles"], rings=(1, 4, 3), fields=["velocity", own], threads=threads)
            self.assertTrue(np.isfinite(result.errors["v"]).all())
            np.testing.assert_allclose(result["v"], result["v_phi"], rtol=1e-14)
            # 2 tau is pooled over the columns of a field, and that of v_r is 0: nothing fluctuates
            np.testing.assert_allclose(result.errors["v"], result.errors["v_phi"], rtol=1e-12)

    def test_windows(self):
        files = dumps(self.folder, 4, lambda frame: 1.0 + frame)
        result = mikromakro.average(particles=files["particles"], rings=(1, 4, 3), every=2, error_blocks=0,
                                    fields=Field(lambda frame: frame.particles["vy"], "v", mean="discs"))
        np.testing.assert_allclose(result["v"], [1.5] * 3 + [3.5] * 3, rtol=1e-14)

    def test_several_columns(self):
        def plane(frame):
            return np.stack([frame.particles["vx"], frame.particles["vy"]], axis=1)
        result = mikromakro.average(**GOOD, box=(-5, 5, -5, 5), bulk_types=[1], error_blocks=0,
                                    fields=["velocity", Field(plane, columns=("u_x", "u_y"), mean="discs", needs=("vx", "vy"))])
        for axis in "xy":
            np.testing.assert_array_equal(result["u_" + axis], result["v_" + axis])

    def test_only_bulk_discs_count(self):
        """Of the discs 7, 3, 20 (areas 0.25, 0.25, 0.0625 pi), not of 12, which is of type 2."""
        result = mikromakro.average(**GOOD, box=(-5, 5, -5, 5), bulk_types=[1], error_blocks=0,
                                    fields=Field(lambda frame: frame.particles["id"] * 1.0, "ids", mean="discs"))
        np.testing.assert_allclose(result["ids"], [(7 * 0.25 + 3 * 0.25 + 20 * 0.0625) / 0.5625], rtol=1e-14)

    def test_mistakes(self):
        box = {**GOOD, "box": (-5, 5, -5, 5)}
        with self.assertRaisesRegex(mikromakro.Error, r"short: .*another shape; expected \(4,\), a value for each disc, got \(3,\)"):
            mikromakro.average(**box, fields=Field(lambda frame: np.ones(3), "short"))
        with self.assertRaisesRegex(ZeroDivisionError, "division"):
            mikromakro.average(**box, fields=Field(lambda frame: 1 // 0, "zero"))
        with self.assertRaisesRegex(mikromakro.Error, "two fields of one name"):
            mikromakro.average(**box, fields=Field(one, "stress"))
        with self.assertRaisesRegex(mikromakro.Error, "no such column in needs=.*'fz_'"):
            mikromakro.average(**box, fields=Field(one, "x", needs=["fz_"]))
        with self.assertRaisesRegex(mikromakro.Error, "mass"):
            mikromakro.average(particles=GOOD["particles"], particle_columns="id,type,x,y,-,radius,vx,vy,omegaz,-".split(","),
                               box=(-5, 5, -5, 5), fields=Field(one, "x", needs=["mass"]))
        with self.assertRaisesRegex(ValueError, "letters"):
            Field(lambda frame: 1)
        with self.assertRaisesRegex(mikromakro.Error, "called by a function that it calls"):
            mikromakro.average(**box, fields=Field(lambda frame: mikromakro.average(**box)["nu"], "nested"))

    def test_views_may_be_kept(self):
        files, kept = dumps(self.folder, 9, float), {}
        def keep(frame):
            kept[frame.step] = frame.particles["vy"]
            return frame.particles["vy"]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            mikromakro.average(particles=files["particles"], rings=(1, 4, 3), fields=Field(keep, "v"), threads=2)
        self.assertEqual({step: array.tolist() for step, array in kept.items()}, {step: [float(step)] * 3 for step in range(9)})


if __name__ == "__main__":
    unittest.main()
