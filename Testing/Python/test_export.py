"""Textured surfaces in other programs' files: glTF keeps the specification's rules, and what an
independent program (assimp, where it is installed) reads from .glb, .obj and .ply is the surface
with every corner at its place in the picture, v upwards; F3D, where it is installed, draws .glb as we do."""
import os
import shutil
import struct
import subprocess
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (draws everything)

from baselines import LEFT_OVERS
from helpers import textures
from helpers.builtin_figure import figure_cloud
from conformalsom import (
    vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap, vtkTexturedSurfaceWriter)
from conformalsom.command import pictures
from gltf_rules import faults

PROJECTIONS = ("STEREOGRAPHIC", "LONGITUDE_LATITUDE", "OCTAHEDRAL", "CUBE_MAP")
ASSIMP, F3D = shutil.which("assimp"), shutil.which("f3d")
POSITION, FOCAL_POINT, VIEW_UP, ANGLE, SIZE = (1.5, 0.8, 4.0), (0.0, 0.1, 0.0), (0.0, 1.0, 0.0), 40, 400


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
        network.SetNumberOfNeurons(642)
        cls.surface = vtkCurvedSeamlessSurface()
        cls.surface.SetInputConnection(network.GetOutputPort())
        cls.surface.SetFrequency(16)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def written(self, projection, extension, wrap="CLAMP", image=None):
        """The textured surface, and the file it was written to."""
        painted = vtkSphericalTextureMap()
        painted.SetInputConnection(self.surface.GetOutputPort())
        painted.SetProjection(getattr(vtkSphericalTextureMap, projection))
        painted.SetWrap(getattr(vtkSphericalTextureMap, wrap))
        painted.SplitSeamOn()
        writer = vtkTexturedSurfaceWriter()
        writer.SetInputConnection(painted.GetOutputPort())
        writer.SetTextureData(image or textures.numbered_grid(64))
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

    @unittest.skipUnless(F3D, "f3d is not installed")
    def test_f3d_draws_what_we_draw(self):
        """The same outline, and up to the light the same colors; those of a mirrored one are not."""
        image = textures.checkerboard(256)
        surface, path = self.written("OCTAHEDRAL", ".glb", image=image)
        drawn = os.path.join(LEFT_OVERS, "ExportF3D.png")
        os.makedirs(LEFT_OVERS, exist_ok=True)
        # So F3D 3 calls what was a dry run before: nobody's settings are read.
        told = subprocess.run([F3D, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
        subprocess.run(
            [F3D, path, "--no-config" if "--no-config" in told else "--dry-run", "--no-background", f"--output={drawn}", f"--resolution={SIZE},{SIZE}",
             *(f"--camera-{name}={','.join(map(str, vector))}" for name, vector in (
                 ("position", POSITION), ("focal-point", FOCAL_POINT), ("view-up", VIEW_UP))),
             f"--camera-view-angle={ANGLE}"], check=True, stdout=subprocess.DEVNULL)
        reader = vtkPNGReader()
        reader.SetFileName(drawn)
        theirs, ours = pixels_of(reader), pixels_of(drawing(surface, image))
        covered, expected = theirs[..., 3] > 128, ours[..., :3].max(axis=2) > 0
        self.assertGreater(expected.mean(), 0.1)
        self.assertGreater((covered & expected).sum() / (covered | expected).sum(), 0.98)

        def difference(image):
            """Of the colors' directions, away from borders and where light leaves some."""
            a, b = theirs[..., :3], image[..., :3]
            lit = (np.linalg.norm(a, axis=2) > 20) & (np.linalg.norm(b, axis=2) > 20)
            a, b = a[lit], b[lit]
            return np.median(np.linalg.norm(a / np.linalg.norm(a, axis=1)[:, None]
                                            - b / np.linalg.norm(b, axis=1)[:, None], axis=1))
        rows = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(256, 256, 3)[::-1] / 255.0
        mirrored = pixels_of(drawing(surface, textures.to_image(rows[:, ::-1])))
        self.assertLess(difference(ours), 0.05)
        self.assertGreater(difference(mirrored), 3 * difference(ours))


def drawing(surface, image):
    """A filter that puts out a picture of the surface with the image on it, on black."""
    camera = vtkCamera()
    camera.SetPosition(POSITION)
    camera.SetFocalPoint(FOCAL_POINT)
    camera.SetViewUp(VIEW_UP)
    camera.SetViewAngle(ANGLE)
    renderer = vtkRenderer()
    renderer.SetActiveCamera(camera)
    actor = pictures.textured_actor(surface, image)
    actor.GetProperty().SetSpecular(0.0)
    actor.GetProperty().SetAmbient(0.2)
    renderer.AddActor(actor)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    return grab


def pixels_of(source):
    """What a filter puts out, as rows from the top."""
    source.Update()
    image = source.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[::-1].astype(float)


if __name__ == "__main__":
    unittest.main()
