"""Runs started from Python, and what they left, read back."""

import math
import re
import unittest
from pathlib import Path

from small_runs import COLUMN, FLOATING, HOSTILE_TITLE, HULL, InAFolder, twinwake

import numpy as np

PAGE = Path(__file__).parents[3] / "docs" / "record_columns.md"


class Records(InAFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.column = twinwake.run(COLUMN, "runs/column")
        cls.floating = twinwake.run(FLOATING, "runs/floating", twins=False)
        cls.hull = twinwake.run(HULL, "runs/hull", method="sph", twins=False)

    def records(self):
        return [run.records["sph"] for run in (self.column, self.floating, self.hull)]

    def test_a_scene_reaches_the_record_and_no_shell(self):
        record = self.column.records["sph"]
        self.assertEqual(record.state, "finished")
        self.assertEqual(record.title, HOSTILE_TITLE)
        self.assertEqual(record.scene_text, Path("column.toml").read_text(encoding="utf-8"))
        self.assertFalse(list(self.folder.rglob("pwned")))

    def test_the_raster_holds_the_water_of_the_samples(self):
        record = self.column.records["sph"]
        raster = record.raster()
        mass = record.arrays("samples")["mass"]
        self.assertEqual(raster.water().shape, (len(raster.z), len(raster.y), len(raster.x)))
        self.assertGreater(len(raster.times), 1)
        self.assertAlmostEqual(raster.volume(0), mass[0] / record.numbers["density"], delta=0.02 * raster.volume(0))
        # the column stands at x < 0.2 m at first: the axes are not exchanged
        self.assertLess(raster.water(0)[:, :, raster.x > 0.21].sum(), 0.01 * raster.water(0).sum())

    def test_the_raster_is_a_labelled_array_where_xarray_is(self):
        try:
            import xarray
        except ImportError:
            self.skipTest("there is no xarray (Debian's python3-xarray)")
        raster = self.column.records["sph"].raster()
        water = raster.to_xarray()
        self.assertIsInstance(water, xarray.DataArray)
        self.assertEqual(water.dims, ("time", "z", "y", "x"))
        self.assertEqual((water.x.attrs["units"], water.time.attrs["units"]), ("m", "s"))
        np.testing.assert_array_equal(water.time, raster.times)
        np.testing.assert_allclose(water.isel(time=-1), raster.water(len(raster.times) - 1))
        # the column stands at x < 0.2 m at first, and reaches further at the end
        wet = (water > 0.5).any(("y", "z"))
        front = wet.x.where(wet).max("x")
        self.assertLess(float(front[0]), 0.21)
        self.assertGreater(float(front[-1]), float(front[0]) + 0.02)

    def test_series_have_units_and_one_length(self):
        for record in self.records():
            for table in record.tables:
                columns = record.arrays(table)
                self.assertEqual(next(iter(columns)), "time")
                self.assertEqual(list(columns), list(record.units(table)))
                self.assertEqual({len(c) for c in columns.values()}, {len(columns["time"])})
                self.assertTrue(np.all(np.diff(columns["time"]) >= 0))
        self.assertEqual(self.hull.records["sph"].units("forces")["fz"], "N")
        self.assertEqual(self.floating.records["sph"].units("forces")["fz"], "N/m")
        self.assertIn("forces", str(self.raised(lambda: self.column.records["sph"].series("force"))))

    def test_series_are_a_data_frame_where_pandas_is(self):
        record = self.hull.records["sph"]
        series = record.series("forces")
        arrays = record.arrays("forces")
        np.testing.assert_array_equal(np.asarray(series["fz"]), arrays["fz"])
        try:
            import pandas
        except ImportError:
            self.assertIsInstance(series, dict)
            return
        self.assertIsInstance(series, pandas.DataFrame)
        np.testing.assert_array_equal(series.index, arrays["time"])
        self.assertEqual(series.attrs["units"]["fz"], "N")

    def test_probes(self):
        (probe,) = self.column.records["sph"].probes.values()
        self.assertEqual((probe.kind, probe.unit), ("pressure", "Pa"))
        self.assertEqual(len(probe.times), len(probe.values))

    def test_a_body_stands_where_its_table_has_it(self):
        record = self.floating.records["sph"]
        body, motion = record.bodies["body_box"], record.arrays("body_box")
        self.assertGreater(np.abs(motion["q0"] - 1).max(), 1e-4)  # it has turned
        for row in (0, len(motion["time"]) // 2, -1):
            lowest = body.points_at(motion["time"][row])[:, 2].min()
            self.assertAlmostEqual(lowest, motion["lowest"][row], delta=1e-6)
        between = 0.5 * (motion["time"][10] + motion["time"][11])
        self.assertAlmostEqual(body.pose_at(between)[0][2], 0.5 * (motion["z"][10] + motion["z"][11]), delta=1e-9)

    def test_a_hull_carries_its_pressures(self):
        hull = self.hull.records["sph"].hull()
        self.assertEqual(hull.triangles.shape[1], 3)
        self.assertLess(hull.triangles.max(), len(hull.points))
        self.assertEqual(len(hull.pressure), len(hull.triangles))
        middle = hull.points[hull.triangles].mean(axis=1)
        self.assertGreater(hull.wet[middle[:, 2] < -0.1].mean(), hull.wet[middle[:, 2] > 0.1].mean())
        self.assertIsNone(self.column.records["sph"].hull())

    def test_certificate_effects_cost_and_sizes(self):
        for record in self.records():
            self.assertIn("Mach number", [line.name for line in record.certificate])
            self.assertTrue(all(line.met == (line.value <= line.limit) for line in record.certificate))
            effects = {e.name: e for e in record.effects}
            self.assertIn("surface_tension", effects)
            self.assertTrue(all(e.reason for e in record.effects))
            self.assertEqual(record.cost.steps, len(record.arrays("forces")["time"]))
            self.assertGreater(record.cost.wall, 0)
            sizes = [box.size for box in record.resolution]
            self.assertEqual(sizes[0], max(sizes))
            self.assertAlmostEqual(min(sizes), record.numbers["near_hull"], delta=1e-9)
            self.assertAlmostEqual(record.resolution[0].high[0], record.numbers["domain_x_max"], delta=1e-9)

    def test_twins_are_the_same_scene_coarser(self):
        sizes = [twin.near_hull for twin in self.column.twins]
        np.testing.assert_allclose(sizes, [0.02 * math.sqrt(2), 0.04], rtol=1e-6)
        self.assertEqual({twin.records["sph"].title for twin in self.column.twins}, {HOSTILE_TITLE})
        self.assertEqual(self.floating.twins, [])
        self.assertEqual(len(twinwake.records_below("runs/column")), 3)

    def test_the_report_says_what_the_record_does(self):
        report = self.column.report
        self.assertEqual(report.sources, ["sph"])
        gates = {g.name: g for g in report.gates}
        worst = {c.name: c for c in self.column.records["sph"].certificate}["Mach number"]
        self.assertEqual(gates["Mach number"].limit, worst.limit)
        self.assertAlmostEqual(gates["Mach number"].value, worst.value, delta=1e-6 * worst.value)
        self.assertTrue(report.verdicts)
        self.assertEqual(set(report.verdicts.values()), {"not_comparable"})  # one method alone
        self.assertTrue(math.isnan(report.quantities["splash_sheet_height"].difference))

    def test_the_page_names_every_column_with_its_unit(self):
        rows = re.findall(r"^\| `([^|]*)` \| ([^|]*) \| ([^|]*) \|", PAGE.read_text(encoding="utf-8"), re.M)
        named = {}
        for table, columns, units in rows:
            for column in re.findall(r"`([^`]*)`", columns):
                pattern = re.escape(table) + "/" + re.escape(column)
                named[pattern.replace("NAME", ".+").replace(r"level_K", r"level_\d+")] = units.split(", ")
        for record in self.records():
            for table in record.tables:
                for column, unit in record.units(table).items():
                    units = [u for p, u in named.items() if column == "time" or re.fullmatch(p, f"{table}/{column}")]
                    self.assertTrue(units, f"{PAGE.name}: no row for {table}/{column} [{unit}]")
                    plain = unit[:-2] if unit.endswith("/m") and column != "vz" else unit
                    self.assertTrue(column == "time" or any({unit, plain} & set(u) for u in units),
                                    f"{PAGE.name}: {table}/{column} is in {unit}")

    # --- refusals

    def raised(self, call):
        with self.assertRaises(twinwake.TwinwakeError) as caught:
            call()
        return caught.exception

    def test_the_programs_own_message_is_raised(self):
        wrong = {**COLUMN, "resolution": {"near_hul": 0.02}}
        error = self.raised(lambda: twinwake.run(wrong, "runs/wrong"))
        self.assertIsInstance(error, twinwake.ProgramError)
        self.assertEqual(error.status, 2)
        self.assertRegex(str(error), r"wrong\.toml:\d+:\d+: .*near_hul")
        error = self.raised(lambda: twinwake.run(COLUMN, "runs/column"))
        self.assertIn("there is a run already", str(error))

    def test_another_scene_is_not_written_over(self):
        Path("mine.toml").write_text("title = \"mine\"\n", encoding="utf-8")
        error = self.raised(lambda: twinwake.run(COLUMN, "runs/mine"))
        self.assertIn("another scene", str(error))
        self.assertEqual(Path("mine.toml").read_text(encoding="utf-8"), "title = \"mine\"\n")

    def test_check_says_what_a_run_would_be(self):
        facts = twinwake.check(COLUMN)
        self.assertEqual(facts["title"].split()[0], "a")
        self.assertEqual(list(Path(".").glob("scene_*")), [])

    def test_damage_is_found(self):
        whole = Path("runs/column/sph/record.h5").read_bytes()
        damaged = Path("damaged.h5")
        changed = bytearray(whole)
        changed[len(changed) // 2] ^= 1
        for content, message in ((bytes(changed), "has changed"), (whole[:-1000], "not a whole run record"),
                                 (b"", "not a whole run record")):
            damaged.write_bytes(content)
            self.assertIn(message, str(self.raised(lambda: twinwake.open(damaged))))
        damaged.write_bytes(b"no HDF5")
        self.assertIn("HDF5", str(self.raised(lambda: twinwake.open(damaged, verify=False))))
        self.assertIn("no such file", str(self.raised(lambda: twinwake.open("nothing.h5"))))
        self.assertIn("column/sph", str(self.raised(lambda: twinwake.open("runs"))))


if __name__ == "__main__":
    unittest.main()
