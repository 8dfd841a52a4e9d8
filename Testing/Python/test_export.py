"""Textured surfaces in other programs' files: glTF keeps the specification's rules, and what an
independent program (assimp, where it is installed) reads from .glb, .obj and .ply is the surface
with every corner at its place in the picture, v upwards."""
import os
import shutil
import struct
import subprocess
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from helpers import textures
from helpers.builtin_figure import figure_cloud
from conformalsom import (
    vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap, vtkTexturedSurfaceWriter)
from gltf_rules import faults

PROJECTIONS = ("STEREOGRAPHIC", "LONGITUDE_LATITUDE", "OCTAHEDRAL", "CUBE_MAP")
ASSIMP = shutil.which("assimp")


def corners_of_obj(path):
    """Position and texture coordinates of every corner, in the order of the file."""
    positions, coordinates, corners = [], [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                positions.append([float(w) for w in words[1:4]])
            elif words[:1] == ["vt"]:
                coordinates.append([float(w) for w in words[1:3]])
            elif words[:1] == ["f"]:
                corners += [[int(i) - 1 for i in word.split("/")[:2]] for word in words[1:]]
    corners = np.array(corners)
    return np.hstack([np.array(positions)[corners[:, 0]], np.array(coordinates)[corners[:, 1]]])


class TestExport(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        network = vtkConformalSOM()
        network.SetInputData(figure_cloud(4000))
        network.SetFrequency(8)
        cls.surface = vtkCurvedSeamlessSurface()
        cls.surface.SetInputConnection(network.GetOutputPort())
        cls.surface.SetFrequency(16)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def written(self, projection, extension, wrap="CLAMP"):
        """The textured surface, and the file it was written to."""
        painted = vtkSphericalTextureMap()
        painted.SetInputConnection(self.surface.GetOutputPort())
        painted.SetProjection(getattr(vtkSphericalTextureMap, projection))
        painted.SetWrap(getattr(vtkSphericalTextureMap, wrap))
        painted.SplitSeamOn()
        writer = vtkTexturedSurfaceWriter()
        writer.SetInputConnection(painted.GetOutputPort())
        writer.SetTextureData(textures.numbered_grid(64))
        writer.SetRepeatTexture(wrap == "REPEAT")
        writer.SetFileName(os.path.join(self.temporary.name, projection + extension))
        self.assertEqual(writer.Write(), 1)
        return painted.GetOutput(), writer.GetFileName()

    def test_gltf_keeps_the_rules(self):
        for projection in PROJECTIONS:
            for wrap in ("CLAMP", "REPEAT", "MIRROR"):
                with self.subTest(f"{projection} {wrap}"):
                    _, path = self.written(projection, ".glb", wrap)
                    with open(path, "rb") as file:
                        self.assertEqual(faults(file.read()), [])

    def test_the_rules_tell_broken_files(self):
        surface, path = self.written("OCTAHEDRAL", ".glb")
        with open(path, "rb") as file:
            good = file.read()
        first = struct.pack("<III", *vtk_to_numpy(surface.GetPolys().GetConnectivityArray())[:3])
        size = struct.unpack("<I", good[12:16])[0]
        binary = 20 + size + 8
        broken = {
            "magic": b"glTG" + good[4:],
            "cut short": good[:-4],
            "version": good[:4] + struct.pack("<I", 1) + good[8:],
            "a position that is not finite": good[:binary] + struct.pack("<f", np.nan) + good[binary + 4:],
            "a position beyond max": good[:binary] + struct.pack("<f", 1e9) + good[binary + 4:],
            "an index too large": good.replace(first, struct.pack("<III", 10**6, 1, 2), 1),
            "another asset": good.replace(b'"version":"2.0"', b'"version":"1.0"'),
            "a sampler's number": good.replace(b'"wrapS":33071', b'"wrapS":33070'),
            "another count": good.replace(b'"type":"VEC2"', b'"type":"VEC3"'),
            "no picture": good.replace(b"\x89PNG", b"\x89PNX"),
        }
        for what, data in broken.items():
            with self.subTest(what):
                self.assertNotEqual(data, good)
                self.assertNotEqual(faults(data), [])

    @unittest.skipUnless(ASSIMP, "assimp is not installed")
    def test_assimp_reads_the_same_from_every_format(self):
        for projection in PROJECTIONS:
            for extension in (".glb", ".obj", ".ply"):
                with self.subTest(projection + extension):
                    surface, path = self.written(projection, extension)
                    again = os.path.join(self.temporary.name, "again.obj")
                    subprocess.run([ASSIMP, "export", path, again], check=True,
                                   stdout=subprocess.DEVNULL)
                    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
                    positions = vtk_to_numpy(surface.GetPoints().GetData())[corners]
                    coordinates = vtk_to_numpy(surface.GetPointData().GetTCoords())[corners]
                    difference = corners_of_obj(again) - np.hstack([positions, coordinates])
                    self.assertLess(np.abs(difference).max(), 1e-5)


if __name__ == "__main__":
    unittest.main()
