"""A rigid body of a record: its surface at the start, and where it was later."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Optional, Tuple

import numpy as np

from ._errors import TwinwakeError


@dataclass(frozen=True)
class Body:
    """A body as it stood at the start; `points_at` gives its surface later."""

    table: str  #: name of the table of its motion
    centre: np.ndarray  #: of mass, at the start [m]
    points: np.ndarray  #: (points, 3) [m]; of two dimensions a metre wide
    triangles: np.ndarray  #: (triangles, 3), places in `points`
    motion: Optional[Dict[str, np.ndarray]]  #: columns of its table; None: it stays where it is
    trim: float  #: of the hull at the start [rad]; used by a hull that is free in a stream

    def pose_at(self, time: float) -> Tuple[np.ndarray, np.ndarray]:
        """Centre [m] and rotation matrix at a time [s]: x = centre + rotation (x_0 - centre_0).

        Places are linear and attitudes along the shortest turn between two rows, from t = 0, where the body stood at
        the start; after the last row as there.
        """
        start = self.centre, np.array([1.0, 0.0, 0.0, 0.0])
        if self.motion is None or len(self.motion["time"]) == 0:
            return start[0], _rotation(start[1])
        times = self.motion["time"]
        after = int(np.searchsorted(times, time))
        if after == len(times):
            centre, turn = self._row(after - 1)
            return centre, _rotation(turn)
        before = self._row(after - 1) if after > 0 else start
        begin = times[after - 1] if after > 0 else 0.0
        span = times[after] - begin
        share = float(np.clip((time - begin) / span, 0.0, 1.0)) if span > 0 else 1.0
        there = self._row(after)
        return before[0] + share * (there[0] - before[0]), _rotation(_between(before[1], there[1], share))

    def points_at(self, time: float) -> np.ndarray:
        """The surface's points [m] at a time [s]."""
        centre, rotation = self.pose_at(time)
        return centre + (self.points - self.centre) @ rotation.T

    def _row(self, row: int) -> Tuple[np.ndarray, np.ndarray]:
        """Centre and quaternion (q0, qx, qy, qz) of a row."""
        assert self.motion is not None
        m = self.motion
        if "q0" in m:
            turn = np.array([m["q0"][row], m["qx"][row], m["qy"][row], m["qz"][row]])
            return np.array([m["x"][row], m["y"][row], m["z"][row]]), turn / np.linalg.norm(turn)
        if "trim" in m:  # a hull that is free in a stream: heave, and pitch about y, bow up
            half = (np.radians(m["trim"][row]) - self.trim) / 2
            return np.array([self.centre[0], self.centre[1], m["z"][row]]), np.array([np.cos(half), 0, np.sin(half), 0])
        raise TwinwakeError(f"table '{self.table}' has no attitude: a body that bends has no one pose; its columns are "
                            f"{', '.join(m)}")


def _between(a: np.ndarray, b: np.ndarray, share: float) -> np.ndarray:
    """The shortest turn from quaternion a to b, a share of it (slerp)."""
    cosine = float(np.dot(a, b))
    if cosine < 0:
        b, cosine = -b, -cosine
    angle = np.arccos(min(cosine, 1.0))
    if angle < 1e-8:
        return a + share * (b - a)
    return (np.sin((1 - share) * angle) * a + np.sin(share * angle) * b) / np.sin(angle)


def _rotation(q: np.ndarray) -> np.ndarray:
    """The rotation matrix of a unit quaternion (q0, qx, qy, qz)."""
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
