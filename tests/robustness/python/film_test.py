"""A film of a small run: its frames are those of the record, and what it needs and lacks is said."""

import os
import subprocess
import sys
import unittest
from pathlib import Path

from small_runs import COLUMN, InAFolder, twinwake

import numpy as np

try:
    import matplotlib  # noqa: F401
    from PIL import Image, ImageSequence
except ImportError as e:
    print(f"skipped: {e}; films are tested where Debian's python3-matplotlib and python3-pil are installed")
    sys.exit(0)

from twinwake.film import film

# A program in ffmpeg's place, which leaves what it was asked for and how much it was given.
RECORDER = """#!/bin/sh
{ echo "$@"; wc -c; } >"$FILM_WORDS"
for last; do :; done
[ -z "$FILM_FAILS" ] || { echo "no such codec" >&2; exit 7; }
echo film >"$last"
"""


class Films(InAFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.made = twinwake.run({**COLUMN, "title": "$x_1$ \x07 of a column", "sampling": {"interval": "0.025 s"}},
                                "runs/column", twins=False)

    def refusal(self, **given):
        with self.assertRaises(twinwake.TwinwakeError) as caught:
            film(self.made, **given)
        return str(caught.exception)

    def test_each_frame_of_the_record_is_one_of_the_film(self):
        made = film("runs/column", "a.gif", seconds=1)
        with Image.open(made) as gif:
            frames = [np.asarray(f.convert("RGB"), dtype=int) for f in ImageSequence.Iterator(gif)]
        self.assertEqual(len(frames), len(self.made.records["sph"].raster().times))
        # the water is blue, falls and spreads: more of the last picture's right half is blue than of the first one's
        blue = [(f[:, :, 2] - f[:, :, 0] > 60)[:, f.shape[1] // 2:].mean() for f in (frames[0], frames[-1])]
        self.assertGreater(blue[1], 1.2 * blue[0] + 0.001)
        self.assertIn("a.gif: is there already", self.refusal(out="a.gif"))
        self.assertFalse([f for f in os.listdir(".") if ".new" in f])

    def test_the_command_makes_it(self):
        program = twinwake.find_program()
        made = subprocess.run([program, "film", "runs/column", "--out", "b.gif", "--seconds", "1"], capture_output=True,
                              text=True)
        self.assertEqual((made.returncode, made.stderr), (0, ""))
        self.assertIn("b.gif", made.stdout)
        self.assertGreater(Path("b.gif").stat().st_size, 1000)
        again = subprocess.run([program, "film", "runs/column", "--out", "b.gif"], capture_output=True, text=True)
        self.assertEqual(again.returncode, 2)
        self.assertIn("is there already", again.stderr)

    def test_ffmpeg_gets_whole_pictures_and_its_complaint_is_passed_on(self):
        Path("bin").mkdir()
        Path("bin/ffmpeg").write_text(RECORDER)
        Path("bin/ffmpeg").chmod(0o755)
        path = os.environ["PATH"]
        os.environ.update(PATH=f"{self.folder}/bin:{path}", FILM_WORDS=str(self.folder / "words"))
        try:
            film(self.made, "c.webm", seconds=2)
            words, count = Path("words").read_text().splitlines()
            size = words.split(" -s ")[1].split()[0].split("x")
            frames = len(self.made.records["sph"].raster().times)
            self.assertEqual(int(count), int(size[0]) * int(size[1]) * 3 * frames)
            self.assertIn("libvpx-vp9", words)
            os.environ["FILM_FAILS"] = "1"
            self.assertIn("status 7: no such codec", self.refusal(out="d.mp4"))
        finally:
            os.environ["PATH"] = path
            os.environ.pop("FILM_FAILS", None)
        self.assertFalse([f for f in os.listdir(".") if f.startswith(("d.", ".d"))])

    def test_what_cannot_be_made_is_refused_in_words(self):
        path, os.environ["PATH"] = os.environ["PATH"], "/nowhere"
        try:
            self.assertIn("needs the program ffmpeg", self.refusal(out="e.mp4"))
        finally:
            os.environ["PATH"] = path
        self.assertIn("a film is a .mp4, .webm or .gif", self.refusal(out="e.avi"))
        self.assertIn("there is no folder", self.refusal(out="absent/e.gif"))
        self.assertIn("expected a length above 0", self.refusal(out="e.gif", seconds=0))
        self.assertFalse(list(self.folder.glob("e.*")))


if __name__ == "__main__":
    unittest.main()
