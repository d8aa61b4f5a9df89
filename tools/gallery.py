#!/usr/bin/env python3
"""Makes the page of the ready studies with a picture, the time and the result of each, from runs.

    tools/gallery.py RUNS [--page docs/gallery.md] [--make STUDY ... [--budget 60s] [--twinwake build/twinwake]]

RUNS holds a folder for each study that has been run, named after its scene file, as `twinwake run studies/STUDY.toml
--out RUNS/STUDY` leaves it; --make runs those studies first, at the finest size that fits the budget, without the
coarser members of the grid triplet. gallery.toml beside this file says what is shown of each study; the page lists every
study of studies/, those without a run in RUNS with the reason given there. Pictures are written into the folder `gallery`
beside the page. Needs numpy, h5py and matplotlib, for elastic bodies vtk (Debian: python3-h5py python3-matplotlib
python3-vtk9). Exit status: 0; 1: a run failed, or what gallery.toml asks for is not in a run; 2: wrong usage.
"""
import argparse
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

from run_pages import methods

checkout = pathlib.Path(__file__).resolve().parent.parent


class Missing(Exception):
    """What gallery.toml asks for and a run does not have."""


def title_of(study):
    found = re.search(r'^title\s*=\s*"((?:[^"\\]|\\.)*)"', study.read_text(encoding="utf-8"), re.MULTILINE)
    return found.group(1) if found else study.stem


def number(value, digits=3):
    """Rounded to so many digits; without an exponent where that is readable."""
    value = float(f"{value:.{digits}g}")
    if value == 0 or not 1e-3 <= abs(value) < 1e7:
        return f"{value:.{digits}g}"
    return f"{value:.{max(digits - 1 - math.floor(math.log10(abs(value))), 0)}f}"


def told(values, intervals, unresolved, unit):
    """Each method's value, with its interval where there is one; empty where no method has a value."""
    parts = []
    for (name, value), interval, why in zip(values, intervals, unresolved):
        label = methods.get(name, name)
        if why:
            parts.append(f"{label} not resolved at this size")
        elif value is not None and math.isfinite(value):
            width = f" ± {number(interval, 2)}" if interval and math.isfinite(interval) else ""
            parts.append(f"{label} {number(value)}{width} {unit}".removesuffix(" -"))
    return ", ".join(parts)


def read_off(arrays, wanted):
    """A number of a history: its mean, largest, smallest value or their range from `from` to `to`, or its value `at` a
    time."""
    time, values = arrays["time"], arrays[wanted["column"]] * wanted.get("factor", 1) + wanted.get("offset", 0)
    if wanted["kind"] == "at":
        place = int(abs(time - wanted["at"]).argmin())
        return float(values[place]) if time[0] <= wanted["at"] <= time[-1] * 1.01 else None
    inside = (time >= wanted.get("from", 0)) & (time <= wanted.get("to", math.inf)) & (values == values)
    if not inside.any():
        return None
    if wanted["kind"] == "mean":
        times, seen = time[inside], values[inside]
        steps = times[1:] - times[:-1]
        return float((steps * (seen[1:] + seen[:-1]) / 2).sum() / steps.sum())
    low, high = float(values[inside].min()), float(values[inside].max())
    return {"largest": high, "smallest": low, "range": high - low}[wanted["kind"]]


def result(wanted, report, records):
    """One line of the last column."""
    if "quantity" in wanted:
        found = [q for q in report["quantities"] if q["name"] == wanted["quantity"]]
        if not found:
            raise Missing(f"there is no quantity {wanted['quantity']} in the report")
        quantity = found[0]
        names = [source["name"] for source in report["sources"]]
        values = quantity.get("values") or [None] * len(names)
        label, unit = wanted.get("label", quantity["label"]), quantity["unit"]
        unresolved = [source["not_resolved"] for source in quantity["sources"]]
        text = told(zip(names, values), quantity.get("intervals") or [None] * len(names), unresolved, unit)
    else:
        label, unit = wanted["label"], wanted["unit"]
        values = [(m, read_off(r.arrays(wanted["table"]), wanted)) for m, r in records.items()
                  if wanted["table"] in r.tables and wanted["column"] in r.arrays(wanted["table"])]
        if not values:
            raise Missing(f"no record has {wanted['table']}, {wanted['column']}")
        text = told(values, [None] * len(values), [""] * len(values), unit)
    if not text:
        raise Missing(f"{label} has no value")
    return f"{label}: {text}" + (f"; {wanted['beside']}" if "beside" in wanted else "")


def costs_of(report):
    lines = []
    for cost in report["cost"]:
        seconds = cost["cpu"]
        time = f"{number(seconds)} s" if seconds < 120 else f"{seconds / 60:.0f} min"
        lines.append(f"{methods.get(cost['source'], cost['source'])} {time}, {cost['elements']:.0f} "
                     f"{'particles' if cost['source'] == 'sph' else 'cells'}")
    return lines


def command_of(report, study):
    """As typed, without what says only where results go and how loud the run is."""
    words = [w for w in report["sources"][0]["attributes"].get("command", "").split("\n") if w]
    if not words:
        return ""
    words = [f"studies/{study}.toml" if w.endswith(f"{study}.toml") else w for w in words]
    return f"`twinwake {' '.join(words)}`"


def loops_of(segments):
    """Closed lines from the segments in which a surface cuts a plane, by their common ends."""
    def key(point):
        return tuple(round(float(c), 7) for c in point)

    at = {}
    for k, (a, b) in enumerate(segments):
        at.setdefault(key(a), []).append(k)
        at.setdefault(key(b), []).append(k)
    used, loops = set(), []
    for first in range(len(segments)):
        if first in used:
            continue
        used.add(first)
        loop = [segments[first][0], segments[first][1]]
        while True:
            beside = [k for k in at[key(loop[-1])] if k not in used]
            if not beside:
                break
            used.add(beside[0])
            a, b = segments[beside[0]]
            loop.append(b if key(a) == key(loop[-1]) else a)
        loops.append(loop)
    return loops


def elastic_cuts(folder, time, plane):
    """Cuts of the bodies that bend, which the record does not hold, from the ParaView files nearest to the time; and
    the time of these."""
    from twinwake.film import cut_of
    import numpy

    cuts, when = [], None
    for series in sorted((folder / "snapshots").glob("body_*.vtp.series")):
        files = json.loads(series.read_text(encoding="utf-8"))["files"]
        nearest = min(files, key=lambda f: abs(f["time"] - time))
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(series.parent / nearest["name"]))
        reader.Update()
        surface = reader.GetOutput()
        corners = vtk_to_numpy(surface.GetPoints().GetData())[
            vtk_to_numpy(surface.GetPolys().GetData()).reshape(-1, 4)[:, 1:]]
        cuts.append(cut_of(numpy.asarray(corners, dtype=float), plane))
        when = nearest["time"]
    return (numpy.concatenate(cuts) if cuts else None), when


def draw(run, records, shown, file):
    """The water of each method in the plane y = 0 (the middle of a tank) with the cut of the solids, at one time."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
    from matplotlib.colors import LinearSegmentedColormap
    from matplotlib.patches import Polygon
    from twinwake.film import Side

    sides = {method: Side(record) for method, record in records.items() if record.has_raster}
    if not sides:
        raise Missing("no record has frames of its water")
    first = next(iter(sides.values()))
    time = shown.get("at", 0.5 * float(first.raster.times[-1]))
    elastic = {}
    for method, side in sides.items():
        bends = any(t.startswith("body_") and "elastic_energy" in side.record.arrays(t) for t in side.record.tables)
        if bends:
            elastic[method], time = elastic_cuts(run / method, time, float(side.raster.y[side.row]))
    r = first.raster
    box = [float(r.x[0] - r.spacing / 2), float(r.x[-1] + r.spacing / 2),
           float(r.z[0] - r.spacing / 2), float(r.z[-1] + r.spacing / 2)]
    box = [float(v) for v in shown.get("box", box)]
    ratio = (box[1] - box[0]) / (box[3] - box[2])
    beside = len(sides) > 1 and ratio < 2
    rows, columns = (1, len(sides)) if beside else (len(sides), 1)
    width = 7.2
    height = min(max(width / columns / ratio, 0.9), 4.2) * rows + 0.55 * rows
    figure, axes = pyplot.subplots(rows, columns, figsize=(width, height), dpi=100, squeeze=False, layout="constrained")
    water_colours = LinearSegmentedColormap.from_list("water", ["#ffffff", "#2a78b5"])
    for panel, (method, side) in zip(axes.ravel(), sides.items()):
        s = side.raster
        water, at = side.water(s.times[abs(s.times - time).argmin()])
        edges = [s.x[0] - s.spacing / 2, s.x[-1] + s.spacing / 2, s.z[0] - s.spacing / 2, s.z[-1] + s.spacing / 2]
        panel.imshow(water[:, side.row], origin="lower", cmap=water_colours, vmin=0, vmax=0.6, extent=edges,
                     interpolation="nearest")
        segments = list(side.outline(at)) + list(elastic.get(method) if elastic.get(method) is not None else [])
        for loop in loops_of(segments):
            panel.add_patch(Polygon(loop, closed=True, facecolor="#55534f", edgecolor="#22211f", linewidth=0.8))
        panel.set(xlim=box[:2], ylim=box[2:], aspect="equal")
        panel.set_title(f"{methods.get(method, method)}, t = {number(at)} s", fontsize=9)
        panel.tick_params(labelsize=7)
        panel.set_xlabel("x [m]", fontsize=7)
        panel.set_ylabel("z [m]", fontsize=7)
    file.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(file, metadata={"Software": None})
    pyplot.close(figure)


def picture_of(run, records, shown, file):
    """A hull in a stream as the report renders it, with the surface of the water from astern; else the cut."""
    rendered = run / "figures" / "free_surface_0.png"
    if shown.get("picture") == "rendered" and rendered.is_file():
        file.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(rendered, file)
    else:
        draw(run, records, shown, file)


def make(program, study, out, budget):
    words = [str(program), "run", str(study), "--no-twins", "--budget", budget, "--threads", "1", "--out", str(out)]
    words.append("--resume" if out.exists() else "--quiet")
    print(" ".join(words), flush=True)
    return subprocess.run(words, stdout=subprocess.DEVNULL, check=False).returncode


def row(study, shown, runs, pictures, page, open_run):
    run = runs / study.stem
    if not (run / "report.json").is_file():
        return f"| `{study.stem}` | {title_of(study)} | | | {shown.get('not_run', 'not run for this page')} |"
    report = json.loads((run / "report.json").read_text(encoding="utf-8"))
    known = dict(open_run(run).records)
    records = {m: known[m] for m in methods if m in known}
    picture = pictures / f"{study.stem}.png"
    try:
        picture_of(run, records, shown, picture)
        lines = [result(wanted, report, records) for wanted in shown["results"]]
    except Missing as e:
        raise Missing(f"gallery.toml, [{study.stem}]: {e} ({run})") from None
    unfinished = [methods.get(s["name"], s["name"]) for s in report["sources"] if s["state"] != "finished"]
    if unfinished:
        lines.append(f"not finished: {', '.join(unfinished)}")
    if checks := sorted({gate["name"] for gate in report["gates"] if not gate["pass"] and not gate["warns"]}):
        lines.append(f"checks not met at this size: {', '.join(checks)}")
    if "note" in shown:
        lines.append(shown["note"])
    return (f"| `{study.stem}` | {title_of(study)} | ![{study.stem}]({picture.relative_to(page.parent).as_posix()}) | "
            f"{'<br>'.join([*costs_of(report), command_of(report, study.stem)])} | {'<br>'.join(lines)} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("runs", type=pathlib.Path, help="folder with a run of each study")
    parser.add_argument("--page", type=pathlib.Path, default=checkout / "docs/gallery.md")
    parser.add_argument("--make", nargs="+", default=[], metavar="STUDY", help="run these first")
    parser.add_argument("--budget", default="60s", help="predicted time of each of them")
    parser.add_argument("--twinwake", type=pathlib.Path, default=checkout / "build/twinwake")
    asked = parser.parse_args()
    studies = sorted((checkout / "studies").glob("*.toml"), key=lambda s: s.stem)
    shown = tomllib.loads((checkout / "tools/gallery.toml").read_text(encoding="utf-8"))
    known = {study.stem for study in studies}
    if unknown := sorted(set(asked.make) - known):
        parser.error(f"no such study: {', '.join(unknown)}; there are: {', '.join(sorted(known))}")
    if differ := sorted(known ^ set(shown)):
        parser.error(f"tools/gallery.toml and studies/ do not list the same studies: {', '.join(differ)}")
    failed = [name for name in asked.make
              if make(asked.twinwake, checkout / "studies" / f"{name}.toml", asked.runs / name, asked.budget) not in (0, 4)]
    if not asked.runs.is_dir():
        parser.error(f"{asked.runs}: there is no such folder; --make STUDY runs one into it")
    sys.path.insert(0, str(checkout / "python"))
    from twinwake import open as open_run

    page = asked.page.resolve()
    rows, missing = [], []
    for study in studies:
        try:
            rows.append(row(study, shown[study.stem], asked.runs, page.parent / "gallery", page, open_run))
        except Missing as e:
            missing.append(str(e))
    made = sum("](gallery/" in r for r in rows)
    text = f"""# Gallery of the ready studies

Made by `tools/gallery.py RUNS` from runs of {made} of the {len(studies)} studies, each by the command in its row; many
are coarser than the scene's own size, which the command then says. The time is that of the processor. Each picture is a
cut through the middle of the water at one moment of the run, or the water's surface round a hull from astern at its
end. ± is the 95 % interval of the report: of a run at one size the scatter of the mean alone, not what the size is
worth. What was measured, or is known exactly, stands beside the values. The pages linked in
[studies](../studies/README.md) judge finer runs.

| study | title | picture | time, size, command | results |
|---|---|---|---|---|
"""
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(text + "\n".join(rows) + "\n", encoding="utf-8")
    print(f"{asked.page}: {made} of {len(studies)} studies")
    for line in missing:
        print(line, file=sys.stderr)
    if failed:
        print("failed: " + ", ".join(failed), file=sys.stderr)
    return 1 if failed or missing else 0


if __name__ == "__main__":
    sys.exit(main())
