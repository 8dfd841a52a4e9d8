"""The record of outputs: every class has a case, rows do not depend on threads, and any change shows."""
import contextlib
import io
import os
import re
import tempfile
import unittest

from vtkmodules.vtkCommonDataModel import vtkPolyData

import output_cases
import record_outputs

# Of each class the smallest run, on 1 thread and on more.
SMALLEST = {name: "small" if "small" in case.set_up else "default"
            for name, case in output_cases.CASES.items()}


def most_threads():
    """4, or as many as the backends of this VTK have on a machine with fewer cores."""
    for threads in (4, 3, 2):
        with contextlib.suppress(SystemExit):
            record_outputs.set_threads(threads)
            return threads
    raise unittest.SkipTest("VTK runs on one thread only")


def rows_on(threads):
    record_outputs.set_threads(threads)
    wanted = "|".join(f"^{name}/{run}$" for name, run in SMALLEST.items())
    return record_outputs.record(re.compile(wanted), is_mpi=False)


def copy_of(data):
    copy = vtkPolyData()
    copy.DeepCopy(data)
    return copy


def rows_of(data):
    return dict(record_outputs.rows_of_data("a", data))


class TestOutputs(unittest.TestCase):
    def test_every_class_has_a_case(self):
        self.assertGreater(len(output_cases.concrete_classes()), 40)
        self.assertEqual({*output_cases.CASES, *output_cases.UNTRIED_READERS}, set(output_cases.concrete_classes()))

    def test_every_class_has_the_same_rows_on_1_and_more_threads(self):
        alone, failures = rows_on(1)
        self.assertEqual(failures, [])
        self.assertEqual({name.split("/")[0] for name in alone}, set(output_cases.CASES))
        self.assertEqual(rows_on(most_threads()), (alone, []))

    def test_a_class_without_a_case_is_a_failure(self):
        case = output_cases.CASES.pop("vtkPlateModelReader")
        try:
            _, failures = record_outputs.record(re.compile("^$"), is_mpi=False)
        finally:
            output_cases.CASES["vtkPlateModelReader"] = case
        self.assertEqual(len(failures), 1)
        self.assertIn("vtkPlateModelReader", failures[0])

    def test_a_run_with_an_error_is_a_failure(self):
        case = output_cases.CASES["vtkSurfaceShape"]
        output_cases.CASES["vtkSurfaceShape"] = output_cases.Filter(lambda filter_: filter_.SetInputData(
            output_cases.with_holes()))
        try:
            rows, failures = record_outputs.record(re.compile("^vtkSurfaceShape/default"), False)
        finally:
            output_cases.CASES["vtkSurfaceShape"] = case
        self.assertEqual((len(rows), len(failures)), (0, 1))

    def test_settings_for_a_property_that_there_is_not_are_a_failure(self):
        needs = output_cases.CASES["vtkAdaptiveSphere"].needs
        needs["Density=None"] = needs["Density=Array"]
        try:
            _, failures = record_outputs.record(re.compile("^$"), is_mpi=False)
        finally:
            del needs["Density=None"]
        self.assertEqual(len(failures), 1)
        self.assertIn("vtkAdaptiveSphere/Density=None", failures[0])

    def test_each_change_shows_in_its_row(self):
        surface = copy_of(output_cases.mapped())
        surface.GetFieldData().AddArray(surface.GetPointData().GetArray("Height"))
        before = rows_of(surface)

        def changed_rows(change):
            changed = copy_of(surface)
            change(changed)
            return {line.split(None, 1)[1] for line in record_outputs.differences(before, rows_of(changed))}

        def set_value(array):
            array.SetComponent(5, 0, array.GetComponent(5, 0) + 1.0)
        self.assertEqual(changed_rows(lambda data: None), set())
        self.assertEqual(changed_rows(lambda data: set_value(data.GetPoints().GetData())), {"a/points"})
        self.assertEqual(changed_rows(lambda data: data.ReverseCell(7)), {"a/cells"})
        self.assertEqual(changed_rows(lambda data: set_value(data.GetPointData().GetArray("Label"))),
                         {"a/point data", "a/point data/Label"})
        self.assertEqual(changed_rows(lambda data: set_value(data.GetCellData().GetArray("Part"))),
                         {"a/cell data", "a/cell data/Part"})
        self.assertEqual(changed_rows(lambda data: set_value(data.GetFieldData().GetArray("Height"))),
                         {"a/field data", "a/field data/Height"})
        self.assertEqual(changed_rows(lambda data: data.GetPointData().SetActiveScalars("Height")),
                         {"a/point data", "a/point data/Height", "a/point data/RGB"})
        self.assertEqual(changed_rows(lambda data: data.GetPointData().GetArray("Height").SetName("Altitude")),
                         {"a/point data/Height", "a/point data/Altitude"})

    def test_names_that_were_changed_count_as_equal(self):
        before = {"vtkA/Lattice=Geodesic/port0/field data/Polished": "1", "vtkA/default/port0/points": "2"}
        now = {"vtkB/MeshType=Geodesic/port0/field data/Polished": "1", "vtkB/default/port0/points": "2"}
        names = [("vtkA", "vtkB"), ("Lattice", "MeshType")]
        self.assertEqual(record_outputs.renamed(before, names), now)
        self.assertEqual(list(record_outputs.differences(record_outputs.renamed(before, names[:1]), now)),
                         ["missing  vtkB/Lattice=Geodesic/port0/field data/Polished",
                          "new      vtkB/MeshType=Geodesic/port0/field data/Polished"])
        with self.assertRaisesRegex(ValueError, "no row has the name Latt"):
            record_outputs.renamed(before, [("Latt", "Mesh")])
        with self.assertRaisesRegex(ValueError, "two rows"):
            record_outputs.renamed({"a/x": "1", "a/y": "1"}, [("x", "y")])

    def test_comparing_names_the_rows_and_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "before.txt")
            options = ["--classes", "^vtkGeodesicSphereSource/small$"]
            self.assertEqual(record_outputs.main([*options, "--output", path]), 0)
            for spoil, status, text in ((lambda lines: lines, 0, "0 of them"),
                                        (lambda lines: lines[:-1], 1, "new      vtkGeodesicSphereSource/small/"),
                                        (lambda lines: [lines[0][:-4] + "xyz\n", *lines[1:]], 1, "differs  "),
                                        (lambda lines: ["vtkGeodesicSphereSource/small/gone 0\n", *lines], 1,
                                         "missing  vtkGeodesicSphereSource/small/gone")):
                with open(path, encoding="utf-8") as file:
                    lines = file.readlines()
                with self.subTest(text):
                    spoiled = os.path.join(folder, "spoiled.txt")
                    with open(spoiled, "w", encoding="utf-8") as file:
                        file.writelines(spoil(lines))
                    printed = io.StringIO()
                    with contextlib.redirect_stdout(printed):
                        self.assertEqual(record_outputs.main([*options, "--compare", spoiled]), status)
                    self.assertIn(text, printed.getvalue())


if __name__ == "__main__":
    unittest.main()
