#!/usr/bin/env python3
"""Makes the page of the ready studies with a picture, the time and the result of each, from runs.

    tools/gallery.py RUNS [--page docs/gallery.md] [--make STUDY ... [--budget 60s] [--twinwake build/twinwake]]

RUNS holds a folder for each study that has been run, named after its scene file, as `twinwake run studies/STUDY.toml
--out RUNS/STUDY` leaves it; --make runs those studies first, at the finest size that fits the budget, without the
coarser members of the grid triplet. The page lists every study of studies/: those without a run in RUNS as not run.
Pictures are copied into the folder `gallery` beside the page. Exit status: 0; 1: a run failed; 2: wrong usage.
"""
import argparse
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys

checkout = pathlib.Path(__file__).resolve().parent.parent
methods = {"sph": "SPH", "fvm": "FVM"}
most_results = 3  # of a study in its row
largest_picture = 250_000  # bytes


def title_of(study):
    found = re.search(r'^title\s*=\s*"((?:[^"\\]|\\.)*)"', study.read_text(encoding="utf-8"), re.MULTILINE)
    return found.group(1) if found else study.stem


def number(value):
    return f"{value:.3g}"


def results_of(report):
    """The first judged quantities that have a value, each method's with its interval where there is one: loads, waves,
    probes and motions before splash and the extremes of the surface, which every scene has."""
    names = [source["name"] for source in report["sources"]]
    lines = []
    of_every_scene = ("splash_", "airborne_", "crest_", "trough_", "highest_", "lowest_")
    for quantity in sorted(report["quantities"], key=lambda q: q["name"].startswith(of_every_scene)):
        values = quantity.get("values") or []
        intervals = quantity.get("intervals") or [None] * len(values)
        told = [f"{methods.get(name, name)} {number(value)}{'' if interval is None else ' ± ' + number(interval)}"
                for name, value, interval in zip(names, values, intervals) if value is not None and math.isfinite(value)]
        if told and quantity.get("judged", True):
            lines.append(f"{quantity['label']}: {', '.join(told)} {quantity['unit']}".rstrip(" -"))
    return lines[:most_results]


def costs_of(report):
    lines = []
    for cost in report["cost"]:
        name = methods.get(cost["source"], cost["source"])
        seconds = cost["wall"]
        text = f"{seconds:.0f} s" if seconds < 120 else f"{seconds / 60:.0f} min"
        lines.append(f"{name} {text}, {number(cost['elements'])} {'particles' if cost['source'] == 'sph' else 'cells'}")
    return lines


def command_of(report):
    words = report["sources"][0]["attributes"].get("command", "").split("\n")
    return "`twinwake " + " ".join(w for w in words if w) + "`" if words[0] else ""


def picture_of(run, to):
    """The water as particles or cells show it, else a drawn figure; its name in the folder of pictures."""
    for pattern in ("free_surface_*.png", "elevation_map_*.svg", "cut_y_*.svg", "body_*.svg", "probe*.svg", "*.svg"):
        for file in sorted((run / "figures").glob(pattern)):
            if file.stat().st_size <= largest_picture:
                to.mkdir(parents=True, exist_ok=True)
                name = run.name + file.suffix
                shutil.copyfile(file, to / name)
                return name
    return None


def make(program, study, out, budget):
    words = [str(program), "run", str(study), "--no-twins", "--budget", budget, "--threads", "1", "--out", str(out)]
    words.append("--resume" if out.exists() else "--quiet")
    print(" ".join(words), flush=True)
    return subprocess.run(words, stdout=subprocess.DEVNULL, check=False).returncode


def row(study, runs, pictures, page):
    report_file = runs / study.stem / "report.json"
    link = f"`{study.stem}`"
    if not report_file.is_file():
        return f"| {link} | {title_of(study)} | | not run for this page | |"
    report = json.loads(report_file.read_text(encoding="utf-8"))
    picture = picture_of(runs / study.stem, pictures)
    unfinished = [s["name"] for s in report["sources"] if s["state"] != "finished"]
    results = results_of(report) or ["no value that the record is long or fine enough for"]
    if unfinished:
        results.append("not finished: " + ", ".join(methods.get(n, n) for n in unfinished))
    shown = f"![{study.stem}]({pictures.relative_to(page.parent).as_posix()}/{picture})" if picture else ""
    return f"| {link} | {title_of(study)} | {shown} | {'<br>'.join([*costs_of(report), command_of(report)])} | {'<br>'.join(results)} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("runs", type=pathlib.Path, help="folder with a run of each study")
    parser.add_argument("--page", type=pathlib.Path, default=checkout / "docs/gallery.md")
    parser.add_argument("--make", nargs="+", default=[], metavar="STUDY", help="run these first")
    parser.add_argument("--budget", default="60s", help="predicted time of each of them")
    parser.add_argument("--twinwake", type=pathlib.Path, default=checkout / "build/twinwake")
    asked = parser.parse_args()
    studies = sorted((checkout / "studies").glob("*.toml"))
    known = {study.stem for study in studies}
    if unknown := sorted(set(asked.make) - known):
        parser.error(f"no such study: {', '.join(unknown)}; there are: {', '.join(sorted(known))}")
    failed = [name for name in asked.make
              if make(asked.twinwake, checkout / "studies" / f"{name}.toml", asked.runs / name, asked.budget) not in (0, 4)]
    if not asked.runs.is_dir():
        parser.error(f"{asked.runs}: there is no such folder; --make STUDY runs one into it")
    pictures = asked.page.resolve().parent / "gallery"
    rows = [row(study, asked.runs, pictures, asked.page.resolve()) for study in studies]
    made = sum("not run for this page" not in r for r in rows)
    text = f"""# Gallery of the ready studies

Made by `tools/gallery.py RUNS` from runs of {made} of the {len(studies)} studies on one machine, each by the command
in its row and some coarser than the scene's own size, mostly beside other work, so that the wall times are upper bounds.
Of a study that was also run at coarser sizes, ± is the 95 % interval of the report; of others it holds statistics alone.
The pages linked in [studies](../studies/README.md) judge the results. "Not run for this page" does not mean never run:
that table says which studies never were.

| study | title | picture | wall time, size, command | results |
|---|---|---|---|---|
"""
    asked.page.parent.mkdir(parents=True, exist_ok=True)
    asked.page.write_text(text + "\n".join(rows) + "\n", encoding="utf-8")
    print(f"{asked.page}: {made} of {len(studies)} studies")
    if failed:
        print("failed: " + ", ".join(failed), file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
