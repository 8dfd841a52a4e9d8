"""Scans from files of VTK's formats: .obj files have the vertices, colors and polygons of the file, what is broken is
refused, and points that are not finite are left out with their triangles."""
import os
import struct
import tempfile
import unittest
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOGeometry import vtkSTLReader, vtkSTLWriter

import conformalsom
from conformalsom.command import cleaning, obj_files, scan_files, shape_steps, stl_files
from conformalsom.command.steps import StepFailed, Steps
from conformalsom.messages import heard
from test_command import colored, egg, hues, points_of, write

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def corners_of(data):
    """Ids of points of all polygons, as lists."""
    polygons = data.GetPolys()
    ends, ids = (vtk_to_numpy(array) for array in (polygons.GetOffsetsArray(), polygons.GetConnectivityArray()))
    return [ids[begin:end].tolist() for begin, end in zip(ends[:-1], ends[1:])]


class Folder(unittest.TestCase):
    """A folder for each test."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def file(self, content, name):
        """The path of a new file."""
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)
        return path


class TestOBJ(Folder):
    def read(self, text):
        """What is in a file with this text, and the warning."""
        return obj_files.read(self.file(text, "scan.obj"))

    def test_polygons_of_all_kinds(self):
        corners = [[0, 1, 2], [0, 1, 2, 3]]
        for polygons in ("f 1 2 3\nf 1 2 3 4\n", "f -4 -3 -2\nf -4 -3 -2 -1\n",
                         "f 1/1 2/5 3/1\nf 1//1 2//1 3//1 4//1\n", "f 1/1/1 2/2/1 3/3/1\nf 1 2 \\\n3 4",
                         "\tf 1 2 3 # text\nf\t1 2 3 \\\r\n 4\r\n", "g a\nf 1 2 3\ns 1\nf 1 2 3 4"):
            with self.subTest(polygons):
                data, warning = self.read(f"# four\n{TRIANGLE}  v 5e-1 .5 2 # last\nvt 0 0\nvn 0 0 1\n{polygons}")
                self.assertEqual(points_of(data).tolist(), [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.5, 0.5, 2]])
                self.assertEqual((corners_of(data), warning), (corners, ""))
        data, _ = self.read("f 1 2 3\n" + TRIANGLE.replace("\n", "\r"))  # polygons first, and lines as on old systems
        self.assertEqual(corners_of(data), [[0, 1, 2]])
        data, _ = self.read(TRIANGLE + "f -3 -2 -1\n" + TRIANGLE + "f -3 -2 -1\n")
        self.assertEqual(corners_of(data), [[0, 1, 2], [3, 4, 5]])

    def test_what_cannot_be_read_is_refused_with_its_line(self):
        for line, rows in ((4, "v nan 0 0"), (4, "v 1 inf 0"), (4, "v 1,5 0,2 0"), (4, "v 0.5 a 2"), (4, "v 0.1"),
                           (4, "v"), (4, "v 0 0 0 1 0 x"), (5, "# text\nf 1 2 4"), (4, "f 0 1 2"), (4, "f -4 1 2"),
                           (5, "f 1 2 3\nf 1 2"), (4, "f 1 x 3"), (4, "f 1 2 /3"), (4, "f 1 2 99999999999999999999"),
                           (6, "f 1 2 \\\n3\nf 1 2 9")):
            with self.subTest(rows), self.assertRaisesRegex(ValueError, f"^line {line}: "):
                self.read(TRIANGLE + rows + "\n")

    def test_reader_and_function_report_the_line(self):
        path = self.file(TRIANGLE + "v 1,5 0,2 0\n", "scan.obj")
        reader = scan_files.scan_reader(path)
        with heard(reader) as messages:
            reader.Update()
        self.assertEqual(messages.errors, ["line 4: expected three finite numbers with decimal points, not 1,5 0,2 0"])
        with self.assertRaisesRegex(ValueError, "scan.obj: line 4: "):
            conformalsom.learn(path)
        with self.assertRaises(FileNotFoundError):
            conformalsom.learn(path + "x.obj")

    def test_colors_are_fractions_or_bytes(self):
        """With alpha, and in the order of the vertices."""
        for colors, expected in ((("1 0 0.5", "0 .2 1"), [[255, 0, 128], [0, 51, 255]]),
                                 (("1 0 0.5 1", "0 .2 1 1"), [[255, 0, 128], [0, 51, 255]]),
                                 (("1 0 128", "0 51 255"), [[1, 0, 128], [0, 51, 255]])):
            data, warning = self.read("".join(f"v {i} 0 0 {color}\n" for i, color in enumerate(colors)))
            self.assertEqual(vtk_to_numpy(data.GetPointData().GetScalars()).tolist(), expected)
            self.assertEqual((data.GetPointData().GetScalars().GetName(), warning), ("RGB", ""))
        for weights in ("", " 2"):
            self.assertIsNone(self.read(f"v 0 0 0{weights}\n")[0].GetPointData().GetScalars())

    def test_colors_of_a_part_are_not_used(self):
        path = self.file("v 0 0 0 1 1 1\n" + TRIANGLE, "scan.obj")
        reader = scan_files.scan_reader(path)
        with heard(reader) as messages:
            reader.Update()
        self.assertEqual(messages.warnings, ["colors are not used, since only 1 of 4 vertices have one"])
        self.assertIsNone(reader.GetOutput().GetPointData().GetScalars())
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            texts = []
            conformalsom.inputs.read(path, texts)
        self.assertEqual([warning.category for warning in caught], [conformalsom.FilterWarning])
        self.assertEqual(texts, [str(warning.message) for warning in caught])

    def test_textured_surface_is_closed(self):
        mesh = egg(3)
        text = "".join("v {!r} {!r} {!r}\n".format(*point) for point in points_of(mesh).tolist())
        text += "".join(f"vt 0 {i}\n" for i in range(3)) + "".join(
            "f {}/1 {}/2 {}/3\n".format(*(i + 1 for i in ids)) for ids in corners_of(mesh))
        reader = scan_files.scan_reader(self.file(text, "scan.obj"))
        reader.Update()
        self.assertEqual(points_of(reader.GetOutput()).tolist(), points_of(mesh).astype(np.float32).tolist())
        self.assertTrue(shape_steps.is_closed(reader.GetOutput(), Steps()))

    def test_normals_of_a_cloud(self):
        data, _ = self.read("v 0 0 0\nvn 0 0 1\nv 1 0 0\nvn 0 1 0\n")
        self.assertEqual(vtk_to_numpy(data.GetPointData().GetNormals()).tolist(), [[0, 0, 1], [0, 1, 0]])
        self.assertIsNone(self.read("v 0 0 0\nvn 0 0 1\nv 1 0 0\n")[0].GetPointData().GetNormals())

    def test_coordinates_of_maps_keep_their_digits(self):
        data, _ = self.read("v 500000.25 5400000.125 0\nv 500001 5400001 1\n")
        self.assertEqual(points_of(data)[0].tolist(), [500000.25, 5400000.125, 0])


class TestSTL(Folder):
    def setUp(self):
        super().setUp()
        writer = vtkSTLWriter()
        write(writer, egg(2), self.folder, "text.stl")
        writer.SetFileTypeToBinary()
        write(writer, egg(2), self.folder, "binary.stl")
        self.text, self.binary = (self.content(name) for name in ("text.stl", "binary.stl"))

    def content(self, name):
        with open(os.path.join(self.folder, name), "rb") as file:
            return file.read()

    def test_whole_files_are_read(self):
        named = b"solid made by a program".ljust(80) + self.binary[80:]
        for content, times in ((self.text, 1), (self.text.replace(b"solid", b"SOLID", 1), 1), (self.text.upper(), 1),
                               (b"\n " + self.text, 1), (self.text.replace(b"\n", b"\r\n"), 1), (self.binary, 1),
                               (named, 1), (2 * self.text, 2)):
            with self.subTest(content[:10]):
                reader = scan_files.scan_reader(self.file(content, "scan.stl"))
                reader.Update()
                self.assertEqual(reader.GetOutput().GetNumberOfPolys(), times * egg(2).GetNumberOfPolys())

    def test_points_and_triangles_are_those_of_vtk(self):
        for name in ("text.stl", "binary.stl"):
            path = os.path.join(self.folder, name)
            expected, (found, _) = vtkSTLReader(), stl_files.read(path)
            expected.SetFileName(path)
            expected.Update()
            self.assertEqual(points_of(found).tolist(), points_of(expected.GetOutput()).tolist())
            self.assertEqual([list(ids) for ids in corners_of(found)],
                             [list(ids) for ids in corners_of(expected.GetOutput())])

    def test_triangles_with_equal_corners_are_left_out(self):
        rows = "vertex 0 0 0\nvertex 1 0 0\nvertex {} 0\nendloop\n"
        path = self.file("solid\n" + rows.format("0 1") + rows.format("1 -0") + "endsolid\n", "scan.stl")
        data, _ = stl_files.read(path)
        self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfPolys()), (3, 1))

    def test_coordinates_of_maps_keep_their_digits(self):
        rows = "vertex 5400000.125 0 0\nvertex 5400001 0 0\nvertex 5400000 1 0\nendloop\nendsolid\n"
        data, _ = stl_files.read(self.file("solid\n" + rows, "scan.stl"))
        self.assertEqual(points_of(data)[0].tolist(), [5400000.125, 0, 0])

    def test_other_files_are_refused(self):
        named = b"solid made by a program".ljust(80) + self.binary[80:]
        fewer = self.binary[:80] + struct.pack("<I", 10) + self.binary[84:]
        for content, message in ((self.binary[:-1], "incomplete"), (named[:-50], "incomplete"),
                                 (self.binary + bytes(100), "100 bytes follow the 80 triangles"),
                                 (fewer, "3,500 bytes follow the 10 triangles"), (b"", "not an STL file"),
                                 (b"a text", "not an STL file"), (b"solid a\nendsolid a\n", "not an STL file"),
                                 *((self.text[:size], "line|incomplete") for size in range(300, len(self.text) - 20, 397)),
                                 (self.text.replace(b"vertex ", b"vertex a", 1), "line 4: expected three numbers"),
                                 (self.text.replace(b"   vertex", b"   point", 1), "line 7: expected a triangle")):
            with self.subTest(content[:10], size=len(content)), self.assertRaisesRegex(ValueError, message):
                stl_files.read(self.file(content, "scan.stl"))


class TestCleaning(unittest.TestCase):
    def test_others_are_left_out_with_their_triangles(self):
        mesh = egg(3)
        points = points_of(mesh)
        colored(mesh, hues(points), mesh.GetPointData())
        numbers = numpy_to_vtk(np.arange(mesh.GetNumberOfPolys()), deep=True)
        numbers.SetName("Number")
        mesh.GetCellData().AddArray(numbers)
        self.assertIs(cleaning.kept(mesh, Steps()), mesh)
        whole = corners_of(mesh)
        bad = [0, 17, len(points) - 1]
        vtk_to_numpy(mesh.GetPoints().GetData())[bad, [0, 1, 2]] = np.nan, np.inf, -np.inf
        steps = Steps()
        result = cleaning.kept(mesh, steps)
        self.assertEqual(steps.warnings, ["Read the scan: 3 of 92 points are not finite, and are left out"])
        left = np.setdiff1d(np.arange(len(points)), bad)
        self.assertEqual(points_of(result).tolist(), points[left].tolist())
        self.assertEqual(vtk_to_numpy(result.GetPointData().GetScalars()).tolist(), hues(points[left]).tolist())
        expected = [i for i, ids in enumerate(whole) if not set(ids) & set(bad)]
        self.assertEqual(vtk_to_numpy(result.GetCellData().GetArray("Number")).tolist(), expected)
        self.assertEqual([left[ids].tolist() for ids in corners_of(result)], [whole[i] for i in expected])

    def test_cells_of_too_few_points_are_left_out_with_their_numbers(self):
        mesh, steps = egg(3), Steps()
        whole = corners_of(mesh)
        polygons = vtkCellArray()
        for ids in ((0,), *whole, (3, 4), ()):
            polygons.InsertNextCell(len(ids), ids)
        lines = vtkCellArray()
        lines.InsertNextCell(1, (5,))
        mesh.SetPolys(polygons)
        mesh.SetLines(lines)
        numbers = numpy_to_vtk(np.arange(mesh.GetNumberOfCells()), deep=True)
        numbers.SetName("Number")
        mesh.GetCellData().AddArray(numbers)
        result = cleaning.kept(mesh, steps)
        self.assertEqual(steps.warnings, ["Read the scan: 4 cells have too few points, and are left out"])
        self.assertEqual((corners_of(result), result.GetNumberOfLines()), (whole, 0))
        self.assertEqual(vtk_to_numpy(result.GetCellData().GetArray("Number")).tolist(), [*range(2, 2 + len(whole))])
        self.assertEqual(points_of(result).tolist(), points_of(mesh).tolist())
        self.assertIs(cleaning.kept(result, Steps()), result)

    def test_cells_that_refer_to_missing_points_are_named(self):
        for wrong in (92, 10**9, -1):
            mesh, lines = egg(3), vtkCellArray()
            lines.InsertNextCell(2, (5, 6))
            mesh.SetLines(lines)
            vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())[5] = wrong
            with self.assertRaisesRegex(StepFailed, f"Read the scan: cell 2 refers to point {wrong} of 92"):
                cleaning.kept(mesh, Steps())
        self.assertEqual(cleaning.wrong_id(vtkPolyData()), "")

    def test_cell_arrays_without_a_tuple_for_each_cell_are_kept_for_the_filter(self):
        mesh, numbers = egg(3), numpy_to_vtk(np.zeros(5), deep=True)
        mesh.GetPolys().InsertNextCell(2, (3, 4))
        numbers.SetName("Number")
        mesh.GetCellData().AddArray(numbers)
        self.assertEqual(cleaning.with_whole_cells(mesh), (mesh, ""))

    def test_no_point_is_finite(self):
        mesh = egg(1)
        vtk_to_numpy(mesh.GetPoints().GetData())[:] = np.nan
        result = cleaning.kept(mesh, Steps())
        self.assertEqual((result.GetNumberOfPoints(), result.GetNumberOfCells()), (0, 0))
        self.assertEqual(cleaning.kept(vtkPolyData(), Steps()).GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
