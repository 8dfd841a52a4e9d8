"""A surface and texts of files that several tests of the package use."""
import struct

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def torus(around=12, along=30):
    """A surface with a handle."""
    u, v = np.meshgrid(np.arange(along), np.arange(around), indexing="ij")
    s, t = 2.0 * np.pi * u / along, 2.0 * np.pi * v / around
    r = 1.0 + 0.4 * np.cos(t)
    points = np.stack((r * np.cos(s), r * np.sin(s), 0.4 * np.sin(t)), axis=-1).reshape(-1, 3)
    a, b = u * around + v, (u + 1) % along * around + v
    c, d = (u + 1) % along * around + (v + 1) % around, u * around + (v + 1) % around
    quads = np.stack((np.full_like(a, 4), a, b, c, d), axis=-1).reshape(-1, 5)
    cells = vtkCellArray()
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(quads.ravel().astype(np.int64), deep=1))
    made = vtkPolyData()
    made.SetPoints(vtkPoints())
    made.GetPoints().SetData(numpy_to_vtk(points, deep=1))
    made.SetPolys(cells)
    return made


def write_las(path, points, offset):
    """Write a LAS file of points plus an offset, rounded to multiples of 0.0001."""
    count = len(points)
    header = struct.pack("<4sHHIHH8sBB32s32sHHHIIBHI5I12d", b"LASF", 0, 0, 0, 0, 0, b"", 1, 2, b"", b"", 1, 2026, 227, 227,
                         0, 0, 20, count, count, 0, 0, 0, 0, *[1e-4] * 3, *offset, *[0.0] * 6)
    records = b"".join(struct.pack("<3i8x", *(round(1e4 * number) for number in point)) for point in points)
    with open(path, "wb") as file:
        file.write(header + records)


PLY = """ply
format ascii 1.0
element vertex 4
property {float} x
property {float} y
property {float} z
property {float} nx
property {float} ny
property {float} nz
property uchar red
property uchar green
property uchar blue
{alpha}property {float} s
property {float} t
property float confidence
element face 3
property list uchar int vertex_indices
property short flags
end_header
0 0 0 0 0 1 1 2 3 {opacity}0 0 0.5
1 0 0 0 0 1 1 2 3 {opacity}0 0 0.5
0 1 0 0 0 1 1 2 3 {opacity}0 0 nan
0 0 1 0 0 1 1 2 3 {opacity}0 0 0.5
3 0 1 2 7
3 0 2 3 7
3 0 1 1 7
"""
PLY_FILES = [PLY.format(float="float", alpha="", opacity="") + "more",
             PLY.format(float="double", alpha="property uchar alpha\n", opacity="4 ")]
SCAN = "\n".join(line for line in PLY_FILES[0].replace("nan", "1").splitlines()
                 if line not in ("3 0 1 1 7", "more")).replace("element face 3", "element face 2") + "\n"
OFF_FILES = ["STCNOFF\n3 1 0\n" + "".join(
    f"{point}  0 0 1  {color}  0 1\n" for point in ("0 0 0", "1 0 0", "0 1 0")) + face
             for color, face in (("1 0 0 1", "3 0 1 2 255 0 0 255\n"),
                                 ("1 0 0 1", "3 0 1 2 255 0 0\n"), ("1 0 0 1", "3 0 1 2 5\n"))]
OFF_FILES.append("OFF\n3 1 0\n0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 7 8 9\n3 0 1 2\n")
TEXT_FILES = ["0 0 0 0.5\n1 0 0 0.25\n", "0 0 0 0 0 1\n1 0 0 0 1 0\n",
              "0 0 0 1 2 3\n1 0 0 4 5 255\n", "0 0 0 1.5 2.5\n1 nan 0 3.5 4.5\nnot a point\n"]
PCD = """VERSION .7
FIELDS x y z normal_x normal_y normal_z {color} label
SIZE 4 4 4 4 4 4 4 2
TYPE F F F F F F U I
COUNT 1 1 1 1 1 1 1 1
WIDTH 2
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS 2
DATA ascii
0 0 0 0 0 1 66051 -1
7 8 9 0 0 1 16711680 32767
"""
GU_MESH = "".join(f"Vertex {i} {point} {{sph=({sphere}) rgb=(1 0 0) uv=(0 1) normal=(0 0 1)}}\n"
                  for i, point, sphere in ((1, "0 0 0", "0 0 1"), (2, "1 0 0", "1 0 0"),
                                           (3, "0 1 0", "0 1 0"))) + "Face 1 1 2 3 {rgb=(0 1 0)}\n"
