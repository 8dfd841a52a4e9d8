"""learn.py SCAN: under pvbatch, print digests of the mesh, the hull and the painted surface made
from a scan, and the number of the scan's points in each process. test_ranks.py runs it on several.
"""
import hashlib
import sys

from paraview import servermanager
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def digest(filter_):
    points = servermanager.Fetch(filter_).GetPoints().GetData()
    return hashlib.sha256(vtk_to_numpy(points).tobytes()).hexdigest()


scan = simple.OpenDataFile(sys.argv[1])
mesh = simple.ConformalSOM(Input=scan, NumberOfNeurons=1442)
hull = simple.GenusZeroHull(Input=scan, Spacing=0.04)
surface = simple.CurvedSeamlessSurface(Input=mesh, Frequency=24)
painted = simple.SphericalTextureMap(Input=surface)
print("digest", *(digest(filter_) for filter_ in (mesh, hull, painted)))
ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
port = scan.SMProxy.GetOutputPort(0)
print("points", *(port.GetRankDataInformation(rank).GetNumberOfPoints() for rank in range(ranks)))
