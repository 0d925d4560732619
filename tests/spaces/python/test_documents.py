# SPDX-License-Identifier: GPL-3.0-or-later
"""What the package says of itself: help that teaches, examples that run, types, licences."""

import doctest
import inspect
import pathlib
import pydoc
import subprocess
import sys
import unittest

import clipscope

PACKAGE = pathlib.Path(clipscope.__file__).parent


class Help(unittest.TestCase):
    def test_it_teaches(self):
        text = pydoc.plain(pydoc.render_doc(clipscope))
        for word in ("Start here", "view space", "NDC", "1/w", "ValueError", "GIL", "MIT", "clippers()"):
            self.assertIn(word.lower(), text.lower())

    def test_everything_public_says_what_it_is(self):
        for name in clipscope.__all__:
            documented = inspect.getdoc(getattr(clipscope, name))
            self.assertTrue(documented and len(documented) > 30, name)
        for name in ("clip", "clip_mesh", "stage"):
            documented = inspect.getdoc(getattr(clipscope, name))
            for word in ("shape" if name == "clip" else "(n, 3" if name == "stage" else "(v, 4", "Raises", "Returns"):
                self.assertIn(word, documented, name)

    def test_the_examples_run(self):
        for module in (clipscope, clipscope._clip, clipscope._batch):
            found = doctest.testmod(module)
            self.assertEqual(found.failed, 0)
        self.assertGreater(doctest.testmod(clipscope._clip).attempted, 2)


class Package(unittest.TestCase):
    def test_it_is_typed(self):
        self.assertTrue((PACKAGE / "py.typed").exists())
        self.assertTrue((PACKAGE / "_clipscope.pyi").exists())

    def test_the_stub_names_what_the_module_has(self):
        stub = (PACKAGE / "_clipscope.pyi").read_text()
        for name in dir(clipscope._clipscope):
            if not name.startswith("__"):
                self.assertRegex(stub, rf"\b{name}\b")

    def test_import_alone_loads_nothing_under_gpl(self):
        code = "import sys, clipscope; print([m for m in sys.modules if m.startswith('clipscope')])"
        loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
        self.assertIn("clipscope._clipscope", loaded)
        self.assertNotIn("exact", loaded)
        for path in PACKAGE.glob("*.py"):
            self.assertIn("SPDX-License-Identifier: MIT", path.read_text(), path)

    def test_a_picture_holds_every_polygon(self):
        try:
            import matplotlib
        except ImportError:
            with self.assertRaisesRegex(ImportError, "python3-matplotlib"):
                clipscope.plot(None)
            return
        matplotlib.use("Agg")
        triangles = [[[0, 0, 0, 1], [2, 0, 0, 1], [0, 2, 0, 1]], [[5, 5, 0, 1]] * 3, [[0, 0, 0, 1], [1, 0, 0, 1], [0, 1, 0, 1]]]
        ax = clipscope.plot(clipscope.clip(triangles, space="clip"))
        self.assertEqual(len(ax.patches), 1 + 2)


if __name__ == "__main__":
    unittest.main()
