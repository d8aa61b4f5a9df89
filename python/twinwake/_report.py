"""The comparison of a run: its report.json."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List, Union

from ._errors import TwinwakeError


@dataclass(frozen=True)
class Quantity:
    """One compared quantity: drag, lift, splash height, a gauge's peak, ..."""

    name: str
    label: str
    unit: str
    definition: str
    values: Dict[str, float]  #: by source; NaN where it is not known
    intervals: Dict[str, float]  #: half width of 95 %, by source; NaN where it is not known
    difference: float  #: second source less first, or of the pair that lies farthest apart; NaN without a comparison
    interval: float  #: half width of the difference's 95 % interval
    per_cent: float  #: the difference as a share of the mean of the two, or of the quantity's scale if that is larger
    verdict: str  #: agree, differ, undecided, not_converged, not_comparable or "discretisation error not estimated"
    sentence: str
    remark: str
    facts: Dict[str, Any]  #: all that report.json says of it


@dataclass(frozen=True)
class Gate:
    """A validity check of one source: a value that has to stay below its limit."""

    name: str
    source: str
    unit: str
    value: float
    limit: float
    passed: bool
    only_warns: bool
    remark: str


class Report:
    """A run's report.json. `facts` is the whole of it."""

    def __init__(self, path: Union[str, Path]) -> None:
        self.path = Path(path)
        try:
            self.facts: Dict[str, Any] = json.loads(self.path.read_text(encoding="utf-8"))
            self.sources: List[str] = [s["name"] for s in self.facts["sources"]]
            self.quantities: Dict[str, Quantity] = {q["name"]: self._quantity(q) for q in self.facts["quantities"]}
            self.gates: List[Gate] = [Gate(g["name"], g["source"], g["unit"], _number(g["value"]),
                                           _number(g["limit"]), g["pass"], g["warns"], g["remark"])
                                      for g in self.facts["gates"]]
        except FileNotFoundError:
            raise TwinwakeError(f"{self.path}: there is no report; twinwake run and twinwake compare write it when "
                                f"their runs are finished") from None
        except (OSError, ValueError, KeyError, TypeError) as e:
            raise TwinwakeError(f"{self.path}: is no twinwake report: {e}") from None

    @property
    def verdicts(self) -> Dict[str, str]:
        """The verdict of each quantity that the report judges."""
        return {q.name: q.verdict for q in self.quantities.values() if q.facts["judged"]}

    def _quantity(self, q: Dict[str, Any]) -> Quantity:
        return Quantity(q["name"], q["label"], q["unit"], q["definition"],
                        dict(zip(self.sources, map(_number, q["values"]))),
                        dict(zip(self.sources, map(_number, q["intervals"]))), _number(q["difference"]),
                        _number(q["interval"]), _number(q["per_cent"]), q["verdict"], q["sentence"], q["remark"], q)


def _number(value: Any) -> float:
    """JSON has no NaN: null stands for what is not known."""
    return math.nan if value is None else float(value)
