"""The gallery of the studies: made from a run, it has the picture, the cost and the results of it; the page in docs is whole."""

import json
import re
import subprocess
import sys
import unittest
from pathlib import Path

try:
    import tomllib

    import matplotlib  # noqa: F401
    from PIL import Image
except ImportError as e:
    print(f"skipped: {e}; the gallery is tested with Python 3.11 and Debian's python3-matplotlib and python3-pil")
    sys.exit(0)

from small_runs import InAFolder, twinwake

import numpy as np

ROOT = Path(__file__).resolve().parents[3]
STUDIES = sorted(p.stem for p in (ROOT / "studies").glob("*.toml"))


def gallery(*words):
    made = subprocess.run([sys.executable, "-B", ROOT / "tools/gallery.py", *words], capture_output=True, text=True)
    return made.returncode, made.stdout + made.stderr


def rows_of(page):
    """The cells of each study's row."""
    rows = re.findall(r"^\| `(\w+)` \| (.*) \|$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {study: [cell.strip() for cell in rest.split("|")] for study, rest in rows}


class Gallery(InAFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        words = ["run", ROOT / "studies/cup.toml", "--method", "sph", "--scale", "2", "--no-twins", "--out", "runs/cup"]
        subprocess.run([twinwake.find_program(), *words], check=True, capture_output=True)

    def test_a_run_has_its_row_and_its_picture(self):
        self.assertEqual(gallery("runs", "--page", "docs/gallery.md"), (0, f"docs/gallery.md: 1 of {len(STUDIES)} studies\n"))
        rows = rows_of(Path("docs/gallery.md"))
        self.assertEqual(sorted(rows), STUDIES)
        title, picture, cost, results = rows["cup"]
        self.assertIn("a column of 2 cm falls over", title)
        self.assertEqual(picture, "![cup](gallery/cup.png)")
        self.assertRegex(cost, r"^SPH [\d.]+ s, \d+ particles<br>`twinwake run studies/cup.toml .*--scale 2")
        arrival = float(re.search(r"Arrival at the far wall: SPH ([\d.]+)", results)[1])
        known = next(q for q in json.loads(Path("runs/cup/report.json").read_text(encoding="utf-8"))["quantities"]
                     if q["name"] == "height_arrival:right")
        self.assertAlmostEqual(arrival, known["values"][0], delta=6e-4)
        with Image.open("docs/gallery/cup.png") as image:
            seen = np.asarray(image.convert("RGB"), dtype=int)
        self.assertGreater((seen[:, :, 2] - seen[:, :, 0] > 60).mean(), 0.03)  # of it is water

    def test_what_a_run_lacks_is_said(self):
        record = Path("runs/cup/report.json")
        whole = record.read_text(encoding="utf-8")
        record.write_text(whole.replace("height_arrival:right", "height_departure:right"), encoding="utf-8")
        try:
            status, said = gallery("runs", "--page", "other/gallery.md")
        finally:
            record.write_text(whole, encoding="utf-8")
        self.assertEqual(status, 1)
        self.assertIn("gallery.toml, [cup]: there is no quantity height_arrival:right in the report", said)

    def test_an_unknown_study_is_refused(self):
        status, said = gallery("runs", "--make", "cups")
        self.assertEqual(status, 2)
        self.assertIn("no such study: cups", said)

    def test_the_page_in_docs_has_every_study_and_no_picture_too_many(self):
        rows = rows_of(ROOT / "docs/gallery.md")
        self.assertEqual(sorted(rows), STUDIES)
        shown = {p for cells in rows.values() for p in re.findall(r"\(gallery/([^)]+)\)", cells[1])}
        self.assertEqual(shown, {p.name for p in (ROOT / "docs/gallery").iterdir()})
        wanted = tomllib.loads((ROOT / "tools/gallery.toml").read_text(encoding="utf-8"))
        self.assertEqual({s for s, cells in rows.items() if not cells[1]}, {s for s, w in wanted.items() if "not_run" in w})


if __name__ == "__main__":
    unittest.main()
