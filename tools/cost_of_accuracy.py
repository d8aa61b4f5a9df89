#!/usr/bin/env python3
"""What an interval costs: a table and a figure of each case, from the records of its runs at several sizes.

    tools/cost_of_accuracy.py CASES [--into PAGE] [--pictures docs/images] [--twinwake build/twinwake]

CASES is a TOML file:

    [[case]]
    name      = "demo"                           # of the section of PAGE and of the figure
    title     = "Demo: Fridsma's hull"
    quantity  = "lift"                           # of report.json
    goal      = 6                                # per cent; may be left out
    length    = "b"                              # what `over` is
    over      = 0.2286                           # [m]: sizes are written as b/14.1
    folders   = ["runs/demo"]                    # all finished records below them count, wider boxes left out

For every three neighbouring sizes of a method `twinwake compare --ladder` says how far the finest value may be off
(scatter of its mean and discretisation error, 95 %; not what the box adds). Its price is the processor time of the three
runs, everything counted. The interval is given in per cent of the method's value at its finest size. With --into the
sections replace what is in PAGE between `<!-- cost: NAME -->` and `<!-- /cost -->`. Needs Python 3.11 and h5py. Exit
status: 0; 2: wrong usage.
"""
import argparse
import html
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import tomllib

checkout = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(checkout / "python"))
import twinwake  # noqa: E402
from run_pages import is_member_of_another_kind, methods, put_between  # noqa: E402

least_slope = 0.1  # of a line that is worth drawing on
colours = {"sph": "#0072b2", "fvm": "#d55e00"}


def runs_of(case):
    """By method: (size [m], record, processor time [s], machine), coarsest first; of two of one size the first found."""
    found = {}
    for folder in case["folders"]:
        for path in sorted(pathlib.Path(folder).rglob("record.h5")):
            if is_member_of_another_kind(path):
                continue
            with twinwake.Record(path, verify=False) as record:
                if record.state != "finished":
                    continue
                size = record.numbers["near_hull"]
                of_method = found.setdefault(record.method, {})
                if not any(abs(size / other - 1) < 0.01 for other in of_method):
                    of_method[size] = (size, path, record.cost.cpu, record.attributes.get("machine", "unknown"))
    return {method: sorted(sizes.values(), reverse=True) for method, sizes in found.items()}


def interval(program, paths, quantity):
    """Finest value, half width of its interval [unit] and the unit; None where there is none."""
    with tempfile.TemporaryDirectory() as out:
        ended = subprocess.run([str(program), "compare", "--ladder", "--force", "--quiet", *map(str, paths), "--out", out],
                               capture_output=True, text=True)
        result = pathlib.Path(out) / "ladder.json"
        if not result.exists():
            sys.exit(f"twinwake compare --ladder {' '.join(map(str, paths))}: {ended.stderr.strip()}")
        for q in json.loads(result.read_text(encoding="utf-8"))["quantities"]:
            if q["name"] == quantity and q["values"] and q["values"][0]["levels"]:
                v = q["values"][0]
                if len(v["levels"]) == 3 and v["resolution"] is not None and v["statistical"] is not None:
                    return v["levels"][0]["value"], math.hypot(v["resolution"], v["statistical"]), q["unit"]
    return None


def points_of(program, case):
    """By method: a dict of each triplet, coarsest first."""
    points, machines = {}, set()
    for method, runs in runs_of(case).items():
        for first in range(len(runs) - 2):
            three = runs[first:first + 3]
            machines |= {run[3] for run in three}
            found = interval(program, [run[1] for run in three], case["quantity"])
            points.setdefault(method, []).append({
                "sizes": [run[0] for run in three], "seconds": sum(run[2] for run in three),
                "value": found and found[0], "half_width": found and found[1], "unit": found[2] if found else ""})
    for of_method in points.values():
        finest = next((abs(p["value"]) for p in reversed(of_method) if p["value"]), None)
        for p in of_method:
            p["per_cent"] = 100 * p["half_width"] / finest if p["half_width"] and finest else None
    return points, machines


def size_text(size, case):
    return f"{case['length']}/{case['over'] / size:.3g}" if "over" in case else f"{1000 * size:.3g} mm"


def table(points, case):
    lines = ["| method | three sizes | processor time [s] | finest value | half width | per cent |", "|---|---|---|---|---|---|"]
    for method in sorted(points, reverse=True):
        for p in points[method]:
            sizes = ", ".join(size_text(s, case) for s in p["sizes"])
            told = ("no interval", "–", "–") if p["per_cent"] is None else (
                f"{p['value']:.4g} {p['unit']}", f"{p['half_width']:.2g} {p['unit']}", f"{p['per_cent']:.2g} %")
            lines.append(f"| {methods.get(method, method)} | {sizes} | {p['seconds']:.3g} | " + " | ".join(told) + " |")
    return lines


def two_digits(number):
    rounded = float(f"{number:.2g}")
    return f"{rounded:.0f}" if rounded >= 10 else f"{rounded:g}"


def halving(points):
    """For each method with two triplets or more: the line through them in logarithms, in words."""
    lines = []
    for method in sorted(points, reverse=True):
        known = [(math.log(p["seconds"]), math.log(p["per_cent"])) for p in points[method] if p["per_cent"]]
        if len(known) < 2:
            continue
        t, u = (sum(c) / len(known) for c in zip(*known))
        slope = sum((a - t) * (b - u) for a, b in known) / sum((a - t) ** 2 for a, b in known)
        name = methods.get(method, method)
        if slope > -least_slope:
            lines.append(f"- {name}: more time has hardly narrowed the interval (power {-slope:.2f} of the time).")
        else:
            at = ", ".join(f"± {share:g} % at {two_digits(math.exp(t + (math.log(share) - u) / slope))} s"
                           for share in (5, 2, 1))
            text = f"- {name}: the interval falls with the power {-slope:.2f} of the time; extrapolated: {at}."
            lines += textwrap.wrap(text, 120, subsequent_indent="  ", break_on_hyphens=False)
    return lines


def ticks(low, high):
    return [m * 10.0 ** e for e in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
            for m in (1, 2, 5) if low <= m * 10.0 ** e <= high]


def figure(points, case):
    """An SVG of half width over processor time, both axes logarithmic."""
    marks = {m: [(p["seconds"], p["per_cent"]) for p in of if p["per_cent"]] for m, of in points.items()}
    every = [mark for of in marks.values() for mark in of]
    goal = case.get("goal")
    ys = [y for _, y in every] + ([goal] if goal else [])
    low_x, high_x = min(x for x, _ in every) / 1.5, max(x for x, _ in every) * 1.5
    low_y, high_y = min(ys) / 1.5, max(ys) * 1.5
    wide, high, left, top = 430, 270, 60, 28

    def x(v):
        return left + (wide - left - 12) * math.log(v / low_x) / math.log(high_x / low_x)

    def y(v):
        return high - 42 - (high - 42 - top) * math.log(v / low_y) / math.log(high_y / low_y)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}" font-family="sans-serif" font-size="11">',
           f'<rect width="{wide}" height="{high}" fill="white"/>',
           f'<text x="{left}" y="17" font-size="12">{html.escape(case["title"])}: {html.escape(case["quantity"])}</text>']
    for v in ticks(low_x, high_x):
        out.append(f'<path d="M{x(v):.1f} {top}V{high - 42}" stroke="#ddd"/>'
                   f'<text x="{x(v):.1f}" y="{high - 28}" text-anchor="middle">{v:g}</text>')
    for v in ticks(low_y, high_y):
        out.append(f'<path d="M{left} {y(v):.1f}H{wide - 12}" stroke="#ddd"/>'
                   f'<text x="{left - 5}" y="{y(v) + 4:.1f}" text-anchor="end">{v:g}</text>')
    out.append(f'<text x="{(left + wide) / 2:.0f}" y="{high - 10}" text-anchor="middle">processor time of three sizes [s]'
               f'</text><text transform="translate(14 {high / 2:.0f}) rotate(-90)" text-anchor="middle">half width of the '
               f'95 % interval [%]</text>')
    if goal:
        out.append(f'<path d="M{left} {y(goal):.1f}H{wide - 12}" stroke="#009e73" stroke-dasharray="5 4"/>'
                   f'<text x="{wide - 14}" y="{y(goal) - 4:.1f}" text-anchor="end" fill="#009e73">goal {goal:g} %</text>')
    for row, method in enumerate(m for m in ("sph", "fvm") if marks.get(m)):
        colour, of = colours[method], sorted(marks[method])
        out.append(f'<polyline fill="none" stroke="{colour}" points="' +
                   " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in of) + '"/>')
        out += [f'<circle cx="{x(a):.1f}" cy="{y(b):.1f}" r="4" fill="{colour}"/>' for a, b in of]
        out.append(f'<text x="{wide - 14}" y="{top + 14 + 15 * row}" text-anchor="end" fill="{colour}">{methods[method]}</text>')
    return "\n".join(out) + "\n</svg>\n"


def section(program, case, pictures, page):
    points, machines = points_of(program, case)
    slopes = halving(points)
    lines = table(points, case) + ([""] if slopes else []) + slopes
    if slopes:
        pictures.mkdir(parents=True, exist_ok=True)
        picture = pictures / f"cost_{case['name']}.svg"
        picture.write_text(figure(points, case), encoding="utf-8")
        shown = os.path.relpath(picture, page.parent) if page else picture
        lines += ["", f"![half width over processor time]({shown})"]
    return f"Quantity `{case['quantity']}`; runs on {', '.join(sorted(machines))}.\n\n" + "\n".join(lines) + "\n"


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("cases", type=pathlib.Path)
    words.add_argument("--into", type=pathlib.Path)
    words.add_argument("--pictures", type=pathlib.Path, default=checkout / "docs" / "images")
    words.add_argument("--twinwake", type=pathlib.Path, default=checkout / "build" / "twinwake")
    given = words.parse_args()
    with given.cases.open("rb") as file:
        cases = tomllib.load(file)["case"]
    for case in cases:
        text = section(given.twinwake.resolve(), case, given.pictures, given.into)
        if given.into:
            put_between(given.into, f"<!-- cost: {case['name']} -->", "<!-- /cost -->", text)
        else:
            print(f"## {case['title']}\n\n{text}")


if __name__ == "__main__":
    main()
