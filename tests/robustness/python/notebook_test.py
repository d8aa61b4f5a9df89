"""The example notebook: its code runs from top to bottom, and it is kept without outputs."""

import contextlib
import io
import json
import unittest
from pathlib import Path

from small_runs import InAFolder

NOTEBOOK = Path(__file__).parents[3] / "docs" / "examples" / "first_run.ipynb"


class Notebook(InAFolder):
    def test_its_cells_run_in_order(self):
        cells = [c for c in json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"] if c["cell_type"] == "code"]
        self.assertGreater(len(cells), 3)
        names = {}
        for number, cell in enumerate(cells, 1):
            self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), f"cell {number} has outputs")
            with contextlib.redirect_stdout(io.StringIO()):
                exec(compile("".join(cell["source"]), f"{NOTEBOOK.name}, cell {number}", "exec"), names)
        self.assertAlmostEqual(names["front"][0], 0.15, delta=0.015)  # the column as it was described


if __name__ == "__main__":
    unittest.main()
