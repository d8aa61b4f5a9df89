"""A dictionary as the text of a scene file: what is written is what a reader of TOML finds."""

import unittest
from pathlib import Path

from small_runs import twinwake

import numpy

try:
    import tomllib
except ImportError:  # before Python 3.11
    tomllib = None


class SceneText(unittest.TestCase):
    @unittest.skipUnless(tomllib, "no tomllib before Python 3.11")
    def test_every_value_comes_back(self):
        every_character = "".join(map(chr, [*range(0x3000), 0x1F30A]))
        scene = {
            "title": every_character, "number": 1e-300, "whole": -(2**63), "flag": False, "list": [1, 2.5, [3, 4]],
            "section": {"deeper": {"text": 'end = """\'\'\' [x] # no comment', "empty": {}}, "after": True},
            "body": [{"name": "a", "law": {"kind": "sine"}}, {"name": "b"}], "none": [],
            "a key with \"quotes\" and\nlines": 3, "mixed": [{"x": 1}, 2],
        }
        self.assertEqual(tomllib.loads(twinwake.scene_text(scene)), scene)

    @unittest.skipUnless(tomllib, "no tomllib before Python 3.11")
    def test_numpy_and_paths(self):
        scene = {"size": numpy.array([1.0, 0.2]), "n": numpy.int64(3), "on": numpy.bool_(True), "file": Path("a b.stl")}
        self.assertEqual(tomllib.loads(twinwake.scene_text(scene)),
                         {"size": [1.0, 0.2], "n": 3, "on": True, "file": "a b.stl"})

    def test_what_cannot_be_written_is_named(self):
        for value in (None, float("nan"), 2**63, "\ud800", {1, 2}, b"bytes"):
            with self.assertRaises(twinwake.TwinwakeError) as caught:
                twinwake.scene_text({"run": {"duration": value}})
            self.assertIn("run.duration", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
