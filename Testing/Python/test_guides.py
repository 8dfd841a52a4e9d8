"""What the guides tell readers to run, runs: the snippets of Filters.md, each by itself, on inputs of the names
that it takes for given, and the tutorials from the first line to the last."""
import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkTrivialProducer
from vtkmodules.vtkIOImage import vtkPNGWriter

import conformalsom
from output_cases import ball_volume, label_map, outlines, torus
from helpers import hemispheres, textures
from helpers.builtin_figure import figure_cloud, figure_surface

HAS_THREE = os.path.exists("/usr/share/javascript/three/three.min.js")
ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))


def sections(guide):
    """The text of each section of a guide by its heading."""
    with open(os.path.join(ROOT, "Documentation", guide), encoding="utf-8") as file:
        texts = re.split(r"^## ", file.read(), flags=re.M)[1:]
    return {text.partition("\n")[0]: text for text in texts}


def blocks_of(text, languages="python"):
    """Its blocks of code in these languages, each with its language and without its indentation."""
    found = re.findall(rf"^( *)```({languages})\n(.*?)^ *```", text, flags=re.M | re.S)
    return [(language, re.sub(f"^{indent}", "", code, flags=re.M)) for indent, language, code in found]


def producer_of(data):
    """What puts out a data set as a reader does."""
    producer = vtkTrivialProducer()
    producer.SetOutput(data)
    return producer


def with_array(surface, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    surface.GetPointData().AddArray(array)
    return surface


def mapped_bear():
    """The bear on its map, with a number and marks at points."""
    conformal = conformalsom.vtkGlobalConformalMap()
    conformal.SetInputData(figure_surface())
    conformal.SetAreaBalance(0.5)
    conformal.Update()
    surface = conformal.GetOutput()
    points = vtk_to_numpy(surface.GetPoints().GetData())
    with_array(surface, "Curvature", points[:, 0] * points[:, 1])
    marks = np.zeros(len(points), dtype=np.int32)
    marks[[100, 2000, 4000]] = 1, 2, 3
    return with_array(surface, "Marks", marks)


def executable(path, flags):
    """Open a file that may be run."""
    return os.open(path, flags, 0o755)


class TestGuides(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cloud, bear = figure_cloud(8000), mapped_bear()
        colors = numpy_to_vtk(np.full((8000, 3), 90, dtype=np.uint8), deep=True)
        cloud.GetPointData().SetScalars(colors)
        network = conformalsom.vtkConformalSOM()
        network.SetInputData(cloud)
        network.SetNumberOfNeurons(1000)
        network.Update()
        surface = conformalsom.vtkCurvedSeamlessSurface()
        surface.SetInputConnection(network.GetOutputPort())
        surface.Update()
        painted = conformalsom.vtkSphericalTextureMap()
        painted.SetInputConnection(surface.GetOutputPort())
        painted.SetProjection(conformalsom.vtkSphericalTextureMap.OCTAHEDRAL)
        painted.Update()
        body = conformalsom.vtkBodyMap()
        body.SetInputData(bear)
        harmonics = conformalsom.vtkSurfaceHarmonics()
        harmonics.SetInputData(bear)
        names = ("reader", "mapped", "moved", "reference", "first", "second", "moving", "fixed", "target", "source")
        cls.given = {
            **{name: producer_of(bear) for name in names},
            "network": network, "surface": surface, "painted": painted, "body": body, "harmonics": harmonics,
            "mug": producer_of(torus()), "volume": ball_volume(), "label_picture": label_map(), "polygons": outlines(),
            "surfaces": [bear, bear], "poses": [bear, bear], "scan": producer_of(cloud),
            "front": producer_of(textures.rosette(64)), "back": producer_of(textures.wood(64)),
            "directions": numpy_to_vtk(np.eye(3), deep=True), "vtkDoubleArray": vtkDoubleArray,
            **{name: value for name, value in vars(conformalsom).items() if name.startswith("vtk")},
        }

    def test_every_section_has_a_snippet_that_runs(self):
        for heading, text in sections("Filters.md").items():
            with self.subTest(heading):
                (_, code), = blocks_of(text)
                self.run_snippet(heading, code)

    def run_snippet(self, heading, code):
        """Update what it made; no error, and outputs that are not empty."""
        names = dict(self.given)
        errors = []
        exec(compile(code, f"Filters.md, {heading}", "exec"), names)  # pylint: disable=exec-used
        made = [value for name, value in names.items()
                if isinstance(value, vtkAlgorithm) and value is not self.given.get(name)]
        kind = "vtk" + heading.replace(" ", "")
        self.assertIn(kind, code)
        for algorithm in made:
            for source in (algorithm, algorithm.GetExecutive()):
                source.AddObserver("ErrorEvent", lambda caller, _: errors.append(caller.GetClassName()))
            algorithm.Update()
            self.assertEqual(errors, [])
            output = algorithm.GetOutputDataObject(0)
            if isinstance(output, vtkPolyData):
                self.assertGreater(output.GetNumberOfPoints(), 0)

    def test_tutorials_run_to_their_end(self):
        """Those in Python and sh; Package.ServesAConsumer does what is said of C++."""
        run = 0
        for heading, text in sections("Tutorials.md").items():
            with self.subTest(heading), tempfile.TemporaryDirectory() as folder:
                os.symlink(os.path.join(ROOT, "Examples"), os.path.join(folder, "Examples"))
                # Of the Python with VTK. A link would lead out of a virtual environment.
                with open(os.path.join(folder, "python3"), "w", encoding="utf-8", opener=executable) as file:
                    file.write(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
                path = os.pathsep.join((folder, os.path.dirname(os.environ["CONFORMALSOM_COMMAND"]), os.environ["PATH"]))
                for language, code in blocks_of(text, "python|sh"):
                    program = [sys.executable] if language == "python" else ["bash", "-euo", "pipefail"]
                    completed = subprocess.run([*program, "-c", code], cwd=folder, text=True, stdout=subprocess.PIPE,
                                               stderr=subprocess.PIPE, check=False, env={**os.environ, "PATH": path})
                    self.assertEqual((completed.returncode, completed.stderr), (0, ""))
                    run += 1
        self.assertGreaterEqual(run, 5)

    def test_snippets_of_functions_run(self):
        """The README's snippet, and all of the guide for Python that import the functions but not PyVista."""
        snippets = []
        for guide in ("README.md", os.path.join("Documentation", "Python.md")):
            with open(os.path.join(ROOT, guide), encoding="utf-8") as file:
                snippets += [code for _, code in blocks_of(file.read())
                             if "import conformalsom as cs" in code and "pyvista" not in code]
        self.assertEqual(len(snippets), 4)
        for code in snippets:
            with self.subTest(code), tempfile.TemporaryDirectory() as folder:
                for name in ("scan.ply", "my-scan.ply"):
                    conformalsom.Surface(self.given["scan"].GetOutputDataObject(0)).save(os.path.join(folder, name))
                writer = vtkPNGWriter()
                writer.SetInputData(textures.rosette(64))
                writer.SetFileName(os.path.join(folder, "photo.png"))
                writer.Write()
                code = code.replace("smooth.show()", "smooth._repr_html_()" if HAS_THREE else "")
                completed = subprocess.run([sys.executable, "-c", code], cwd=folder, text=True, stdout=subprocess.PIPE,
                                           stderr=subprocess.PIPE, check=False)
                self.assertEqual((completed.returncode, completed.stderr), (0, ""))
                self.assertEqual("figure.glb" in code, "figure.glb" in os.listdir(folder))

    def test_cortical_surfaces_go_to_their_end(self):
        code = "".join(block for _, block in blocks_of(sections("Cortex.md")["Step by step"]))
        with tempfile.TemporaryDirectory() as folder:
            for i, deformation in enumerate((0.0, 0.15), 1):
                writer = conformalsom.vtkFreeSurferWriter()
                writer.SetInputData(hemispheres.hemisphere(12, deformation, i))
                writer.SetFileName(os.path.join(folder, f"lh{i}.white"))
                assert writer.Write() == 1
            code += "assert resample.GetOutput().GetPointData().HasArray('SulcalDepth')\n"
            completed = subprocess.run([sys.executable, "-c", code], cwd=folder, text=True, stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE, check=False)
            self.assertEqual((completed.returncode, completed.stderr), (0, ""))
            self.assertEqual(sorted(os.listdir(folder)), [
                "lh1.shape.gii", "lh1.sphere.surf.gii", "lh1.surf.gii", "lh1.white", "lh2.white"])


if __name__ == "__main__":
    unittest.main()
