# SPDX-License-Identifier: GPL-2.0-or-later
"""Every option of the program is a keyword: in the call, in its signature, in help() and in the type hints."""
import ast
import inspect
import os
import re
import unittest

import mikromakro
from mikromakro._keywords import NOT_IN_PYTHON
from program import Case, program

VERBS = ("average", "audit", "fit", "draw")


def options(verb):
    return set(re.findall(r"^ +--([a-z][a-z-]*)", program(verb, "--help")[0], re.MULTILINE)) - {"help"}


class Options(Case):
    def test_each_is_a_keyword(self):
        with open(os.path.join(os.path.dirname(mikromakro.__file__), "__init__.pyi"), encoding="utf-8") as stub:
            hints = {one.name: one for one in ast.parse(stub.read()).body if isinstance(one, ast.FunctionDef)}
        for verb in VERBS:
            function = getattr(mikromakro, verb)
            hinted = {argument.arg for argument in hints[verb].args.kwonlyargs}
            found = options(verb)
            self.assertGreater(len(found), 5, verb)
            for option in found:
                keyword = option.replace("-", "_")
                if keyword in NOT_IN_PYTHON:
                    with self.assertRaisesRegex(TypeError, keyword):
                        function("x", **{keyword: True})
                    continue
                with self.subTest(verb=verb, option=option):
                    self.assertIn(keyword, inspect.signature(function).parameters)
                    self.assertIn(f"\n    {keyword}: ", function.__doc__)
                    self.assertIn(keyword, hinted)
            self.assertEqual(hinted, {name for name, one in inspect.signature(function).parameters.items()
                                      if one.kind is inspect.Parameter.KEYWORD_ONLY}, verb)

    def test_frames_have_those_of_the_input(self):
        # --frames of `average` is no keyword of its own function only by name
        of_frames = {name for name in inspect.signature(mikromakro.frames).parameters if name != "input"}
        self.assertLess(of_frames, {option.replace("-", "_") for option in options("average")})
        self.assertLess({"particles", "contacts", "frames", "steps", "contact_columns"}, of_frames)

    def test_all_that_is_exported_is_hinted(self):
        with open(os.path.join(os.path.dirname(mikromakro.__file__), "__init__.pyi"), encoding="utf-8") as stub:
            names = {one.name for one in ast.parse(stub.read()).body if isinstance(one, (ast.FunctionDef, ast.ClassDef))}
        self.assertLessEqual(set(mikromakro.__all__), names)
        for name in mikromakro.__all__:
            self.assertTrue(getattr(mikromakro, name).__doc__, name)

    def test_unknown_keywords_and_wrong_types(self):
        for keywords, text in [({"ring": (0, 1, 2)}, "ring.*rings"), ({"rings": True}, "rings"), ({"per_frame": 1}, "per_frame"),
                               ({"height": (1, 2)}, "height"), ({"bulk_types": []}, "bulk_types")]:
            with self.subTest(keywords), self.assertRaisesRegex(TypeError, text):
                mikromakro.average("x.h5", **keywords)


if __name__ == "__main__":
    unittest.main()
