# SPDX-License-Identifier: GPL-2.0-or-later
"""Fields written in Python."""
import os
import subprocess
import sys
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

    def test_steady_is_said_in_the_header_alone(self):
        """What the program prints goes to no file descriptor of Python."""
        code = ("import sys; sys.path.insert(0, sys.argv[1]); import program, tempfile, mikromakro, warnings; warnings.simplefilter('ignore')\n"
                "with tempfile.TemporaryDirectory() as folder:\n"
                "  files = program.dumps(folder, 200, lambda frame: (frame * frame % 7) - 3.0)\n"
                "  keywords = dict(particles=files['particles'], rings=(1, 4, 3), fields='velocity', steady='v_phi')\n"
                "  print(dict(mikromakro.average(**keywords).header)['steady'])")
        ran = subprocess.run([sys.executable, "-B", "-c", code, os.path.dirname(os.path.abspath(__file__))], capture_output=True, text=True, check=True)
        self.assertRegex(ran.stdout, "v_phi from frame")
        self.assertEqual(ran.stderr, "")

    def test_steady(self):
        """A field of one's own, and a built-in one beside it, begin where the built-in column of the same values begins."""
        noise = np.random.default_rng(5).normal(size=200)
        files = dumps(self.folder, 200, lambda frame: float(noise[frame]) + 30 * np.exp(-frame / 8))
        own = Field(lambda frame: frame.particles["vy"], "v", mean="discs")  # all discs lie on the x axis
        for threads in (1, 2):
            result = mikromakro.average(particles=files["particles"], rings=(1, 4, 3), fields=["velocity", own], steady="v_phi", threads=threads)
            begin = dict(result.header)["steady"]
            self.assertRegex(begin, "v_phi from frame [1-9]")
            mine = mikromakro.average(particles=files["particles"], rings=(1, 4, 3), fields=own, steady="v", threads=threads)
            self.assertEqual(dict(mine.header)["steady"].replace("v from", "v_phi from"), begin)
            np.testing.assert_array_equal(mine["v"], result["v"])
            np.testing.assert_allclose(mine["v"], result["v_phi"], rtol=1e-14)

    def test_columns_of_one_name(self):
        """Every column of the table has a name of its own: refused before a frame is read or a file is written."""
        box = {**GOOD, "rings": (0, 4, 2)}
        windows = {"every": 1}
        for name, keywords in [("v_phi", {}), ("nu", {}), ("r", {}), ("r_inner", {}), ("v_r_err", {}), ("effective_samples", {}),
                               ("velocity_two_tau", {}), ("step", windows), ("time", windows), ("step_last", windows)]:
            with self.subTest(name):
                called = []
                own = Field(lambda frame: called.append(1) or one(frame), name)
                with self.assertRaisesRegex(mikromakro.Error, f"--fields: two columns of one name; expected .*, got '{name}'"):
                    mikromakro.average(**box, **keywords, fields=["velocity", "solid_fraction", own], out=[self.path("k.csv"), self.path("k.h5")])
                self.assertEqual((called, [file for file in os.listdir(self.folder) if file.startswith("k")]), ([], []))
        with self.assertRaisesRegex(mikromakro.Error, "two columns of one name.*'a'"):
            mikromakro.average(**box, fields=Field(one, "q", columns=("a", "a")))
        # names that this table has no column of are free
        result = mikromakro.average(**box, fields=["velocity", Field(one, "step"), Field(one, "v_r_err", mean="discs")], error_blocks=0)
        self.assertEqual(result["v_r_err"].tolist(), [1, 1])

    def test_xarray(self):
        """A column of one's own with the name of another kind of place is no place."""
        for windows in ({}, {"every": 1}):
            result = mikromakro.average(**GOOD, rings=(0, 4, 2), fields=[Field(one, "x"), Field(one, "phi")], error_blocks=0, **windows)
            data = result.to_xarray()
            self.assertEqual(data["x"].dims, (*(["time"] if windows else []), "r"))
            self.assertEqual(data["phi"].values.ravel().tolist(), result["phi"].tolist())

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
                               box=(-5, 5, -5, 5), fields=Field(one, "q", needs=["mass"]))
        with self.assertRaisesRegex(ValueError, "letters"):
            Field(lambda frame: 1)
        with self.assertRaisesRegex(mikromakro.Error, "called by a function that it calls"):
            mikromakro.average(**box, fields=Field(lambda frame: mikromakro.average(**box)["nu"], "nested"))

    def test_kinds_of_arrays(self):
        """bool, int and float are numbers; what would lose its mask, its imaginary part or its meaning is refused."""
        box = {**GOOD, "box": (-5, 5, -5, 5), "bulk_types": [1], "error_blocks": 0}
        def mean(make):
            return mikromakro.average(**box, fields=Field(lambda frame: make(len(frame.particles)), "q", mean="discs"))["q"].tolist()
        for kind in ("?", "i1", "u8", "f2", "f4", ">f8", "g"):
            self.assertEqual(mean(lambda n, kind=kind: np.ones(n, kind)), [1], kind)
        self.assertEqual(mean(lambda n: [1] * n), [1])
        for make, got in [(lambda n: np.ma.masked_array(np.ones(n), mask=[True] * n), "the mask would be lost; .*filled"),
                          (lambda n: np.full(n, 1j), "no real numbers; .*complex128"),
                          (lambda n: np.full(n, np.datetime64("2001-01-01")), r"no real numbers; .*datetime64\[D\]"),
                          (lambda n: np.full(n, np.timedelta64(1, "s")), "no real numbers"), (lambda n: np.array(["1.5"] * n), "no real numbers; .*<U3"),
                          (lambda n: np.full(n, b"1"), "no real numbers"), (lambda n: np.array([1.5] * n, object), "no real numbers; .*object"),
                          (lambda n: None, "no real numbers")]:
            with self.subTest(got), self.assertRaisesRegex(mikromakro.Error, "q: .*" + got):
                mean(make)
        frame = next(mikromakro.frames(**GOOD))
        contacts = np.ones(len(frame.contacts))
        for wrong in (contacts * 1j, np.ma.masked_array(contacts, mask=contacts > 0)):
            with self.assertRaisesRegex(mikromakro.Error, "sum_over_contacts"):
                frame.sum_over_contacts(wrong)
            with self.assertRaisesRegex(mikromakro.Error, "sum_over_contacts"):
                frame.sum_over_contacts(contacts, wrong)

    def test_texts(self):
        self.assertEqual((Field(one, columns="ab").columns, Field(one, needs="fx").needs), (("ab",), ("fx",)))
        for text in ({"unit": "m\n1,2,3"}, {"equation": "a\r"}, {"text": "a\n"}):
            with self.subTest(text), self.assertRaisesRegex(ValueError, "is one line"):
                Field(one, **text)
        with self.assertRaisesRegex(ValueError, "unit= is without brackets, got 'm]'"):
            Field(one, unit="m]")

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
