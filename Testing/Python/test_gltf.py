"""glTF files are valid for the Khronos validator, and compressed ones contain the surface."""
import base64
import json
import os
import shutil
import struct
import subprocess
import tempfile
import unittest

import numpy as np

import conformalsom as cs
from conformalsom import exports

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "gltf_validation.js")
PACKAGES = ("gltf-validator@2.0.0-dev.3.10", "meshoptimizer@0.18.1")
ALLOWED = {"UNSUPPORTED_EXTENSION", "IMAGE_NPOT_DIMENSIONS"}  # the validator does not know EXT_meshopt_compression
LEVEL = ("UNUSED_OBJECT", "/nodes/1")  # nor MSFT_lod
AXES = np.array((1.0, 0.7, 1.3))


def painted_surface():
    """An ellipsoid with a picture."""
    random = np.random.default_rng(1)
    points = random.normal(size=(4000, 3))
    points = points / np.linalg.norm(points, axis=1)[:, None] * AXES
    surface = cs.learn(points, number_of_neurons=500).smooth(3000)
    return surface.paint(random.integers(0, 256, (16, 16, 3), dtype=np.uint8))


def document_of(path):
    """The JSON document and the binary buffer of a file."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack("<I", data[12:16])[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


class TestGLTF(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = cls.temporary.name
        cls.surface = painted_surface()
        cls.modes = ["None", "Quantized"] + ["Meshopt"] * cs.vtkTexturedSurfaceWriter.GetHasMeshopt()
        for mode in cls.modes:
            for picture in ("PNG", "JPEG"):
                writer = exports.writer_of(cls.surface, cls.path(mode, picture))
                getattr(writer, "SetCompressionTo" + mode)()
                getattr(writer, "SetTextureFormatTo" + picture)()
                writer.SetFileName(cls.path(mode, picture))
                assert writer.Write() == 1
            cls.write_details(mode)
        cls.expected = cs.Surface(exports.placed(cls.surface))

    @classmethod
    def write_details(cls, mode):
        """A file with a normal map and two levels of detail."""
        if "vtkSurfaceNormalMap" in cs.CLASSES_LEFT_OUT:
            return
        writer = exports.writer_of(cls.surface, cls.path(mode, "Details"))
        detailed = cs.vtkSurfaceNormalMap()
        detailed.SetInputData(exports.placed(cls.surface))
        detailed.SetDetailData(cls.surface.polydata)
        detailed.SetImageSize(64, 64)
        writer.SetInputConnection(0, detailed.GetOutputPort(1))
        writer.SetInputConnection(2, detailed.GetOutputPort(0))
        writer.AddLevelData(exports.placed(cls.surface))
        getattr(writer, "SetCompressionTo" + mode)()
        writer.SetFileName(cls.path(mode, "Details"))
        assert writer.Write() == 1

    @classmethod
    def path(cls, mode, picture="PNG"):
        return os.path.join(cls.folder, f"{mode}{picture}.glb")

    def quantized(self, document, values):
        """Positions of a file, by the transform of its node."""
        node = document["nodes"][0]
        return values[:, :3] * node["scale"] + node["translation"]

    def test_quantized_files_contain_the_surface(self):
        document, binary = document_of(self.path("Quantized"))
        self.assertIn("KHR_mesh_quantization", document["extensionsRequired"])
        view = document["bufferViews"][0]
        values = np.frombuffer(binary, np.uint16, view["byteLength"] // 2, view["byteOffset"]).reshape(-1, 4)
        found = self.quantized(document, values)
        self.assertLess(np.abs(found - self.expected.points).max(), 2.7 / 65535)
        normals = np.frombuffer(binary, np.int8, 4 * len(values), document["bufferViews"][1]["byteOffset"])
        normals = normals.reshape(-1, 4)[:, :3] / 127.0
        self.assertLess(np.abs(normals - self.expected.point_data["Normals"]).max(), 0.005)

    def test_compressed_files_are_smaller(self):
        sizes = [os.path.getsize(self.path(mode)) for mode in self.modes]
        self.assertLess(sizes[1], 0.75 * sizes[0])
        if len(sizes) == 3:
            self.assertLess(sizes[2], 0.35 * sizes[0])

    def test_details_are_tangents_a_normal_map_and_levels(self):
        if not os.path.exists(self.path("None", "Details")):
            self.skipTest("this build lacks vtkSurfaceNormalMap")
        document, binary = document_of(self.path("None", "Details"))
        self.assertEqual(document["nodes"][0]["extensions"]["MSFT_lod"]["ids"], [1])
        self.assertEqual(document["materials"][0]["normalTexture"]["index"], 1)
        for mesh in document["meshes"]:  # the second level has no tangents: the writer computes them
            attributes = mesh["primitives"][0]["attributes"]
            tangents, normals = (self.floats(document, binary, attributes[name], size)
                                 for name, size in (("TANGENT", 4), ("NORMAL", 3)))
            self.assertTrue((tangents[:, 3] == 1.0).all())
            self.assertLess(np.abs((tangents[:, :3] * normals).sum(axis=1)).max(), 1e-6)
            self.assertLess(np.abs(np.linalg.norm(tangents[:, :3], axis=1) - 1.0).max(), 1e-6)

    @staticmethod
    def floats(document, binary, accessor, size):
        """Numbers of an accessor, in rows."""
        view = document["bufferViews"][document["accessors"][accessor]["bufferView"]]
        return np.frombuffer(binary, np.float32, view["byteLength"] // 4, view["byteOffset"]).reshape(-1, size)

    def test_jpeg_is_a_jpeg(self):
        document, binary = document_of(self.path("None", "JPEG"))
        self.assertEqual(document["images"][0]["mimeType"], "image/jpeg")
        start = document["bufferViews"][document["images"][0]["bufferView"]]["byteOffset"]
        self.assertEqual(binary[start:start + 2], b"\xff\xd8")

    def test_meshopt_without_the_library_is_an_error(self):
        if cs.vtkTexturedSurfaceWriter.GetHasMeshopt():
            self.skipTest("this build has meshoptimizer")
        writer = exports.writer_of(self.surface, self.path("None"))
        writer.SetCompressionToMeshopt()
        writer.SetFileName(self.path("Refused"))
        self.assertEqual(writer.Write(), 0)
        self.assertFalse(os.path.exists(self.path("Refused")))

    def test_khronos_validator_and_decoder(self):
        if shutil.which("npm") is None:
            self.skipTest("there is no npm, so that the Khronos validator cannot be installed")
        install = subprocess.run(["npm", "install", "--prefix", self.folder, "--no-audit", "--no-fund", *PACKAGES],
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120, check=False)
        if install.returncode:
            self.skipTest("npm cannot install the Khronos validator: " + install.stdout.strip()[-200:])
        paths = [self.path(mode, picture) for mode in self.modes for picture in ("PNG", "JPEG", "Details")]
        paths = [path for path in paths if os.path.exists(path)]
        done = subprocess.run(["node", SCRIPT, os.path.join(self.folder, "node_modules"), *paths],
                              stdout=subprocess.PIPE, check=True)
        for path, result in zip(paths, json.loads(done.stdout)):
            with self.subTest(os.path.basename(path)):
                self.assertEqual([issue for issue in result["issues"] if issue["code"] not in ALLOWED
                                  and (issue["code"], issue["pointer"]) != LEVEL], [])
                if "Meshopt" in path and "Details" not in path:
                    self.expect_surface(document_of(path)[0], result["views"])

    def expect_surface(self, document, views):
        """Decoded views contain the points, in another sequence, with normals, coordinates and outward triangles."""
        raw = [base64.b64decode(view) for view in views[:4]]
        points = self.quantized(document, np.frombuffer(raw[0], np.uint16).reshape(-1, 4))
        normals = np.frombuffer(raw[1], np.int8).reshape(-1, 4)[:, :3] / 127.0
        corners = np.frombuffer(raw[3], np.uint32).reshape(-1, 3)
        self.assertEqual((len(points), len(corners)), (len(self.expected), len(self.expected.faces)))
        near = np.array([np.abs(self.expected.points - point).max(axis=1).argmin() for point in points])
        self.assertLess(np.abs(self.expected.points[near] - points).max(), 2.7 / 16383)
        self.assertGreater((normals * self.expected.point_data["Normals"][near]).sum(axis=1).min(), 0.99)
        a, b, c = points[corners].transpose(1, 0, 2)
        self.assertGreater(np.mean((np.cross(b - a, c - a) * (a + b + c)).sum(axis=1) > 0), 0.999)
        transform = document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"][
            "KHR_texture_transform"]
        st = np.frombuffer(raw[2], np.uint16).reshape(-1, 2) * transform["scale"] + transform["offset"]
        coordinates = self.expected.point_data["Texture Coordinates"] * (1, -1) + (0, 1)
        distance = [np.abs(coordinates[np.abs(self.expected.points - point).max(axis=1) < 4e-4] - place).max(axis=1).min()
                    for point, place in zip(points[::50], st[::50])]
        self.assertLess(max(distance), 1e-3)


if __name__ == "__main__":
    unittest.main()
