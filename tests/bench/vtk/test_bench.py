"""Tests of all that the bench does without VTK and without drawing: run by ctest (cli.bench)."""
import array
import copy
import json
import math
import sys
import tempfile
import unittest
from pathlib import Path

import agreement
import cases
import child
import docs
import pfm
import tables
import transfer

RECORDED = json.loads(Path(__file__).with_name("recorded.json").read_text())


def grown(record, mesh, factor, **changes):
    """A record of another mesh whose frames, first picture and memory are `factor` times those of `record`."""
    other = copy.deepcopy(record)
    other.update(mesh=mesh, tetrahedra=cases.MESHES[mesh].tetrahedra, **changes)
    for part in ("still", "turning"):
        for key in ("median_wall_ms", "median_cpu_ms"):
            other[part][key] *= factor
    for key in ("wall_s", "cpu_s", "peak_bytes"):
        other["first"][key] *= factor
    return other


class Tables(unittest.TestCase):
    def test_a_row_says_what_was_recorded(self):
        record = RECORDED["records"][0]
        row = dict(zip(("method", "first", "first_cpu", "memory", "frame"), tables.row(record)))
        self.assertEqual(row["method"], "VTK projected tetrahedra")
        self.assertAlmostEqual(float(row["first"]), record["first"]["wall_s"], delta=0.005)
        self.assertAlmostEqual(float(row["memory"]), record["first"]["peak_bytes"] / 1e6, delta=0.5)
        wall = sorted(record["still"]["wall_ms"])
        middle = (wall[(len(wall) - 1) // 2] + wall[len(wall) // 2]) / 2
        self.assertAlmostEqual(float(row["frame"]), middle, delta=0.5)

    def test_every_row_fills_the_columns(self):
        for record in RECORDED["records"]:
            self.assertEqual(len(tables.row(record)), len(tables.COLUMNS))
        for group in tables.jobs_of(RECORDED["records"]):
            for row in tables.ratios(group):
                self.assertEqual(len(row), len(tables.RATIO_COLUMNS))

    def test_markdown_rows_have_as_many_cells_as_their_header(self):
        text = tables.report(RECORDED, tables.markdown_table, lambda title: f"**{title}**")
        for block in text.split("\n\n"):
            lines = [line for line in block.splitlines() if line.startswith("|")]
            self.assertEqual(len({line.count("|") for line in lines}), 1 if lines else 0, block)
        for group in tables.jobs_of(RECORDED["records"]):
            self.assertIn(tables.title(group), text)
        for line in RECORDED["skipped"]:
            self.assertIn(line, text)

    def test_records_of_one_job_stand_in_one_table(self):
        record = RECORDED["records"][0]
        other_size = {**record, "size": 2 * record["size"]}
        groups = tables.jobs_of([record, other_size, {**record, "method": "havs-native"}])
        self.assertEqual([len(g) for g in groups], [2, 1])

    def test_ratios_compare_ours_with_vtk_and_native_with_its_like(self):
        base = RECORDED["records"][-1]
        group = [{**base, "method": m} for m in ("vtk-projected", "havs-osmesa-3d", "havs-native-3d", "havs-native-exact")]
        pairs = [(r[0], r[1]) for r in tables.ratios(group)]
        self.assertIn(("havs native, 3d", "havs osmesa, 3d"), pairs)
        self.assertNotIn(("havs native, exact", "havs osmesa, 3d"), pairs)
        self.assertNotIn(("havs osmesa, 3d", "havs native, 3d"), pairs)
        self.assertEqual(len([p for p in pairs if p[1] == "VTK projected tetrahedra"]), 3)

    def test_growth_in_step_with_the_tetrahedra_has_the_power_one(self):
        small = {**RECORDED["records"][0], "case": "visible", "mesh": "cube-200k",
                 "tetrahedra": cases.MESHES["cube-200k"].tetrahedra}
        factor = cases.MESHES["cube-3m"].tetrahedra / small["tetrahedra"]
        (name, rows), = tables.growth([small, grown(small, "cube-3m", factor)])
        self.assertIn("204,890 to 2,989,679 tetrahedra", name)
        self.assertEqual(rows[0][1:4], [f"{factor:.2f} (+1.00)"] * 3)
        self.assertEqual(rows[0][4], f"{factor:.2f}")

    def test_a_tenth_of_the_cells_is_compared_with_all(self):
        full = {**RECORDED["records"][0], "case": "visible", "mesh": "cube-1m"}
        rows = tables.tenth([full, grown(full, "cube-1m", 0.25, case="tenth")])
        self.assertEqual(rows[0][2:], ["4.0"] * 4)


class Docs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.page = Path(self.folder.name) / "page.md"

    def tearDown(self):
        self.folder.cleanup()

    def test_only_what_stands_between_the_marks_is_replaced(self):
        self.page.write_text(f"before\n{docs.BEGIN}\nold\n{docs.END}\nafter\n")
        docs.insert(RECORDED, self.page)
        once = self.page.read_text()
        self.assertTrue(once.startswith("before\n") and once.endswith(f"{docs.END}\nafter\n"))
        self.assertNotIn("old", once)
        docs.insert(RECORDED, self.page)
        self.assertEqual(self.page.read_text(), once)

    def test_a_page_without_marks_is_refused(self):
        self.page.write_text("nothing here\n")
        with self.assertRaises(SystemExit):
            docs.insert(RECORDED, self.page)
        self.assertEqual(self.page.read_text(), "nothing here\n")

    def test_the_page_of_the_docs_has_its_marks(self):
        text = (Path(__file__).resolve().parents[3] / "docs/07-performance.md").read_text()
        self.assertLess(text.index(docs.BEGIN), text.index(docs.END))


class Parts(unittest.TestCase):
    def test_rays_through_the_unit_cube_have_their_lengths(self):
        camera = {"eye": [0.5, 0.5, 3.0], "target": [0.5, 0.5, 0.5], "up": [0, 1, 0], "field_of_view": 40.0}
        lengths = list(agreement.box_lengths(camera, 3))
        slope = math.tan(math.radians(20)) * 2 / 3  # of the rays beside the middle one, which enter in front
        inside = 0.5 / slope - 2.0  # and leave by the side: depth between
        self.assertAlmostEqual(lengths[4], 1.0, places=12)
        for beside in (1, 3, 5, 7):
            self.assertAlmostEqual(lengths[beside], inside * math.hypot(1, slope), places=12)
        for corner in (0, 2, 6, 8):
            self.assertAlmostEqual(lengths[corner], inside * math.hypot(1, slope, slope), places=12)
        wide = list(agreement.box_lengths({**camera, "field_of_view": 50.0}, 3))
        self.assertEqual(wide[:4] + wide[5:], [0.0] * 8)  # 2 tan(25 degrees) 2/3 > 1/2: past the cube

    def test_float_maps_come_back_as_written(self):
        values = array.array("f", [0, 0.5, 1, -2, 3, 1e-7] * 2)
        with tempfile.TemporaryDirectory() as folder:
            pfm.write(Path(folder) / "a.pfm", 2, 2, values)
            self.assertEqual(pfm.read(Path(folder) / "a.pfm"), (2, 2, values))

    def test_transfer_functions_ascend_and_use_all_of_the_opacity(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, function in cases.TRANSFERS.items():
                written = json.loads(transfer.write(Path(folder) / "tf.json", name, function).read_text())
                scalars = [p["scalar"] for p in written["points"]]
                self.assertEqual(scalars, sorted(set(scalars)), name)
                self.assertEqual(max(p["opacity"] for p in written["points"]), 1.0, name)
                self.assertEqual(written["opacity"], "extinction")

    def test_every_job_names_what_there_is(self):
        for job in cases.quick_jobs() + cases.full_jobs(cores=2):
            self.assertIn(job.mesh, cases.MESHES)
            case = cases.CASES[job.case]
            self.assertIn(case.field, cases.FIELDS)
            self.assertIn(case.transfer, cases.TRANSFERS)
            for method in job.methods:
                self.assertTrue(method in tables.LABELS or method.startswith("havs-"), method)

    def test_a_child_is_measured_and_its_failure_told(self):
        done = child.run([sys.executable, "-c", "x = bytearray(60_000_000); print(sum(range(10**6)))"], threads=1)
        self.assertEqual(done.output.strip(), "499999500000")
        self.assertGreater(done.peak_bytes, 60_000_000)
        self.assertGreater(done.cpu_s, 0)
        with self.assertRaisesRegex(child.Failed, "(?s)status 3.*went wrong"):
            child.run([sys.executable, "-c", "import sys; sys.stderr.write('went wrong'); sys.exit(3)"])


if __name__ == "__main__":
    unittest.main()
