"""What twinwake's runs left, for Python; and runs started from it.

    import twinwake

    study = twinwake.open("runs/demo")             # a run's folder: both methods, twins, report
    forces = study.records["sph"].series("forces")  # a pandas DataFrame; without pandas a dict of numpy arrays
    print(study.report.quantities["drag"].verdict)

    record = twinwake.open("runs/demo/fvm/record.h5")   # one record
    print(record.units("forces"), record.raster().times)

Needs h5py (and numpy, which comes with it). Everything is in SI units unless a column's unit says otherwise; z is up,
still water is z = 0, x runs with the stream to the stern. docs/python.md shows each part; docs/record_columns.md names
the tables and columns with their units.
"""

from ._errors import ProgramError, TwinwakeError
from ._folder import Run, Twin, open, records_below
from ._program import check, find_program, run
from ._record import (Body, CertificateLine, Cost, Effect, EffectBound, Hull, Phase, Probe, Raster, Record,
                      ResolvedBox)
from ._report import Gate, Quantity, Report
from ._scene_text import scene_text

__all__ = [
    "Body", "CertificateLine", "Cost", "Effect", "EffectBound", "Gate", "Hull", "Phase", "Probe", "ProgramError",
    "Quantity", "Raster", "Record", "Report", "ResolvedBox", "Run", "Twin", "TwinwakeError", "check", "find_program",
    "open", "records_below", "run", "scene_text",
]
