"""A scene as the text of its TOML file."""

from __future__ import annotations

import math
import os
import re
from typing import Any, List, Mapping, Tuple

from ._errors import TwinwakeError

_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+\Z")
_ESCAPES = {"\b": "\\b", "\t": "\\t", "\n": "\\n", "\f": "\\f", "\r": "\\r", '"': '\\"', "\\": "\\\\"}


def scene_text(scene: Mapping[str, Any]) -> str:
    """The TOML text of a scene that is given as a dictionary, section by section:

        {"tank": {"size": [1, 0.2, 1]}, "water_block": [{"min": [0, 0, 0], "max": [0.3, 0.2, 0.3]}], ...}

    Texts (values with a unit, "8 m/s"), numbers, flags, lists, numpy's numbers and arrays, and paths. A list of
    dictionaries is a section that may be repeated, such as [[body]]. Throws TwinwakeError naming the key whose value
    cannot be written.
    """
    lines: List[str] = []
    _write_table(scene, (), lines)
    return "\n".join(lines).lstrip("\n") + "\n"


def _write_table(table: Mapping[str, Any], path: Tuple[str, ...], lines: List[str]) -> None:
    """The plain values first: in TOML what stands behind a section's head belongs to that section."""
    below = []
    for key, value in table.items():
        if not isinstance(key, str):
            raise TwinwakeError(f"scene: {_shown(path)} has the key {key!r}; keys are texts")
        if isinstance(value, Mapping) or _is_sections(value):
            below.append((key, value))
        else:
            lines.append(f"{_key(key)} = {_value(value, path + (key,))}")
    for key, value in below:
        here = path + (key,)
        head = ".".join(map(_key, here))
        if isinstance(value, Mapping):
            lines += ["", f"[{head}]"]
            _write_table(value, here, lines)
        else:
            for member in value:
                lines += ["", f"[[{head}]]"]
                _write_table(member, here, lines)


def _is_sections(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(v, Mapping) for v in value)


def _value(value: Any, path: Tuple[str, ...]) -> str:
    if hasattr(value, "tolist"):  # numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        if not -(2**63) <= value < 2**63:
            raise TwinwakeError(f"scene: {_shown(path)} = {value}: a whole number of TOML has 64 bits; "
                                f"write it as a float")
        return str(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            raise TwinwakeError(f"scene: {_shown(path)} = {value}: a finite number is expected")
        return repr(value)
    if isinstance(value, str):
        return _quoted(value, path)
    if isinstance(value, os.PathLike):
        return _quoted(os.fspath(value), path)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(v, path) for v in value) + "]"
    if isinstance(value, Mapping):
        members = (f"{_key(k)} = {_value(v, path + (k,))}" for k, v in value.items())
        return "{" + ", ".join(members) + "}"
    raise TwinwakeError(f"scene: {_shown(path)} is {value!r} ({type(value).__name__}); expected a text, a number, "
                        f"True or False, a list or a dictionary. Leave the key out for its default")


def _key(key: str) -> str:
    return key if _BARE_KEY.match(key) else _quoted(key, (key,))


def _quoted(text: str, path: Tuple[str, ...]) -> str:
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        raise TwinwakeError(f"scene: {_shown(path)} = {text!r}: is no text that UTF-8 can hold") from None
    def escaped(c: str) -> str:
        return _ESCAPES.get(c) or (f"\\u{ord(c):04x}" if ord(c) < 0x20 or ord(c) == 0x7F else c)
    return '"' + "".join(map(escaped, text)) + '"'


def _shown(path: Tuple[str, ...]) -> str:
    return ".".join(path) or "the scene"
