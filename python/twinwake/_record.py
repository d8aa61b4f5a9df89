"""One run record: the HDF5 file that a run of either method, or an import, leaves."""

from __future__ import annotations

import hashlib
import io
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Optional, Tuple, Union

try:
    import h5py
    import numpy as np
except ImportError as e:
    raise ImportError(f"twinwake reads records with h5py and numpy, and {e.name} is not installed for this Python; "
                      "install it, e.g. apt install python3-h5py python3-numpy") from e

from ._body import Body
from ._errors import TwinwakeError

if TYPE_CHECKING:
    import pandas

_KIND = "twinwake run record"
_FORMAT_VERSION = 1
_SIGN = b"\ntwinwake sha256 "  # and 64 digits and a line end, behind HDF5's own bytes


@dataclass(frozen=True)
class Probe:
    """A probe of the scene: pressures [Pa], heights of the water's surface [m], or volumes of water in its boxes [m3],
    at the times [s] of the frames."""

    name: str
    kind: str  #: "pressure", "height" or "volume"
    unit: str
    times: np.ndarray
    values: np.ndarray  #: NaN where the method does not know


@dataclass(frozen=True)
class Raster:
    """The share of water in cubic voxels, in the same voxels for both methods; splash is measured from it.

    A voxel (k, j, i) reaches from `origin + spacing * (i, j, k)` to one spacing beyond. Of half a model, half the
    water.
    """

    origin: np.ndarray  #: low corner [m]
    spacing: float  #: edge of a voxel [m]
    times: np.ndarray  #: of the frames [s]
    counts: Union[np.ndarray, h5py.Dataset]  #: (frame, z, y, x), share of water in 1/255 [uint8]

    @property
    def x(self) -> np.ndarray:
        """Centres of the voxels along x [m]."""
        return self._centres(0)

    @property
    def y(self) -> np.ndarray:
        """Centres of the voxels along y [m]."""
        return self._centres(1)

    @property
    def z(self) -> np.ndarray:
        """Centres of the voxels along z [m]; still water is z = 0."""
        return self._centres(2)

    def _centres(self, axis: int) -> np.ndarray:
        return self.origin[axis] + self.spacing * (np.arange(self.counts.shape[3 - axis]) + 0.5)

    def water(self, frame: int = -1) -> np.ndarray:
        """The share of water [0..1] of one frame, by default the last: (z, y, x)."""
        return self.counts[frame].astype(np.float32) / np.float32(255)

    def volume(self, frame: int = -1) -> float:
        """The water in the raster [m3]; in two dimensions the raster is one voxel wide."""
        return float(self.counts[frame].sum(dtype=np.int64)) / 255 * self.spacing**3

    def to_xarray(self) -> Any:
        """An xarray.DataArray with the coordinates time [s], z, y, x [m]. Needs xarray (Debian's python3-xarray)."""
        import xarray

        water = self.counts.astype(np.float32) / np.float32(255)
        places = {axis: (axis, getattr(self, axis), {"units": "m"}) for axis in "zyx"}
        return xarray.DataArray(water, dims=("time", "z", "y", "x"), name="water", attrs={"units": "1"},
                                coords={"time": ("time", self.times, {"units": "s"}), **places})


@dataclass(frozen=True)
class Hull:
    """The posed surface of the hull with what lay on it at the last frame."""

    points: np.ndarray  #: (points, 3) [m]
    triangles: np.ndarray  #: (triangles, 3), places in `points`
    pressure: Optional[np.ndarray]  #: of each triangle, gauge [Pa]; None where the method does not know
    wet: Optional[np.ndarray]  #: of each triangle, its wet share [0..1]


@dataclass(frozen=True)
class CertificateLine:
    """The worst value in the whole run of something that has to stay below a limit, when [s] and where [m]."""

    name: str
    unit: str
    value: float
    limit: float
    time: float
    place: Tuple[float, float, float]  #: NaN where it belongs to no place

    @property
    def met(self) -> bool:
        return self.value <= self.limit


@dataclass(frozen=True)
class EffectBound:
    """How far the truth may lie below and above a computed value because an effect was left out."""

    of: str  #: kind of quantity: drag, lift, splash, pressure, peak, height, level, arrival, impulse, motion
    below: float  #: not negative
    above: float
    unit: str  #: "-": shares of the value
    source: str  #: the formula, or where it was measured
    elements: str  #: "particles" or "cells" where it counts for these alone; else empty


@dataclass(frozen=True)
class Effect:
    """One effect of the plan as it was solved."""

    name: str
    on: bool
    forced: bool  #: the user said so
    reason: str
    influence: str
    cost: float  #: as a share of a particle run without it [-]
    bounds: Tuple[EffectBound, ...] = field(default=())


@dataclass(frozen=True)
class Phase:
    name: str
    wall: float  #: [s]
    cpu: float  #: of all processors [s]


@dataclass(frozen=True)
class Cost:
    """What the run took."""

    phases: Tuple[Phase, ...]
    peak_memory: float  #: [bytes]
    elements: float  #: particles or cells
    steps: float

    @property
    def wall(self) -> float:
        """[s]"""
        return sum(p.wall for p in self.phases)

    @property
    def cpu(self) -> float:
        """[s]"""
        return sum(p.cpu for p in self.phases)


@dataclass(frozen=True)
class ResolvedBox:
    """A box in which particles or cells were no larger than `size` [m]; its faces may be at infinity."""

    size: float
    low: Tuple[float, float, float]
    high: Tuple[float, float, float]


class Record:
    """A run record. Reading is by part: a raster of a gigabyte is read when it is asked for.

    Throws TwinwakeError where the file is not there, is no run record, is of a newer format, or has changed since it
    was written. `verify=False` leaves out the last of these, which reads the whole file once.
    """

    def __init__(self, path: Union[str, Path], verify: bool = True) -> None:
        self.path = Path(path)
        try:
            if verify:
                _refuse_changed(self.path)
            self._file = h5py.File(self.path, "r")
        except FileNotFoundError:
            raise TwinwakeError(f"{self.path}: there is no such file; a run leaves its record as "
                                f"FOLDER/sph/record.h5 or FOLDER/fvm/record.h5") from None
        except OSError as e:
            raise TwinwakeError(f"{self.path}: cannot be read as HDF5: {e}") from None
        if _text(self._file.attrs.get("kind", "")) != _KIND:
            self._file.close()
            raise TwinwakeError(f"{self.path}: an HDF5 file, but no run record: its attribute kind is not '{_KIND}'")
        version = int(self._file.attrs["format_version"])
        if version > _FORMAT_VERSION:
            self._file.close()
            raise TwinwakeError(f"{self.path}: record format {version}; this package reads up to {_FORMAT_VERSION}: "
                                f"use the twinwake package of the program that wrote it")
        self._tables: Dict[str, h5py.Group] = {_name(g): g for g in self._file["tables"].values()}

    def close(self) -> None:
        self._file.close()

    def __enter__(self) -> "Record":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<Record {self.path} {self.method}, {self.state}, tables {', '.join(self.tables)}>"

    # --- what it is

    @property
    def state(self) -> str:
        """running, finished, stopped or failed."""
        return _text(self._file.attrs["state"])

    @property
    def reason(self) -> str:
        """Why it stopped or failed."""
        return _text(self._file.attrs["reason"])

    @property
    def attributes(self) -> Dict[str, str]:
        """Provenance: method, title, scene_hash, code_version, machine, started, symmetry_factor, ..."""
        return {name: _text(value) for name, value in self._file["attributes"].attrs.items()}

    @property
    def numbers(self) -> Dict[str, float]:
        """What was solved, SI units: near_hull [m], speed [m/s], density [kg/m3], duration [s], mean_from [s], ..."""
        return {name: float(value) for name, value in self._file["numbers"].attrs.items()}

    @property
    def method(self) -> str:
        """sph, fvm, or what an import calls itself."""
        return self.attributes.get("method", "")

    @property
    def title(self) -> str:
        return self.attributes.get("title", "")

    @property
    def scene_text(self) -> str:
        """The scene file as it was run."""
        return _text(self._file["scene_text"][0])

    # --- series

    @property
    def tables(self) -> List[str]:
        """Names of the tables of time series: forces, samples, pressure, height, body_NAME, ..."""
        return list(self._tables)

    def units(self, table: str) -> Dict[str, str]:
        """The unit of each column, time included; "-" of a number without unit. In two dimensions forces are N/m."""
        return {_name(c): _text(c.attrs["unit"]) for c in self._columns(table)}

    def arrays(self, table: str) -> Dict[str, np.ndarray]:
        """The columns of a table as numpy arrays, the first of them `time` [s]. NaN: not known at that time."""
        return {_name(c): c[()] for c in self._columns(table)}

    def series(self, table: str = "forces") -> Union["pandas.DataFrame", Dict[str, np.ndarray]]:
        """A table as pandas.DataFrame over the time [s], its units in `.attrs["units"]`; without pandas as `arrays`."""
        columns = self.arrays(table)
        try:
            import pandas
        except ImportError:
            return columns
        time = columns.pop("time")
        frame = pandas.DataFrame(columns, index=pandas.Index(time, name="time"))
        frame.attrs["units"] = self.units(table)
        return frame

    def _columns(self, table: str) -> List[h5py.Dataset]:
        if table not in self._tables:
            raise TwinwakeError(f"{self.path}: no table '{table}'; this record has: {', '.join(self.tables)}")
        columns: Iterable[h5py.Dataset] = self._tables[table].values()
        return sorted(columns, key=lambda c: _name(c) != "time")

    @property
    def probes(self) -> Dict[str, Probe]:
        """The scene's probes and boxes by name. A name of two kinds is told apart by "NAME (height)" or "NAME (volume)"."""
        found: Dict[str, Probe] = {}
        for kind in ("pressure", "height", "volume"):
            if kind not in self._tables:
                continue
            units, columns = self.units(kind), self.arrays(kind)
            times = columns.pop("time")
            for name, values in columns.items():
                key = name if name not in found else f"{name} ({kind})"
                found[key] = Probe(name, kind, units[name], times, values)
        return found

    # --- fields

    def raster(self, in_memory: bool = True) -> Raster:
        """Where the water was at each frame. `in_memory=False` reads a frame when it is asked for."""
        group = self._file["raster"]
        return Raster(np.asarray(group.attrs["origin"], dtype=float), float(group.attrs["spacing"]),
                      group["time"][()], group["water"][()] if in_memory else group["water"])

    @property
    def has_raster(self) -> bool:
        """Whether there is a frame of the water; an imported record may have none."""
        return "raster" in self._file and self._file["raster"]["water"].size > 0

    def hull(self) -> Optional[Hull]:
        """The hull with its pressures at the last frame; None in a tank without one."""
        group = self._file["hull"]
        if len(group["triangles"]) == 0:
            return None
        pressure, wet = group["pressure"][()], group["wet"][()]
        return Hull(group["points"][()], group["triangles"][()], pressure if len(pressure) else None,
                    wet if len(wet) else None)

    @property
    def bodies(self) -> Dict[str, Body]:
        """Bodies that move, and obstacles, by the name of the table of their motion ("body_NAME", "hull_motion")."""
        bodies = {}
        for group in self._file["bodies"].values() if "bodies" in self._file else ():
            table = _text(group.attrs["table"])
            motion = self.arrays(table) if table in self._tables else None
            bodies[table] = Body(table, np.asarray(group.attrs["centre"], dtype=float), group["points"][()],
                                 group["triangles"][()], motion, self.numbers.get("trim", math.nan))
        return bodies

    # --- what is known of it

    @property
    def certificate(self) -> List[CertificateLine]:
        """The validity checks of the whole run; empty in older records."""
        return [CertificateLine(_text(r["name"]), _text(r["unit"]), float(r["value"]), float(r["limit"]),
                                float(r["time"]), (float(r["x"]), float(r["y"]), float(r["z"])))
                for r in self._rows("certificate")]

    @property
    def effects(self) -> List[Effect]:
        """The effect plan as solved: what is on, why, and how much an effect that is off may change."""
        bounds: Dict[str, List[EffectBound]] = {}
        for r in self._rows("effects/bounds"):
            bounds.setdefault(_text(r["effect"]), []).append(
                EffectBound(_text(r["of"]), float(r["below"]), float(r["above"]), _text(r["unit"]),
                            _text(r["source"]), _text(r["elements"]) if "elements" in r else ""))
        return [Effect(_text(r["name"]), bool(r["on"]), bool(r["forced"]), _text(r["reason"]),
                       _text(r["influence"]), float(r["cost"]), tuple(bounds.get(_text(r["name"]), ())))
                for r in self._rows("effects")]

    @property
    def cost(self) -> Cost:
        """Wall and processor time by phase, memory, elements, steps."""
        attributes = self._file["cost"].attrs
        phases = tuple(Phase(_text(r["phase"]), float(r["wall"]), float(r["cpu"])) for r in self._rows("cost"))
        return Cost(phases, float(attributes["peak_memory"]), float(attributes["elements"]),
                    float(attributes["steps"]))

    @property
    def resolution(self) -> List[ResolvedBox]:
        """The domain with its largest size, then the boxes that were finer at the end; empty where not known."""
        return [ResolvedBox(float(r["size"]), tuple(map(float, r["box"][0])), tuple(map(float, r["box"][1])))
                for r in self._rows("resolution")]

    def _rows(self, group: str) -> List[Dict[str, Any]]:
        """The datasets of a group, which are columns of one length, row by row; none where the group is missing."""
        if group not in self._file:
            return []
        columns = {k: v[()] for k, v in self._file[group].items() if isinstance(v, h5py.Dataset)}
        return [dict(zip(columns, values)) for values in zip(*columns.values())]


def _text(value: Any) -> str:
    """Text of an attribute or a dataset; bytes that are no UTF-8 are replaced."""
    if isinstance(value, h5py.Empty):
        return ""
    if isinstance(value, np.ndarray):
        value = value.item()
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _name(of: Union[h5py.Group, h5py.Dataset]) -> str:
    """The true name of a table or a column: HDF5's own names cannot hold every character."""
    return _text(of.attrs["name"])


def _refuse_changed(path: Path) -> None:
    """The last line of a record holds the SHA-256 of the bytes before it."""
    length = len(_SIGN) + 65
    with io.open(path, "rb") as file:
        left = path.stat().st_size - length
        sha = hashlib.sha256()
        while left > 0:
            block = file.read(min(left, 1 << 22))
            if not block:
                break
            sha.update(block)
            left -= len(block)
        line = file.read(length)
    if not line.startswith(_SIGN):
        raise TwinwakeError(f"{path}: not a whole run record: it does not end in the line with its SHA-256. Cut off, "
                            f"or another program's file; verify=False reads it all the same")
    if line[len(_SIGN):-1].decode("ascii", "replace") != sha.hexdigest():
        raise TwinwakeError(f"{path}: has changed since it was written (its SHA-256 differs): take it from a backup or "
                            f"run again; verify=False reads it all the same")
