"""tools/paraview_both.py in ParaView's own Python, on a run of both methods: what it draws, and the state that it saves.

pvpython is that of TWINWAKE_PVPYTHON, of the checkout's .paraview (tools/unpack_paraview.sh) or of the search path; its
display is one in memory (Xvfb). Without OpenFOAM the run is one of particles alone.
"""

import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from small_runs import HULL, InAFolder, twinwake

import numpy as np

ROOT = Path(__file__).resolve().parents[3]
TOOL = ROOT / "tools" / "paraview_both.py"
PVPYTHON = next((p for p in (os.environ.get("TWINWAKE_PVPYTHON"), shutil.which("pvpython", path=ROOT / ".paraview/bin"),
                             shutil.which("pvpython")) if p), None)
try:
    from PIL import Image
except ImportError as e:
    print(f"skipped: {e}; pictures are looked at where Debian's python3-pil is installed")
    sys.exit(0)
if not PVPYTHON or not shutil.which("Xvfb"):
    print("skipped: the script for ParaView is run where pvpython (tools/unpack_paraview.sh .paraview) and Xvfb are")
    sys.exit(0)


class Drawn(InAFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        scene = {**HULL, "run": {"duration": "0.1 s", "threads": 1}}
        try:
            twinwake.run(scene, "runs/both", twins=False)
        except twinwake.ProgramError as e:
            if "OpenFOAM" not in str(e):
                raise
            twinwake.run(scene, "runs/both", method="sph", twins=False)
        read, write = os.pipe()
        cls.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-noreset", "-screen", "0", "1600x900x24"],
                                      pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            cls.display = ":" + number.readline().strip()

    @classmethod
    def tearDownClass(cls):
        cls.server.terminate()
        cls.server.wait()
        super().tearDownClass()

    def drawn(self, run, *words):
        """What the script says, and the pixels of its picture, one array for each view."""
        environment = {**os.environ, "DISPLAY": self.display, "LIBGL_ALWAYS_SOFTWARE": "1"}
        ended = subprocess.run([PVPYTHON, TOOL, run, "--below", "--picture", "both.png", *words], capture_output=True, text=True,
                               errors="replace", env=environment, timeout=200)
        self.assertEqual(ended.returncode, 0, ended.stdout[-3000:] + ended.stderr[-3000:])
        with Image.open("both.png") as picture:
            pixels = np.asarray(picture.convert("RGB"), dtype=int)
        Path("both.png").unlink()
        methods = [m for m in ("sph", "fvm") if Path(run, m).is_dir()]
        views = np.array_split(pixels, len(methods), axis=1)
        # without what is coloured as well: below the axes, on the right the legends
        return ended.stdout, [v[:v.shape[0] * 3 // 4, :v.shape[1] * 3 // 4] for v in views]

    @staticmethod
    def water(view):
        """Pixels of the colours of water: far bluer than red."""
        return view[view[:, :, 2] - view[:, :, 0] > 40]

    @staticmethod
    def hull(view):
        """Pixels of the colours of a pressure above zero: far redder than blue."""
        return view[view[:, :, 0] - view[:, :, 2] > 40]

    def test_water_and_pressure_of_each_method_are_drawn(self):
        said, views = self.drawn("runs/both", "--state", "both.pvsm")
        self.assertRegex(said, "1 times, the last 0.10[0-9]* s")
        for view in views:
            size = view.shape[0] * view.shape[1]
            self.assertGreater(len(self.water(view)), 0.05 * size)
            self.assertGreater(len(np.unique(self.water(view), axis=0)), 20, "the height varies")
            self.assertGreater(len(self.hull(view)), 0.0005 * size)
            self.assertGreater(len(np.unique(self.hull(view), axis=0)), 5, "the pressure varies")
        state = Path("both.pvsm").read_text(encoding="utf-8")
        for opened in ("free_surface.vtp", "hull.vtp", *(["case.foam"] if len(views) == 2 else [])):
            self.assertIn(opened, state)

    def test_what_is_not_there_is_not_drawn(self):
        shutil.copytree("runs/both", "runs/bare")
        Path("runs/bare/sph/snapshots/hull.vtp.series").unlink()
        _, views = self.drawn("runs/bare")
        self.assertEqual(len(self.hull(views[0])), 0)
        self.assertGreater(len(self.water(views[0])), 0)


if __name__ == "__main__":
    unittest.main()
