# SPDX-License-Identifier: GPL-2.0-or-later
"""docs/manual/python.md gives what it shows; the examples run."""
import contextlib
import io
import os
import re
import runpy
import shutil
import tempfile
import unittest
import warnings

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BIN = os.path.dirname(os.environ["MIKROMAKRO"])


class Pages(unittest.TestCase):
    def setUp(self):
        self.addCleanup(os.chdir, os.getcwd())
        warnings.simplefilter("ignore")

    def test_manual(self):
        os.chdir(TOP)
        with open("docs/manual/python.md", encoding="utf-8") as page:
            blocks = re.findall(r"^```(\w*)\n(.*?)^```$", page.read(), re.MULTILINE | re.DOTALL)
        names, shown = {}, 0
        for (kind, code), (after, expected) in zip(blocks, [*blocks[1:], ("end", "")]):
            if kind != "python":
                continue
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                exec(compile(code, "python.md", "exec"), names)
            if after == "":
                self.assertEqual(printed.getvalue(), expected, code)
                shown += 1
        self.assertGreater(shown, 5)

    def test_examples(self):
        if not os.path.exists(os.path.join(BIN, "liggghts-disc")):
            self.skipTest("no liggghts-disc")
        # in a folder of its own that looks like the top folder
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        for name in ("docs", "inputs"):
            os.symlink(os.path.join(TOP, name), os.path.join(folder, name))
        os.makedirs(os.path.join(folder, "build"))
        os.symlink(BIN, os.path.join(folder, "build", "bin"))
        os.chdir(folder)
        for example in ("shear_profile", "own_field"):
            with contextlib.redirect_stdout(io.StringIO()):
                runpy.run_path(f"docs/examples/{example}.py", run_name="__main__")
            self.assertGreater(os.path.getsize(f"out/python/{example}.png"), 10000)
            self.assertTrue(os.path.exists(f"docs/examples/{example}.png"))


if __name__ == "__main__":
    unittest.main()
