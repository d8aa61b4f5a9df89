"""What of a run is opened in ParaView by tools/paraview_both.py; no ParaView is needed to know that."""

import subprocess
import sys
import unittest
from pathlib import Path

from small_runs import COLUMN, InAFolder, twinwake

TOOL = Path(__file__).resolve().parents[3] / "tools" / "paraview_both.py"
sys.path.insert(0, str(TOOL.parent))
from paraview_both import sources  # noqa: E402


class Sources(InAFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        twinwake.run({**COLUMN, "title": "column"}, "runs/column", twins=False)

    def test_the_last_moment_of_particles_is_there_unasked(self):
        found = sources("runs/column")
        self.assertEqual(list(found), ["sph"])
        self.assertTrue(Path(found["sph"]["water"]).is_file())
        self.assertIsNone(found["sph"]["hull"])

    def test_a_decomposed_case_is_opened_as_one_until_it_is_put_together(self):
        case = Path("runs/cells/fvm/case")
        for time in ("0", "0.1", "0.2"):
            (case / "processor0" / time).mkdir(parents=True)
        (case / "case.foam").touch()
        found = sources("runs/cells")
        self.assertEqual(list(found), ["fvm"])
        self.assertEqual(Path(found["fvm"]["water"]), case / "case.foam")
        self.assertTrue(found["fvm"]["decomposed"])
        (case / "0.2").mkdir()
        self.assertFalse(sources("runs/cells")["fvm"]["decomposed"])

    def test_wrong_words_are_answered_in_words(self):
        def said(*words):
            ended = subprocess.run([sys.executable, str(TOOL), *words], capture_output=True, text=True)
            self.assertNotIn("Traceback", ended.stderr)
            return ended.returncode, ended.stdout + ended.stderr

        self.assertEqual(said("--help")[0], 0)
        for words, part in ((["--time", "soon", "runs/column"], "expected seconds"), (["absent"], "no pictures"),
                            (["--sideways"], "unknown"), ([], "expected the folder of a run")):
            status, text = said(*words)
            self.assertEqual(status, 1)
            self.assertIn(part, text)


if __name__ == "__main__":
    unittest.main()
