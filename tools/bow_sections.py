#!/usr/bin/env python3
"""Compares the lift of each section of a V-bottom that planes without gravity with the similarity flow of a wedge.

    tools/bow_sections.py RUN ... [--sections 16]

RUN is the folder of a finished run of studies/prism_dry_chines.toml, of either method, or its record. Seen from a plane
that lies still in the water ahead of the hull, the bottom is a wedge that enters at the speed V = U tan(trim), to the order
of trim^2. A section that is s behind the point at which the keel meets the still water has been entering for t = s/U, so
that without gravity its lift per length is C rho V^3 t, and its spray root lies x_root V t beside the keel: C and x_root
of Dobrovol'skaya's similarity solution, tests/data/wedge_similarity_exact.csv. The last sections feel the transom, where
the pressure has to fall to that of the air.

Of several runs of one size (the same run resumed to later ends) the pressures are averaged. Prints for each method a table
of the sections: s [m], the half breadth to the root over the size of cells or particles, lift of the section over the exact
one, and the same summed from the entry on. Needs h5py. Exit status: 0; 2: wrong usage, or a record that does not fit.
"""
import argparse
import csv
import pathlib
import sys
import tomllib

import numpy as np

checkout = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(checkout / "python"))
import twinwake  # noqa: E402

rho = 1000.0


def exact(deadrise_deg):
    with open(checkout / "tests/data/wedge_similarity_exact.csv", newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if float(row["deadrise_deg"]) == deadrise_deg:
                return float(row["F_over_rhoV3t"]), float(row["x_root_over_Vt"])
    raise SystemExit(f"bow_sections.py: tests/data/wedge_similarity_exact.csv has no deadrise of {deadrise_deg:g} degrees")


def number(text, unit):
    if isinstance(text, str):
        if not text.endswith(f" {unit}"):
            raise SystemExit(f"bow_sections.py: found {text!r} in the scene, expected a number in {unit}")
        return float(text.removesuffix(f" {unit}"))
    return float(text)


def lift_of_bottom(record, entry, edges):
    """Lift [N] by the water of the bottom in the sections between `edges` [m behind the entry], of the whole hull."""
    hull = record.hull()
    corners = np.asarray(hull.points)[np.asarray(hull.triangles)]
    area = 0.5 * np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    centre = corners.mean(axis=1)
    bottom = area[:, 2] < -0.3 * np.linalg.norm(area, axis=1)
    if record.method == "fvm":  # its pressure is that of the air as well
        bottom &= np.asarray(hull.wet) > 0.1
    lift = -area[:, 2] * np.asarray(hull.pressure)
    sides = 2 if np.asarray(hull.points)[:, 1].min() > -1e-6 else 1  # a record of particles holds the half that is solved
    return sides * np.histogram(centre[bottom, 0] - entry, edges, weights=lift[bottom])[0]


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("runs", nargs="+", type=pathlib.Path)
    words.add_argument("--sections", type=int, default=16)
    words = words.parse_args()

    lifts, of = {}, {}
    for path in words.runs:
        for file in [path] if path.is_file() else sorted(path.rglob("record.h5")):
            with twinwake.Record(file) as record:
                if record.state != "finished":
                    continue
                scene = tomllib.loads(record.scene_text)
                hull = scene["hull"]
                trim = np.radians(number(hull["trim"], "deg"))
                U = number(scene["motion"]["speed"], "m/s")
                deadrise = number(hull["deadrise"], "deg")
                size = record.numbers["near_hull"]
                points = np.asarray(record.hull().points)
                keel = points[points[:, 2].argmin()]  # at the transom
                length = number(hull["draft"], "m") / np.tan(trim)
                edges = np.linspace(0, length, words.sections + 1)
                key = (record.method, round(size, 9))
                lifts.setdefault(key, []).append(lift_of_bottom(record, keel[0] - length, edges))
                of[key] = (U, trim, deadrise, edges)
    if not lifts:
        words_found = ", ".join(str(run) for run in words.runs)
        print(f"bow_sections.py: found no record in {words_found}", file=sys.stderr)
        return 2

    for (method, size), sums in sorted(lifts.items()):
        U, trim, deadrise, edges = of[method, size]
        C, x_root = exact(deadrise)
        V = U * np.tan(trim)
        right = C * rho * V**3 / U * np.diff(edges**2) / 2
        found = np.mean(sums, axis=0)
        middle = (edges[1:] + edges[:-1]) / 2
        print(f"\n{method}, {size:.4g} m, {len(sums)} moment{'s' * (len(sums) > 1)}")
        print("| s [m] | half breadth over size | lift over exact | from the entry on |\n|---|---|---|---|")
        for s, lift, expected, lifts_so_far, expected_so_far in zip(middle, found, right, np.cumsum(found), np.cumsum(right)):
            print(f"| {s:.3f} | {x_root * s * np.tan(trim) / size:.1f} | {lift / expected:.3f} | {lifts_so_far / expected_so_far:.3f} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
