"""What holds for the wheel only: its files, its check of VTK, its writer of pages, its command."""
import glob
import importlib.metadata
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import conformalsom
from vtkmodules.vtkCommonCore import vtkVersion

FOLDER = os.path.dirname(conformalsom.__file__)
COMMAND = os.path.join(os.path.dirname(sys.executable), "conformalsom")
# Reports another version of VTK, as if that were installed.
IMPORT_WITH_VERSION = """
import vtkmodules.vtkCommonCore as core
class Other:
    GetVTKVersion = staticmethod(lambda: "{}")
core.vtkVersion = Other
import conformalsom
"""
IMPORT_WITHOUT_VTK = """
import sys
sys.modules["vtkmodules"] = None
import conformalsom
"""


def run(*arguments):
    """Run Python in a process of its own."""
    return subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=False)


class TestWheel(unittest.TestCase):
    def test_is_installed_from_a_wheel(self):
        self.assertIn("site-packages", FOLDER)
        self.assertEqual(importlib.metadata.version("conformalsom"), conformalsom.__version__)

    def test_contains_only_the_package(self):
        names = {path.parts[0] for path in importlib.metadata.files("conformalsom")
                 if ".." not in path.parts and not path.parts[0].endswith(".dist-info")}
        self.assertEqual(names, {"conformalsom"})

    @unittest.skipIf(conformalsom.CLASSES_LEFT_OUT, "Stubs are made of all classes")
    def test_has_stubs_for_editors(self):
        for name in ("py.typed", "__init__.pyi", "_types.pyi", "vtkFiltersConformal.pyi", "vtkIOSurface.pyi"):
            self.assertTrue(os.path.exists(os.path.join(FOLDER, name)), name)

    def test_libraries_are_those_of_the_wheel_vtk(self):
        if not sys.platform.startswith("linux"):
            self.skipTest("Only Linux lists the libraries of a process")
        with open("/proc/self/maps", encoding="utf-8") as file:
            libraries = {line.split()[-1] for line in file if "libvtk" in line}
        folders = {os.path.dirname(path) for path in libraries}
        expected = {FOLDER, os.path.join(os.path.dirname(FOLDER), "vtkmodules")}
        self.assertEqual(folders, expected)

    def test_needs_no_library_of_the_system_it_was_built_on(self):
        if not shutil.which("readelf"):
            self.skipTest("readelf is not installed")
        tables = [subprocess.run(["readelf", "--dynamic", path], capture_output=True, text=True, check=True).stdout
                  for path in glob.glob(os.path.join(FOLDER, "*.so"))]
        needed = set(re.findall(r"NEEDED.*\[(.*)\]", "".join(tables)))
        others = {name for name in needed if not re.match(r"libvtk|lib(c|m|stdc\+\+|gcc_s|pthread|dl)\.so|ld-linux", name)}
        self.assertIn("libc.so.6", needed)
        self.assertEqual(others, set())

    def test_compresses_by_its_own_meshoptimizer(self):
        self.assertTrue(conformalsom.vtkTexturedSurfaceWriter.GetHasMeshopt())
        for name in ("meshoptimizer", "three.js"):
            with open(os.path.join(FOLDER, "licenses", name + ".txt"), encoding="utf-8") as file:
                self.assertIn("Permission is hereby granted", file.read())

    def test_refuses_another_version_of_vtk(self):
        for version in ("9.1.0", "9.5.2", "9.7.0", "10.6.2"):
            completed = run("-c", IMPORT_WITH_VERSION.format(version))
            self.assertEqual(completed.returncode, 1)
            self.assertIn(f"ImportError: This wheel of conformalsom was built for vtk 9.6, and vtk {version} is installed",
                          completed.stderr)
            self.assertIn("pip install 'vtk==9.6.*'", completed.stderr)
        self.assertEqual(run("-c", IMPORT_WITH_VERSION.format(vtkVersion.GetVTKVersion())).returncode, 0)

    def test_explains_that_vtk_is_missing(self):
        completed = run("-c", IMPORT_WITHOUT_VTK)
        self.assertEqual(completed.returncode, 1)
        self.assertIn("ImportError: conformalsom needs the package vtk", completed.stderr)

    def test_writes_a_page_with_its_own_three_js(self):
        with tempfile.TemporaryDirectory() as folder:
            page = os.path.join(folder, "page.html")
            completed = subprocess.run(
                [COMMAND, scan(folder), "--neurons", "162", "-o", page], capture_output=True, text=True, check=False)
            self.assertEqual(completed.returncode, 0, completed.stderr)
            self.assertGreater(os.path.getsize(page), 150000)  # three.js alone has more, deflated

    def test_command_prints_its_version(self):
        completed = subprocess.run([COMMAND, "--version"], capture_output=True, text=True, check=True)
        self.assertIn(conformalsom.__version__, completed.stdout)


def scan(folder):
    """Write points of an ellipsoid as text; return the path."""
    from conformalsom import vtkGeodesicSphereSource
    source = vtkGeodesicSphereSource()
    source.SetFrequency(12)
    source.Update()
    points = source.GetOutput().GetPoints()
    path = os.path.join(folder, "ellipsoid.xyz")
    with open(path, "w", encoding="ascii") as file:
        for place in range(points.GetNumberOfPoints()):
            x, y, z = points.GetPoint(place)
            file.write(f"{x} {0.8 * y} {0.6 * z}\n")
    return path


if __name__ == "__main__":
    unittest.main()
