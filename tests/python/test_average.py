# SPDX-License-Identifier: GPL-2.0-or-later
"""average() gives the table, the errors and the warnings of the program."""
import json
import math
import pathlib
import unittest
import warnings

import numpy as np

import mikromakro
from program import CELL, GOOD, Case, dumps, program


def words_of(keywords):
    """The command line of the same call, written by hand."""
    words = []
    for name, value in keywords.items():
        option = "--" + name.replace("_", "-")
        if value is True:
            words.append(option)
        elif name in ("bulk_types", "edges", "fields"):
            words += [option, ",".join(str(one) for one in value)]
        else:
            words += [option, *(str(one) for one in (value if isinstance(value, (list, tuple)) else [value]))]
    return words


class Average(Case):
    def check_same(self, keywords):
        """All digits of all numbers, and everything above the table."""
        text, _ = program("average", *words_of(keywords))
        self.assertIn("\n# column ", text)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertEqual(mikromakro.average(**keywords).to_csv(), text)

    def test_is_that_of_the_program(self):
        for keywords in [{**GOOD, "box": (-5, 5, -5, 5)},
                         {**GOOD, "grid": (-5, 5, 3, -5, 5, 2), "weight": "gauss:0.7", "height": 0.1},
                         {**GOOD, "edges": [0, 1 / 3, 2.7, 4], "bulk_types": [1], "fields": ["stress", "velocity"]},
                         {**GOOD, "rings": (0, 4, 2), "sectors": 3, "center": (1 / 3, -0.25), "threads": 1, "frames": -1},
                         {**CELL, "rings": (0.1, 0.18, 7), "kn": 352.1, "error_blocks": 0, "fields": ["all"]}]:
            with self.subTest(keywords):
                self.check_same(keywords)

    def test_several_runs(self):
        files = dumps(self.folder, 3)
        text, _ = program("average", "--particles", files["particles"], "--particles", GOOD["particles"], "--fields", "velocity",
                          "--rings", 1, 4, 3)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            result = mikromakro.average(particles=[[files["particles"]], [GOOD["particles"]]], fields="velocity", rings=(1, 4, 3))
        self.assertEqual(result.to_csv(), text)

    def test_columns_units_equations(self):
        result = mikromakro.average(**GOOD, rings=(np.float64(0), 4, np.int64(2)), height=0.1)
        self.assertEqual(result.values.shape, (2, len(result.columns)))
        self.assertEqual(result["r"].tolist(), [1, 3])
        self.assertIs(result["nu"].base, result.values)
        self.assertEqual((result.units["sigma_rr"], result.equations["nu"]), ("Pa", "Latzel2001 Eq. 3"))
        self.assertEqual(set(result.errors), {name[:-4] for name in result.columns if name.endswith("_err")})
        self.assertEqual(dict(result.header)["rings"], "0 4 2")
        self.assertEqual(result.error_report["frames"], 2)
        with self.assertRaisesRegex(KeyError, "sigma_rr"):
            result["sigma"]

    def test_errors_are_those_of_json(self):
        # v = +1, -1, ...: 2 tau is known
        files = dumps(self.folder, 64, lambda frame: [1.0, -1.0, 0.5, 2.0, -0.75][frame * frame % 5])
        keywords = {"particles": files["particles"], "fields": "velocity", "rings": (1, 4, 3)}
        result = mikromakro.average(**keywords)
        shown, _ = program("average", *words_of({**keywords, "fields": ["velocity"], "json": True, "out": self.path("t.csv")}))
        self.assertEqual(result.error_report, json.loads(shown))
        self.assertTrue(np.isfinite(result.errors["v_phi"]).all())

    def test_files_are_written(self):
        result = mikromakro.average(**GOOD, box=(-5, 5, -5, 5), out=[self.path("a.csv"), pathlib.Path(self.path("a.h5"))])
        self.assertEqual(pathlib.Path(self.path("a.csv")).read_text(encoding="utf-8"), result.to_csv())
        for name in ("a.csv", "a.h5"):
            again = mikromakro.read(self.path(name))
            self.assertEqual(again.columns, result.columns)
            self.assertEqual((again.units, again.equations, again.texts), (result.units, result.equations, result.texts))
            np.testing.assert_array_equal(again.values, result.values)
            self.assertEqual(sorted(again.header), sorted(result.header))

    def test_frame_and_dataset(self):
        result = mikromakro.average(**GOOD, grid=(-5, 5, 3, -5, 5, 2))
        frame = result.to_frame()
        self.assertEqual(frame["nu"].tolist(), result["nu"].tolist())
        self.assertEqual(frame.attrs["units"]["v_x"], "m/s")
        data = result.to_xarray()
        self.assertEqual(data["nu"].sizes, {"y": 2, "x": 3})
        for row in range(6):
            here = data["nu"].sel(x=result["x"][row], y=result["y"][row])
            self.assertEqual(float(here), result["nu"][row])
        self.assertEqual(data["v_x"].attrs["units"], "m/s")
        self.assertEqual(data["x_min"].dims, ("x",))
        rings = mikromakro.average(**GOOD, rings=(0, 4, 2), sectors=3).to_xarray()
        self.assertEqual(rings["nu"].sizes, {"r": 2, "phi": 3})

    def test_results_are_equal_to_themselves(self):
        result, other = (mikromakro.average(**GOOD, rings=(0, 4, 2)) for _ in range(2))
        self.assertTrue(result == result)
        self.assertFalse(result == other)
        self.assertEqual(len({result, other, result}), 2)

    def test_names_of_files(self):
        rings = {"rings": (0, 4, 2)}
        given = mikromakro.average(**GOOD, **rings).to_csv()
        self.assertEqual(mikromakro.average(**{name: file.encode() for name, file in GOOD.items()}, **rings).to_csv(), given)
        for name in ("--help", "--rings", b"no.h5"):
            word = "./" + name if isinstance(name, str) else name.decode()
            with self.subTest(name), self.assertRaisesRegex(mikromakro.Error, f"{word}: cannot find the file"):
                mikromakro.average(name, **rings)

    def test_files_without_a_table(self):
        with open(self.path("text.h5"), "w", encoding="utf-8") as text:
            text.write("no HDF5")
        for name, why in [("nofile.h5", "cannot find the file"), ("nofile.csv", ""), ("text.h5", "HDF5")]:
            with self.subTest(name), self.assertRaisesRegex(mikromakro.Error, name + ".*" + why):
                mikromakro.read(self.path(name))
        mikromakro.average(**GOOD, rings=(0, 4, 2), out=[self.path("a.csv"), self.path("a.h5")])
        text, binary = (mikromakro.read(self.path("a" + ending)) for ending in (".csv", ".h5"))
        self.assertEqual((text.columns, text.units, text.texts, sorted(text.header)), (binary.columns, binary.units, binary.texts, sorted(binary.header)))
        np.testing.assert_array_equal(text.values, binary.values)

    def test_errors_have_the_text_of_the_program(self):
        for keywords in [{**GOOD, "rings": (0, 1, 2.5)}, {**GOOD, "rings": (100, 101, 2)}, {**GOOD, "box": (0, 1, 0, 1), "kn": -1.0},
                         {"particles": "nowhere.dump", "box": (0, 1, 0, 1)}, {**GOOD, "rings": (0, 1)},
                         {**GOOD, "box": (0, 1, 0, 1), "height": math.nan}, {**GOOD, "edges": [1], "every": 0}]:
            with self.subTest(keywords):
                _, said = program("average", *words_of(keywords))
                with self.assertRaises(mikromakro.Error) as caught:
                    mikromakro.average(**keywords)
                self.assertEqual("mikromakro: " + str(caught.exception) + "\n", said)

    def test_warnings_are_those_of_python(self):
        keywords = {**GOOD, "box": (-5, 5, -5, 5), "frames": "0:9"}
        _, said = program("average", *words_of(keywords))
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            mikromakro.average(**keywords)
        self.assertEqual("".join(f"mikromakro: warning: {one.message}\n" for one in caught), said)
        self.assertEqual({(one.category, one.filename) for one in caught}, {(mikromakro.MikromakroWarning, __file__)})
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(mikromakro.MikromakroWarning):
                mikromakro.average(**keywords)


if __name__ == "__main__":
    unittest.main()
