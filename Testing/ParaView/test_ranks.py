"""A cloud spread over processes gives the bits that one process gives, and those of plain VTK."""
import glob
import os
import subprocess
import sys
import tempfile
import unittest

from paraview import simple

import scenes

FOLDER = os.path.dirname(os.path.abspath(__file__))
POINTS = 9001  # cannot be cut evenly
# What learn.py does, with the package conformalsom.
PLAIN = """
import hashlib, sys
from conformalsom import *
from vtkmodules.util.numpy_support import vtk_to_numpy
scan, mesh, hull = vtkConformalPLYReader(), vtkConformalSOM(), vtkGenusZeroHull()
surface, painted = vtkCurvedSeamlessSurface(), vtkSphericalTextureMap()
scan.SetFileName(sys.argv[1])
mesh.SetNumberOfNeurons(1442)
hull.SetSpacing(0.04)
surface.SetFrequency(24)
for source, filter_ in (scan, mesh), (scan, hull), (mesh, surface), (surface, painted):
    filter_.SetInputConnection(source.GetOutputPort())
print("digest", end="")
for filter_ in mesh, hull, painted:
    filter_.Update()
    points = vtk_to_numpy(filter_.GetOutput().GetPoints().GetData())
    print("", hashlib.sha256(points.tobytes()).hexdigest(), end="")
"""


def said(command, **environment):
    """What a program prints, as a dictionary from the first word of a line to the others."""
    run = subprocess.run(command, env=dict(os.environ, **environment), text=True, check=True,
                         timeout=300, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if "WARN|" in run.stderr or "ERR|" in run.stderr:
        raise AssertionError(run.stderr)  # an empty process is no reason to complain
    return {line.split()[0]: line.split()[1:] for line in run.stdout.splitlines() if line.strip()}


def learned(scan, ranks, threads):
    return said([os.environ["MPIEXEC"], "-np", str(ranks), "pvbatch",
                 os.path.join(FOLDER, "learn.py"), scan],
                VTK_SMP_BACKEND_IN_USE="STDThread", VTK_SMP_MAX_THREADS=str(threads))


class TestRanks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="ranks ")
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.ply = scenes.write_scan(cls.temporary.name, POINTS)
        cls.text = os.path.join(cls.temporary.name, "bear.asc")
        simple.SaveData(cls.text, simple.OpenDataFile(cls.ply))
        cls.expected = learned(cls.ply, 1, 1)["digest"]

    def test_same_bits_on_any_number_of_processes_and_threads(self):
        for ranks, threads in ((1, 2), (2, 1), (2, 2), (4, 1)):
            with self.subTest(ranks=ranks, threads=threads):
                self.assertEqual(learned(self.ply, ranks, threads)["digest"], self.expected)

    def test_every_process_reads_its_share(self):
        for scan in (self.ply, self.text):
            with self.subTest(scan):
                result = learned(scan, 4, 1)
                shares = [int(word) for word in result["points"]]
                self.assertEqual(sum(shares), POINTS)
                self.assertLess(max(shares), 1.05 * POINTS / 4)
                self.assertEqual(result["digest"], self.expected)

    def test_same_bits_as_plain_vtk(self):
        package = os.environ["CONFORMALSOM_PYTHON"]
        if not glob.glob(os.path.join(package, "conformalsom", "vtkIOSurface*.so")):
            self.skipTest(f"the Python package is not built in {package}")
        plain = said(["/usr/bin/python3", "-c", PLAIN, self.ply], PYTHONPATH=package)
        self.assertEqual(plain["digest"], self.expected)


if __name__ == "__main__":
    if not os.access(os.environ.get("MPIEXEC", ""), os.X_OK):
        print("mpirun is not installed")
        sys.exit(125)
    unittest.main()
