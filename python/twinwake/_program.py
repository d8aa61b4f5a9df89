"""Starts the program twinwake. Nothing passes through a shell."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional, Sequence, Union

from ._errors import ProgramError, TwinwakeError
from ._folder import Run
from ._scene_text import scene_text


def find_program(program: Union[str, Path, None] = None) -> Path:
    """The program: the one named, else that of the environment variable TWINWAKE_PROGRAM, else the one beside this
    package (installed with it, or build/twinwake of its checkout), else that of PATH. Throws TwinwakeError."""
    named = program or os.environ.get("TWINWAKE_PROGRAM")
    if named:
        found = shutil.which(str(named))
        if not found:
            raise TwinwakeError(f"{named}: is no program that can be run")
        return Path(found).resolve()
    folder = Path(__file__).resolve().parents[1]
    # PREFIX/lib/python3/dist-packages and PREFIX/bin/twinwake, or python and build/twinwake of a checkout
    installed = folder.name == "dist-packages" and len(folder.parents) > 2
    place = folder.parents[2] / "bin" / "twinwake" if installed else folder.parent / "build" / "twinwake"
    if place.is_file() and os.access(place, os.X_OK):
        return place
    found = shutil.which("twinwake")
    if not found:
        raise TwinwakeError("the program twinwake is neither beside this package nor in a folder of PATH: build or "
                            "install it, or name it by program=... or the environment variable TWINWAKE_PROGRAM")
    return Path(found).resolve()


def run(scene: Union[Mapping[str, Any], str, Path], out: Union[str, Path], *, method: Optional[str] = None,
        twins: bool = True, threads: Optional[int] = None, overwrite: bool = False, resume: bool = False,
        options: Sequence[str] = (), scene_file: Union[str, Path, None] = None,
        program: Union[str, Path, None] = None, quiet: bool = True) -> Run:
    """Runs a scene and gives what it left in the folder `out`.

    scene       a dictionary (see scene_text), or the name of a scene file
    method      sph, fvm or both; None: as the scene says
    twins       also coarser runs, for the discretisation error that verdicts need
    threads     None: as the scene says
    overwrite   run anew where there is a run;  resume: go on with one that was stopped
    options     further words of the command line, e.g. ["--effect", "air=on"]
    scene_file  where a dictionary is written; None: NAME.toml in the current folder for out = .../NAME, so that
                relative names of files in the scene are those of the current folder
    quiet       False: what the program prints is shown, its progress too

    Throws ProgramError with the program's own message. An interrupt stops the program, which saves its state.
    """
    out = Path(out)
    if isinstance(scene, Mapping):
        file = Path(scene_file) if scene_file else Path(out.name + ".toml")
        _write_scene(file, scene_text(scene), overwrite or resume)
    else:
        file = Path(scene)
    words = ["run", os.fspath(file), "--out", os.fspath(out)]
    words += ["--method", method] if method else []
    words += [] if twins else ["--no-twins"]
    words += ["--threads", str(int(threads))] if threads else []
    words += ["--overwrite"] if overwrite else []
    words += ["--resume"] if resume else []
    _call(find_program(program), words + list(options), quiet)
    return Run(out)


def check(scene: Union[Mapping[str, Any], str, Path], *, options: Sequence[str] = (),
          program: Union[str, Path, None] = None) -> Dict[str, Any]:
    """What would be solved and what it would cost, as `twinwake check --json` says it; nothing is run.

    Relative names of files in a dictionary are those of the current folder. Throws ProgramError.
    """
    with tempfile.TemporaryDirectory(prefix="twinwake_") as folder:
        facts = Path(folder) / "facts.json"
        written: Optional[Path] = None
        if isinstance(scene, Mapping):
            handle, name = tempfile.mkstemp(".toml", "scene_", ".")
            written = Path(name)
            with os.fdopen(handle, "w", encoding="utf-8") as file:
                file.write(scene_text(scene))
        try:
            words = ["check", os.fspath(written or scene), "--json", os.fspath(facts), *options]
            _call(find_program(program), words, True)
        finally:
            if written:
                written.unlink()
        return json.loads(facts.read_text(encoding="utf-8"))


def _write_scene(file: Path, text: str, replace: bool) -> None:
    if file.exists() and not replace and file.read_text(encoding="utf-8", errors="replace") != text:
        raise TwinwakeError(f"{file}: there is another scene already; overwrite=True replaces it, scene_file=... "
                            f"writes to another place")
    beside = file.with_name(file.name + ".tmp")
    beside.write_text(text, encoding="utf-8")
    os.replace(beside, file)


def _call(program: Path, words: List[str], quiet: bool) -> None:
    """Runs the program; what it said on standard error is the message of the error that it ends with."""
    said: List[str] = []
    with subprocess.Popen([os.fspath(program), *words, *(["--quiet"] if quiet else [])], stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL if quiet else None, stderr=subprocess.PIPE, encoding="utf-8",
                          errors="replace") as child:
        assert child.stderr
        try:
            for line in child.stderr:
                said.append(line)
                if not quiet:
                    print(line, end="", file=sys.stderr, flush=True)
        except KeyboardInterrupt:
            child.terminate()  # it saves its state and ends
            child.wait()
            raise
    if child.returncode != 0:
        message = "".join(said[-20:]).strip()
        raise ProgramError(child.returncode, message or f"{program.name} ended with status {child.returncode}")
