"""Small runs of the program, made once for the tests of a file; and the folder that they lie in."""

import os
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import h5py  # noqa: F401
    import numpy  # noqa: F401
except ImportError as e:
    print(f"skipped: {e}; the Python package is tested where Debian's python3-h5py and python3-numpy are installed")
    sys.exit(0)

import twinwake

HOSTILE_TITLE = 'a "column" of $(touch pwned) `touch pwned`; touch pwned \\ \t</script> \x07 größer'

# A column of water that falls in a tank, and a box afloat in another, which moves and turns.
COLUMN = {
    "title": HOSTILE_TITLE,
    "tank": {"size": [0.4, 0.2, 0.3]},
    "water_block": [{"min": [0, 0, 0], "max": [0.2, 0.2, 0.2]}],
    "resolution": {"near_hull": 0.02},
    "run": {"duration": "0.1 s", "threads": 1, "methods": ["sph"]},
    "probe": [{"pressure": [0.4, 0.1, 0.02]}],
}
FLOATING = {
    "title": "a box afloat, released askew",
    "tank": {"min": [-0.5, 0, -0.3], "max": [0.5, 0.02, 0.3]},
    "domain": {"dimensions": 2},
    "body": [{"name": "box", "shape": "box", "length": 0.3, "height": 0.1, "trim": "15 deg", "draft": "0.08 m",
              "density": 500}],
    "resolution": {"near_hull": 0.02},
    "run": {"duration": "0.2 s", "threads": 1, "methods": ["sph"]},
}
HULL = {
    "title": "planing",
    "hull": {"shape": "prismatic", "trim": "5 deg", "draft": "0.2 m", "half": True},
    "motion": {"kind": "stream", "speed": "8 m/s"},
    "resolution": {"near_hull": "0.1 m"},
    "run": {"duration": "0.02 s", "threads": 1},
}


class InAFolder(unittest.TestCase):
    """Tests that stand in a folder of their own; what runs teach of this machine's pace stays in it."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="twinwake_python_"))
        cls.before = os.getcwd()
        os.environ["XDG_CACHE_HOME"] = str(cls.folder / "cache")
        os.chdir(cls.folder)

    @classmethod
    def tearDownClass(cls):
        os.chdir(cls.before)
        shutil.rmtree(cls.folder)


__all__ = ["COLUMN", "FLOATING", "HOSTILE_TITLE", "HULL", "InAFolder", "twinwake"]
