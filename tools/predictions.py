#!/usr/bin/env python3
"""Compares the predicted processor time of runs, or the number of their steps, with what they took, and makes a table of it.

    tools/predictions.py FOLDER ... [--steps] [--into PAGE [--mark predictions]] [--twinwake build/twinwake] [--least SECONDS] [--surfaces studies] [--all]

Every finished record below the folders that was made by one thread counts, if it spent `--least` seconds (10). "said" is
what the program predicted when the run was made, with the pace that it had learned by then; "now" is what --twinwake
predicts of the same scene text, size and duration by its table alone (its cache is an empty folder, so that it has learned
nothing): on the machine of the table that should be 1. Records whose scene it cannot read again, or that differ from the
scene text in more than size and duration (another box, an uncertain number at its end), have no such value. Surfaces that
scenes name are looked for in `--surfaces`. The table has the scenes of which the median is not within 1.3, or with --all
every scene; the sentences below it count all. With --steps numbers of steps stand in place of seconds, which other
programs on the machine do not change. With --into the table replaces what is in PAGE between the lines `<!-- MARK
-->` and `<!-- /MARK -->`. Needs h5py. Exit status: 0; 2: wrong usage, or no record.
"""
import argparse
import collections
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

checkout = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(checkout / "python"))
import twinwake  # noqa: E402
from run_pages import is_member_of_another_kind, methods, put_between  # noqa: E402

within = 1.3


def predicted_now(program, record, folder, number):
    """A number of `check --json`, by the table; None where the scene cannot be read again."""
    scene = folder / "scene.toml"
    scene.write_text(record.scene_text, encoding="utf-8")
    words = [str(program), "check", str(scene), "--threads", "1", "--quiet", "--json", "-",
             "--scale", repr(record.numbers.get("size_scale", 1)), "--duration", repr(record.numbers["duration"])]
    ended = subprocess.run(words, capture_output=True, text=True, cwd=folder,
                           env={**os.environ, "XDG_CACHE_HOME": str(folder / "cache")})
    try:
        return json.loads(ended.stdout)["predicted"][record.method][number]
    except (json.JSONDecodeError, KeyError):
        return None


def told(ratios):
    if not ratios:
        return "–"
    median = f"{statistics.median(ratios):.2f}"
    return median if len(ratios) == 1 else f"{median} ({min(ratios):.2f} to {max(ratios):.2f})"


def is_good(ratio):
    return abs(math.log(ratio)) <= math.log(within)


def stands_out(runs):
    ratios = [r["now"] / r["spent"] for r in runs if r["now"]]
    return bool(ratios) and not is_good(statistics.median(ratios))


def row(name, method, runs):
    cells = [name, method, str(len(runs)), f"{sum(r['spent'] for r in runs):.0f}"]
    for when in ("said", "now"):
        cells.append(told([r[when] / r["spent"] for r in runs if r[when]]))
    return "| " + " | ".join(cells) + " |"


def sentence(runs, when):
    ratios = [r[when] / r["spent"] for r in runs if r[when]]
    good = sum(1 for q in ratios if is_good(q))
    worst = max((max(q, 1 / q) for q in ratios), default=float("nan"))
    return f"{good} of {len(ratios)} within {within} (worst factor {worst:.1f})"


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("folders", nargs="+", type=pathlib.Path)
    words.add_argument("--into", type=pathlib.Path)
    words.add_argument("--mark", default="predictions")
    words.add_argument("--twinwake", type=pathlib.Path, default=checkout / "build" / "twinwake")
    words.add_argument("--least", type=float, default=10)
    words.add_argument("--surfaces", type=pathlib.Path, default=checkout / "studies")
    words.add_argument("--all", action="store_true")
    words.add_argument("--steps", action="store_true")
    given = words.parse_args()
    number = "steps" if given.steps else "core_seconds"

    groups, machines = collections.defaultdict(list), set()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for surface in given.surfaces.resolve().glob("*.stl"):
            (folder / surface.name).symlink_to(surface)
        for path in sorted(p for f in given.folders for p in f.rglob("record.h5")):
            with twinwake.Record(path, verify=False) as record:
                said = record.numbers.get("predicted_" + number, record.numbers.get("predicted_seconds"))
                if record.state != "finished" or record.attributes.get("threads") != "1" or not said:
                    continue
                if record.cost.cpu < given.least:
                    continue
                now = (None if is_member_of_another_kind(path)
                       else predicted_now(given.twinwake.resolve(), record, folder, number))
                case = pathlib.Path(record.attributes.get("scene_file", "?")).stem
                groups[case, record.method].append({"spent": record.cost.steps if given.steps else record.cost.cpu, "said": said, "now": now})
                machines.add(record.attributes.get("machine", "unknown"))
    if not groups:
        sys.exit("no finished record of one thread below " + ", ".join(map(str, given.folders)))

    shown = {key: runs for key, runs in groups.items() if given.all or stands_out(runs)}
    lines = [f"Made by `tools/predictions.py{' --steps' if given.steps else ''}` from runs on {', '.join(sorted(machines))}, one thread each, of at least "
             f"{given.least:g} s of processor time;\n{len(shown)} of {len(groups)} scenes"
             + ("" if given.all else f", those whose median is not within {within}") + ":", "",
             f"| scene | method | runs | {'steps' if given.steps else 'spent [s]'} | said / spent: median (from, to) | now / spent |",
             "|---|---|---|---|---|---|"]
    lines += [row(case, methods.get(method, method), runs) for (case, method), runs in sorted(shown.items())]
    lines.append("")
    for method in sorted({m for _, m in groups}, reverse=True):
        runs = [r for (_, m), of in groups.items() if m == method for r in of]
        lines.append(f"- {methods.get(method, method)}: said {sentence(runs, 'said')}, now {sentence(runs, 'now')}.")
    text = "\n".join(lines) + "\n"
    if given.into:
        put_between(given.into, f"<!-- {given.mark} -->", f"<!-- /{given.mark} -->", text)
    else:
        print(text, end="")


if __name__ == "__main__":
    main()
