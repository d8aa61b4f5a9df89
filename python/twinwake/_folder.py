"""A run's folder: the records of its methods, its coarser twins, and its report."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Optional, Union

from ._errors import TwinwakeError
from ._record import Record
from ._report import Report


@dataclass(frozen=True)
class Twin:
    """The same scene at a coarser size, from which the discretisation error is estimated."""

    near_hull: float  #: size of particles and cells at the hull [m]
    folder: Path
    records: Dict[str, Record]  #: by method


class Run:
    """What `twinwake run` left in a folder."""

    def __init__(self, folder: Union[str, Path], verify: bool = True) -> None:
        self.folder = Path(folder)
        self._verify = verify
        if not self.folder.is_dir():
            raise TwinwakeError(f"{self.folder}: there is no such folder; twinwake run leaves its results in "
                                f"runs/NAME of the scene file, or where --out says")
        self.records: Dict[str, Record] = _records_in(self.folder, verify)
        if not self.records:
            below = sorted(str(f.parent.relative_to(self.folder)) for f in self.folder.glob("*/*/record.h5"))
            hint = f"; there are records in {', '.join(below[:4])}: open those, or use records_below" if below else ""
            raise TwinwakeError(f"{self.folder}: holds no run: expected a method's record, such as sph/record.h5 or "
                                f"fvm/record.h5{hint}")

    def __repr__(self) -> str:
        return f"<Run {self.folder}: {', '.join(f'{m} {r.state}' for m, r in self.records.items())}>"

    @property
    def twins(self) -> List[Twin]:
        """The coarser sizes, finest first."""
        twins = []
        for folder in (self.folder / "twins").glob("*"):
            records = _records_in(folder, self._verify)
            if records:
                near_hull = next(iter(records.values())).numbers.get("near_hull", float("nan"))
                twins.append(Twin(near_hull, folder, records))
        return sorted(twins, key=lambda t: t.near_hull)

    @property
    def report(self) -> Report:
        """The comparison with its quantities and verdicts. Throws TwinwakeError where none has been written yet."""
        return Report(self.folder / "report.json")


def open(path: Union[str, Path], verify: bool = True) -> Union[Record, Run]:
    """A record file as Record, a run's folder as Run, a folder with a record.h5 of its own (one method's) as Record.

    Throws TwinwakeError. `verify=False` does not compare records with their SHA-256.
    """
    path = Path(path)
    if path.is_dir():
        own: Optional[Path] = path / "record.h5"
        return Record(own, verify) if own.exists() else Run(path, verify)
    return Record(path, verify)


def records_below(folder: Union[str, Path], verify: bool = True) -> Dict[str, Record]:
    """All records of a study (ladder, sweep, ablation), by their folder's path: "near_hull_40mm/sph", ..."""
    folder = Path(folder)
    found = {file.parent.relative_to(folder).as_posix(): Record(file, verify)
             for file in sorted(folder.rglob("record.h5"))}
    if not found:
        raise TwinwakeError(f"{folder}: there is no record.h5 in it or in any folder below")
    return found


def _records_in(folder: Path, verify: bool) -> Dict[str, Record]:
    return {file.parent.name: Record(file, verify) for file in sorted(folder.glob("*/record.h5"))}
