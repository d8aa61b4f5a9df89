"""A film of a run: its methods side by side, from the frames that the records have.

    python3 -m twinwake.film RUN [--out FILE.mp4|.webm|.gif] [--seconds 10] [--overwrite] [--quiet]

Needs matplotlib; for MP4 and WebM the program ffmpeg, for GIF the package PIL (Debian: python3-matplotlib,
python3-pil, ffmpeg). `twinwake film RUN` calls this.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from ._errors import TwinwakeError
from ._folder import Run, open as open_run
from ._record import Raster, Record

LABELS = {"sph": "SPH", "fvm": "interFoam"}
CODECS = {".mp4": ["-c:v", "libx264", "-pix_fmt", "yuv420p", "-movflags", "+faststart"],
          ".webm": ["-c:v", "libvpx-vp9", "-b:v", "0", "-crf", "32"]}
MOST_FRAMES = 300


def film(run: Union[Run, Record, str, Path], out: Union[str, Path, None] = None, *, seconds: float = 10,
         overwrite: bool = False) -> Path:
    """Makes a film and gives its file.

    Above, the share of water in the plane y = 0 (the middle of a tank) with the cut of the hull and of the bodies;
    in the middle, in three dimensions, the height of the water from above; below, the force on the hull until the
    frame's time. A frame shows from each record the latest state that is not later than its time.

    run      a run, a record, or the folder of one
    out      the file; its ending says the kind. None: film.mp4 in the run's folder, film.gif where there is no ffmpeg
    seconds  how long the film lasts

    Throws TwinwakeError: nothing to be seen, a program or package is missing, the file is there or cannot be written.
    """
    if isinstance(run, (str, Path)):
        run = open_run(run)
    records = dict(run.records) if isinstance(run, Run) else {run.method: run}
    records = dict(sorted(records.items(), key=lambda m: list(LABELS).index(m[0]) if m[0] in LABELS else len(LABELS)))
    if out is None:
        folder = run.folder if isinstance(run, Run) else run.path.parent
        out = folder / ("film.mp4" if shutil.which("ffmpeg") else "film.gif")
    out = Path(out)
    if out.suffix.lower() not in (*CODECS, ".gif"):
        raise TwinwakeError(f"{out}: a film is a .mp4, .webm or .gif")
    if out.exists() and not overwrite:
        raise TwinwakeError(f"{out}: is there already; --overwrite replaces it, --out names another file")
    if not out.parent.is_dir():
        raise TwinwakeError(f"{out}: there is no folder {out.parent}")
    if not seconds > 0:
        raise TwinwakeError(f"seconds = {seconds}: expected a length above 0")
    picture = _Picture(records)
    times = picture.times
    pace = max(len(times) / seconds, 0.2)
    beside = out.with_name(f".{out.stem}.new{out.suffix.lower()}")
    try:
        if out.suffix.lower() == ".gif":
            _write_gif(picture, times, pace, beside)
        else:
            _write_by_ffmpeg(picture, times, pace, beside)
        os.replace(beside, out)
    except OSError as e:
        raise TwinwakeError(f"{out}: cannot be written: {e.strerror or e}") from None
    finally:
        if beside.exists():
            beside.unlink()
    return out


class Side:
    """What one method's column of the picture shows."""

    def __init__(self, record: Record) -> None:
        self.record = record
        self.raster = record.raster(in_memory=False)
        y = self.raster.y
        half = record.attributes.get("symmetry_factor", "1") not in ("", "1")
        self.row = 0 if half and y[0] >= 0 else int(np.argmin(np.abs(y - 0.5 * (y[0] + y[-1]))))
        if y[0] < 0 < y[-1]:
            self.row = int(np.argmin(np.abs(y)))
        self.flat = len(y) == 1
        hull = record.hull()
        self.bodies = record.bodies
        self.fixed = None if hull is None or "hull_motion" in self.bodies else (hull.points, hull.triangles)

    def water(self, time: float) -> Tuple[np.ndarray, float]:
        frame = max(int(np.searchsorted(self.raster.times, time * (1 + 1e-12), side="right")) - 1, 0)
        return self.raster.water(frame), float(self.raster.times[frame])

    def height(self, water: np.ndarray) -> np.ndarray:
        """The top of the highest voxel that is half full; NaN where there is none: (y, x)."""
        wet = water >= 0.5
        top = len(self.raster.z) - 1 - np.argmax(wet[::-1], axis=0)
        return np.where(wet.any(axis=0), self.raster.z[top] + 0.5 * self.raster.spacing, np.nan)

    def outline(self, time: float) -> np.ndarray:
        """Where solids cut the plane of the upper picture: (segments, 2, 2), x and z."""
        plane = float(self.raster.y[self.row])
        surfaces = [self.fixed] if self.fixed else []
        surfaces += [(b.points_at(time), b.triangles) for b in self.bodies.values()]
        cuts = [cut_of(np.asarray(points, dtype=float)[triangles], plane) for points, triangles in surfaces]
        return np.concatenate(cuts) if cuts else np.zeros((0, 2, 2))


def cut_of(corners: np.ndarray, plane: float) -> np.ndarray:
    """Segments in which triangles (n, 3, 3) cut the plane y = plane: (segments, 2, 2), x and z."""
    side = corners[:, :, 1] - plane
    side = np.where(side == 0, 1e-12, side)
    segments: List[List[np.ndarray]] = []
    for triangle, s in zip(corners, side):
        ends = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            if s[a] * s[b] < 0:
                ends.append((triangle[a] + s[a] / (s[a] - s[b]) * (triangle[b] - triangle[a]))[[0, 2]])
        if len(ends) == 2:
            segments.append(ends)
    return np.asarray(segments).reshape(-1, 2, 2)


class _Picture:
    """The figure, redrawn for each frame."""

    def __init__(self, records: Dict[str, Record]) -> None:
        try:
            import matplotlib

            matplotlib.use("Agg")
            from matplotlib import pyplot
            from matplotlib.collections import LineCollection
        except ImportError as e:
            raise TwinwakeError(f"a film needs matplotlib ({e}); Debian: sudo apt-get install python3-matplotlib "
                                f"python3-pil") from None
        self.sides = {m: Side(r) for m, r in records.items() if r.has_raster}
        if not self.sides:
            raise TwinwakeError("nothing can be seen: no record has a raster of its water")
        every = max((s.raster.times for s in self.sides.values()), key=len)
        if len(every) < 2:
            raise TwinwakeError("nothing moves: the records have one frame; [sampling] interval in the scene makes more")
        self.times = every[np.unique(np.linspace(0, len(every) - 1, min(len(every), MOST_FRAMES)).astype(int))]

        flat = all(s.flat for s in self.sides.values())
        forces = {m: r.arrays("forces") for m, r in records.items() if "forces" in r.tables and m in self.sides}
        forces = {m: f for m, f in forces.items() if len(f["time"]) > 1 and "fx" in f and "fz" in f}
        rows = [2.0] + ([] if flat else [2.0]) + ([1.2] if forces else [])
        self.figure = pyplot.figure(figsize=(12.8, 7.2 if len(rows) > 1 else 4), dpi=100)
        low, high = (0.08, 0.9) if len(rows) > 1 else (0.14, 0.84)  # room for the names of axes and methods
        grid = self.figure.add_gridspec(len(rows), len(self.sides), height_ratios=rows, hspace=0.35, wspace=0.15,
                                        left=0.06, right=0.93, top=high, bottom=low)
        limits = self._limits()
        self.parts: List[Dict[str, Any]] = []
        for k, (method, side) in enumerate(self.sides.items()):
            r = side.raster
            edges = _edges(r)
            water, _ = side.water(self.times[0])
            part: Dict[str, Any] = {"side": side}
            upper = self.figure.add_subplot(grid[0, k], title=LABELS.get(method, method), aspect="equal",
                                            xlabel="x [m]")
            part["water"] = upper.imshow(water[:, side.row], origin="lower", cmap="Blues", vmin=0, vmax=1.2,
                                         extent=(*edges[0], *edges[2]), interpolation="nearest")
            part["outline"] = upper.add_collection(LineCollection([], colors="black", linewidths=1.2))
            if k == 0:
                upper.set_ylabel("z [m]")
            if not flat:
                below = self.figure.add_subplot(grid[1, k], aspect="equal", xlabel="x [m]")
                part["height"] = below.imshow(side.height(water), origin="lower", cmap="viridis", vmin=limits[0],
                                              vmax=limits[1], extent=(*edges[0], *edges[1]), interpolation="nearest")
                if k == 0:
                    below.set_ylabel("y [m]")
                bar = self.figure.colorbar(part["height"], ax=below, fraction=0.03, pad=0.01)
                bar.set_label("height [m]" if k == len(self.sides) - 1 else "")
            self.parts.append(part)
        self.lines: List[Tuple[Any, np.ndarray, np.ndarray]] = []
        if forces:
            self._draw_forces(self.figure.add_subplot(grid[-1, :]), forces, records)

    def _limits(self) -> Tuple[float, float]:
        """Common heights of all methods, from a few frames; one splash does not take all the colours."""
        seen = [s.height(s.water(t)[0]) for s in self.sides.values() for t in self.times[:: max(len(self.times) // 6, 1)]]
        values = np.concatenate([h[np.isfinite(h)].ravel() for h in seen])
        if len(values) == 0:
            return -1.0, 1.0
        low, high = np.percentile(values, (1, 99))
        middle, reach = 0.5 * (low + high), max(0.5 * (high - low), max(s.raster.spacing for s in self.sides.values()))
        return middle - reach, middle + reach

    def _draw_forces(self, axes: Any, forces: Dict[str, Dict[str, np.ndarray]], records: Dict[str, Record]) -> None:
        unit = next(records[m].units("forces")["fx"] for m in forces)
        span = []
        for m, (method, table) in enumerate(forces.items()):
            for name, label, style in (("fx", "drag", "-"), ("fz", "lift", "--")):
                line, = axes.plot([], [], style, color=f"C{m}", label=f"{label}, {LABELS.get(method, method)}")
                self.lines.append((line, table["time"], table[name]))
                settled = table[name][np.isfinite(table[name]) & (table["time"] > 0.1 * self.times[-1])]
                span += list(np.percentile(settled, (2, 98))) if len(settled) else []
        low, high = (min(span + [0]), max(span + [0])) if span else (0.0, 1.0)
        margin = 0.15 * (high - low) or 1.0
        axes.set(xlim=(0, self.times[-1]), ylim=(low - margin, high + 3 * margin), xlabel="t [s]",
                 ylabel=f"force [{unit}]")
        axes.legend(loc="upper right", ncol=4, fontsize="small")

    def draw(self, time: float) -> np.ndarray:
        """The picture at a time: (height, width, 4) [uint8]."""
        for part in self.parts:
            side: Side = part["side"]
            water, shown = side.water(time)
            part["water"].set_data(water[:, side.row])
            part["outline"].set_segments(side.outline(shown))
            if "height" in part:
                part["height"].set_data(side.height(water))
        for line, at, values in self.lines:
            line.set_data(at[at <= time], values[at <= time])
        title = next(s.record.title for s in self.sides.values())
        title = "".join(c if c.isprintable() else " " for c in title)
        self.figure.suptitle(f"{title[:100]}    t = {time:.3f} s", parse_math=False)
        self.figure.canvas.draw()
        return np.asarray(self.figure.canvas.buffer_rgba()).copy()


def _edges(r: Raster) -> List[Tuple[float, float]]:
    return [(float(c[0] - r.spacing / 2), float(c[-1] + r.spacing / 2)) for c in (r.x, r.y, r.z)]


def _write_gif(picture: _Picture, times: Sequence[float], pace: float, file: Path) -> None:
    try:
        from PIL import Image
    except ImportError:
        raise TwinwakeError("a GIF needs the package PIL; Debian: sudo apt-get install python3-pil") from None
    images = [Image.fromarray(picture.draw(t)[:, :, :3]).quantize(128, Image.Quantize.FASTOCTREE) for t in times]
    images[0].save(file, format="GIF", save_all=True, append_images=images[1:], duration=max(round(1000 / pace), 20),
                   loop=0)


def _write_by_ffmpeg(picture: _Picture, times: Sequence[float], pace: float, file: Path) -> None:
    program = shutil.which("ffmpeg")
    if not program:
        raise TwinwakeError(f"{file.suffix} needs the program ffmpeg; Debian: sudo apt-get install ffmpeg; or take .gif")
    first = picture.draw(times[0])
    height, width = first.shape[0] // 2 * 2, first.shape[1] // 2 * 2  # the codecs take even numbers
    words = [program, "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}",
             "-framerate", f"{pace:.6g}", "-i", "-", "-r", "25", *CODECS[file.suffix], os.fspath(file)]
    with subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as child:
        assert child.stdin and child.stderr
        try:
            for t in times:
                child.stdin.write(picture.draw(t)[:height, :width, :3].tobytes())
            child.stdin.close()
        except BrokenPipeError:  # what it says below is why
            pass
        said = child.stderr.read().decode("utf-8", "replace").strip()
    if child.returncode != 0:
        raise TwinwakeError(f"ffmpeg ended with status {child.returncode}: {said or 'without a word'}")


def main(words: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(prog="twinwake film", description="A film of both methods side by side.")
    parser.add_argument("run")
    parser.add_argument("--out")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--overwrite", action="store_true")
    parser.add_argument("--quiet", action="store_true")
    given = parser.parse_args(words)
    try:
        made = film(given.run, given.out, seconds=given.seconds, overwrite=given.overwrite)
    except TwinwakeError as e:
        print(f"film: {e}", file=sys.stderr)
        return 2
    if not given.quiet:
        print(f"{made}: {made.stat().st_size / 1e6:.3g} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
