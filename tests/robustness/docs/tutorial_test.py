#!/usr/bin/env python3
"""Runs every command of docs/tutorial.md in a folder of its own, in the order of the page, at a coarse size.

    tutorial_test.py PROGRAM [--both]        --both: with interFoam as well, some minutes

Blocks of the page that are marked `sh` hold one command a line; a block marked with a language and a file's name is
written to that file. Scenes are made coarse where the page writes them, and each command's time is printed.
Exit status: 0 every command ended with 0 (doctor: also with 2, no OpenFOAM) and left what the page says.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
COARSE = '"0.2 m"'
LEFT = ["first.toml", "runs/first/report.html", "my_hull.stl", "my_hull.html", "runs/ladder/ladder.md",
        "runs/my_hull/report.html", "runs/towing/record.h5", "runs/against_measurement/report.html",
        "runs/speeds/sweep.json", "runs/cluster/study/study.json", "my_hull.gif"]


def blocks():
    """(language, file or "", text) of each block of the page."""
    page = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")
    for kind, text in re.findall(r"^```(.*)\n((?:.*\n)*?)```$", page, re.MULTILINE):
        language, _, name = kind.partition(" ")
        yield language, name, text


def coarsened(scene, both):
    """A scene of the page with sizes and a duration of seconds."""
    scene = re.sub(r'(near_hull *= *)"[^"]*"', rf"\g<1>{COARSE}", scene)
    scene = re.sub(r"(?m)^\[run\]\n(.*\n)*", "", scene)
    return scene + '\n[run]\nduration = "0.05 s"\nthreads = 1\n' + ("" if both else 'methods = ["sph"]\n')


def coarse(words, both):
    """A command of the page with the test's sizes; --plan and --dry-run, which run nothing, stay as they are."""
    if "--plan" in words or "--dry-run" in words or words[1] not in ("run", "ladder", "sweep"):
        return words
    words = list(words)
    if "--near-hull" in words:
        words[words.index("--near-hull") + 1] = COARSE.strip('"')
    if "--budget" in words:
        words[words.index("--budget") + 1] = "1 min" if both else "2 s"
    return words


def main():
    program, both = os.path.abspath(sys.argv[1]), "--both" in sys.argv
    folder = Path(tempfile.mkdtemp(prefix="twinwake_tutorial_"))
    os.chdir(folder)
    os.environ["XDG_CACHE_HOME"] = str(folder / "cache")
    Path("bin").mkdir()
    Path("bin/sbatch").write_text("#!/bin/sh\nexit 0\n", encoding="utf-8")  # a Slurm that takes every job
    Path("bin/sbatch").chmod(0o755)
    os.environ["PATH"] = f"{folder}/bin:{os.environ['PATH']}"
    shutil.copy(ROOT / "docs" / "examples" / "tender.step", folder)
    failed = []
    for language, name, text in blocks():
        if name:
            Path(name).write_text(coarsened(text, both) if "[resolution]" in text else text, encoding="utf-8")
        if language != "sh":
            continue
        for line in text.splitlines():
            words = coarse(shlex.split(line, comments=True), both)
            if not words:
                continue
            started = time.monotonic()
            words[0] = program
            ended = subprocess.run(words, capture_output=True, text=True, errors="replace", check=False)
            print(f"{time.monotonic() - started:6.1f} s  {line}", flush=True)
            said = ended.stdout[-1500:] + ended.stderr[-1500:]
            no_plots = words[1] == "film" and ended.returncode == 2 and "matplotlib" in ended.stderr
            if no_plots:
                LEFT.remove("my_hull.gif")
            if ended.returncode != 0 and not (words[1] == "doctor" and ended.returncode == 2) and not no_plots:
                failed.append(f"{line}\nended with status {ended.returncode}: {said}")
            if words[1] == "new":
                scene = Path(words[3])
                scene.write_text(coarsened(scene.read_text(encoding="utf-8"), both), encoding="utf-8")
    failed += [f"{file} is not there" for file in LEFT if not Path(file).exists()]
    if not failed:
        shutil.rmtree(folder)
    print("\n".join(failed))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
