"""The package's type stubs: they have every class, method and text there is, and a checker finds mistakes by
them and none in the examples."""
import ast
import glob
import importlib.util
import inspect
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import vtkmodules

import conformalsom
import toy_bear

PACKAGE = os.path.dirname(os.path.abspath(conformalsom.__file__))
# mypy finds installed packages, and refuses their folder.
STUB_PATH = "" if "site-packages" in PACKAGE and "CONFORMALSOM_INSTALLED_WHEEL" in os.environ else os.path.dirname(PACKAGE)
# Those of the wheel vtk refuse what VTK accepts: names of events, references, tuples of numbers.
VTK_HAS_STUBS = os.path.exists(os.path.join(os.path.dirname(vtkmodules.__file__), "vtkCommonCore.pyi"))
PYTHON = os.path.dirname(os.path.abspath(toy_bear.__file__))
MODULES = sorted(name for name in vars(conformalsom) if name.startswith(("vtkFilters", "vtkIO"))
                 and inspect.ismodule(getattr(conformalsom, name)))
CLASSES = {name: class_ for module in MODULES for name, class_ in vars(getattr(conformalsom, module)).items()
           if inspect.isclass(class_)}
FUNCTIONS = """\
import numpy as np
import conformalsom as cs

points = np.zeros((500, 3))
surface = cs.learn(points, number_of_neurons=500, mesh_type="Geodesic", progress=print)
smooth = surface.smooth(64_000)
print(smooth.points.shape, smooth.faces.max(), smooth.sphere.mean(), smooth.quality["UncoveredFraction"])
smooth.paint("photo.png", view_direction=(0, 0, 1)).save("figure.glb")
registered = surface.register(smooth, landmarks=[(1, 2)], features=[("Supported", 1.0)])
mean = cs.mean_shape([surface, registered], progress=True)
print(smooth.posed(registered, [np.zeros((500, 3)), mean], align_rotation=False)[0].points.shape)
print(surface.harmonics(20).coefficients.shape, surface.warnings[0].lower())
tissue = cs.surface_from_volume(np.zeros((9, 9, 9)), spacing=(1.0, 1.0, 2.0), start=surface, smoothing=1.0)
series = cs.time_series([tissue, surface], time_interval=30.0, features=[("LayerMean", 1.0)])
print(series.table["AreaRate"].mean(), series.surfaces[0].layers("tissue.tif", projection="Mercator").maps.shape)
print(cs.conformal_map((mean.points, mean.faces)), cs.learn("scan.ply"), cs.learn([[1, 2, 3], [2, 3.5, 4]]))
"""
MISTAKES = [
    ("cs.learn(3.5)", 'incompatible type "float"'),
    ("cs.learn(points, neurons=3)", 'Unexpected keyword argument "neurons"'),
    ('cs.learn(points, mesh_type="geodesic")', "incompatible type \"Literal\\['geodesic'\\]\""),
    ('cs.learn(points, number_of_neurons="many")', 'incompatible type "str"; expected "int"'),
    ('cs.learn(points, progress="yes")', 'incompatible type "str"'),
    ("cs.lern(points)", 'no attribute "lern"'),
    ("cs.conformal_map(None)", 'incompatible type "None"'),
    ("cs.surface_from_volume()", 'Missing positional argument "volume"'),
    ("cs.time_series(surface)", 'incompatible type "Surface"'),
    ("cs.mean_shape(surface)", 'incompatible type "Surface"'),
    ("surface.smoth()", 'no attribute "smoth"'),
    ('surface.smooth("many")', 'incompatible type "str"'),
    ("surface.paint(7)", 'incompatible type "int"'),
    ('surface.paint("photo.png", view_up=1.0)', 'incompatible type "float"'),
    ("surface.save(3)", 'incompatible type "int"'),
    ("surface.register()", 'Missing positional argument "fixed"'),
    ("surface.register(surface, landmarks=[1])", 'incompatible type "int"'),
    ("surface.harmonics(20).coeficients", 'no attribute "coeficients"'),
    ("surface.points = points", "read-only"),
    ("surface.warnings.lower()", 'no attribute "lower"'),
]
INHERITED = {"IsA", "IsTypeOf", "GetNumberOfGenerationsFromBase", "GetNumberOfGenerationsFromBaseType"}


def stub_of(module):
    """The classes of a stub by their names, parsed."""
    with open(os.path.join(PACKAGE, module + ".pyi"), encoding="utf-8") as file:
        return {node.name: node for node in ast.parse(file.read()).body if isinstance(node, ast.ClassDef)}


def methods_of(class_):
    """The first definition of each method of a parsed class."""
    found = {}
    for node in class_.body:
        if isinstance(node, ast.FunctionDef):
            found.setdefault(node.name, node)
    return found


STUBS = {name: node for module in MODULES for name, node in stub_of(module).items()}


def plain(text):
    """Words alone, whatever the lines."""
    return " ".join((text or "").split())


class TestStubs(unittest.TestCase):
    def method(self, class_, name):
        return methods_of(STUBS[class_])[name]

    def types(self, class_, name):
        """What a method takes and gives."""
        node = self.method(class_, name)
        arguments = [ast.unparse(argument.annotation) for argument in node.args.posonlyargs[1:]]
        return [*arguments, ast.unparse(node.returns)]

    def test_has_every_class_with_its_text(self):
        self.assertEqual(set(STUBS), set(CLASSES))
        for name, class_ in CLASSES.items():
            with self.subTest(name):
                self.assertEqual(plain(ast.get_docstring(STUBS[name])), plain(class_.__doc__))

    def test_has_every_method_and_constant(self):
        for name, class_ in CLASSES.items():
            with self.subTest(name):
                wrapped = {member for member, value in vars(class_).items() if not member.startswith("__")
                           and (inspect.isroutine(value) or inspect.isgetsetdescriptor(value))}
                stubbed = {member for member in methods_of(STUBS[name]) if not member.startswith("__")}
                self.assertEqual(stubbed, wrapped - INHERITED)
                constants = {member for member, value in vars(class_).items() if isinstance(value, int)}
                self.assertEqual({node.target.id for node in STUBS[name].body if isinstance(node, ast.AnnAssign)},
                                 constants)

    def test_names_types(self):
        self.assertEqual(self.types("vtkConformalSOM", "SetNumberOfNeurons"), ["int", "None"])
        self.assertEqual(self.types("vtkConformalSOM", "GetNumberOfNeurons"), ["int"])
        self.assertEqual(self.types("vtkConformalSOM", "SetStartData"),
                         ["Optional[vtkmodules.vtkCommonDataModel.vtkPolyData]", "None"])
        self.assertEqual(self.types("vtkConformalSOM", "SetPriorityArrayName"), ["Optional[str]", "None"])
        self.assertEqual(self.types("vtkSphericalTextureMap", "SetViewUp"), ["float", "float", "float", "None"])
        self.assertEqual(self.types("vtkSphericalTextureMap", "GetViewUp"), ["Tuple[float, float, float]"])
        self.assertEqual(self.types("vtkSphericalTextureMap", "SetSplitSeam"), ["bool", "None"])
        overloads = [ast.unparse(node.args) for node in STUBS["vtkSphericalTextureMap"].body
                     if isinstance(node, ast.FunctionDef) and node.name == "SetViewUp"]
        self.assertEqual(overloads[1], "self, value: Values[float], /")

    def test_every_argument_and_result_has_a_type(self):
        for class_ in STUBS.values():
            for node in ast.walk(class_):
                if isinstance(node, ast.FunctionDef) and node.name != "__init__":
                    with self.subTest(f"{class_.name}.{node.name}"):
                        self.assertIsNotNone(node.returns)
                        for argument in node.args.posonlyargs:
                            self.assertTrue(argument.annotation or argument.arg == "self")

    def test_all_methods_of_a_property_have_its_text(self):
        meaning = plain(conformalsom.vtkConformalSOM.SetMeshType.__doc__.partition("\n\n")[2])
        self.assertIn("GEODESIC", meaning)
        for name in "SetMeshType", "GetMeshType", "SetMeshTypeToAdaptive", "GetMeshTypeMaxValue":
            self.assertEqual(plain(ast.get_docstring(self.method("vtkConformalSOM", name))), meaning)
        meaning = plain(conformalsom.vtkSphericalTextureMap.SetSplitSeam.__doc__.partition("\n\n")[2])
        self.assertEqual(plain(ast.get_docstring(self.method("vtkSphericalTextureMap", "SplitSeamOn"))), meaning)
        self.assertIn("A closed mesh of genus zero", ast.get_docstring(self.method("vtkConformalSOM", "SetStartConnection")))
        self.assertIsNone(ast.get_docstring(self.method("vtkConformalSOM", "NewInstance")))
        silent = [f"{name}.{method}" for name, class_ in STUBS.items() for method, node in methods_of(class_).items()
                  if re.match("[GS]et", method) and not ast.get_docstring(node)]
        self.assertEqual(silent, [])


@unittest.skipUnless(importlib.util.find_spec("mypy"), "there is no mypy")
class TestChecker(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def check(self, *paths, path=STUB_PATH):
        """What mypy finds wrong, a line each; the package is in the folder path."""
        command = [sys.executable, "-m", "mypy", "--ignore-missing-imports", "--check-untyped-defs", "--no-error-summary",
                   "--disable-error-code=var-annotated", "--disable-error-code=assignment",
                   "--cache-dir", os.path.join(self.temporary.name, "cache")]
        run = subprocess.run([*command, *paths], cwd=PYTHON, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             env={**os.environ, "MYPYPATH": path}, check=False)
        self.assertEqual(run.stderr, "")
        self.assertEqual(run.returncode, 1 if run.stdout else 0)
        return run.stdout.splitlines()

    @unittest.skipIf(VTK_HAS_STUBS, "VTK's stubs refuse what VTK accepts")
    def test_examples_and_package_are_right(self):
        self.assertEqual(self.check(*sorted(glob.glob(os.path.join(PYTHON, "*.py")))), [])
        self.assertEqual(self.check("-p", "conformalsom"), [])

    @unittest.skipIf(VTK_HAS_STUBS, "VTK's stubs refuse what VTK accepts")
    def test_sources_of_functions_are_right(self):
        """Without the stubs that hide them."""
        copied = os.path.join(self.temporary.name, "sources")
        shutil.copytree(PACKAGE, os.path.join(copied, "conformalsom"), ignore=lambda _, names: {
            name for name in names if name in ("functions.pyi", "surface.pyi") or name.endswith(".so")})
        self.assertEqual(self.check("-p", "conformalsom", path=copied), [])

    def test_functions_are_used_rightly(self):
        path = os.path.join(self.temporary.name, "right.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(FUNCTIONS)
        self.assertEqual(self.check(path), [])

    def test_mistakes_in_calls_of_functions_are_found(self):
        path = os.path.join(self.temporary.name, "mistaken.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write("import numpy as np\nimport conformalsom as cs\n")
            for i, (mistake, _) in enumerate(MISTAKES):
                file.write(f"def f{i}(points: np.ndarray, surface: cs.Surface) -> None:\n    {mistake}\n")
        found = [line for line in self.check(path) if ": error: " in line]
        for i, (mistake, message) in enumerate(MISTAKES):
            with self.subTest(mistake):
                [line] = [line for line in found if f"mistaken.py:{2 * i + 4}:" in line]
                self.assertRegex(line, message)

    def test_mistakes_are_found(self):
        with open(os.path.join(PYTHON, "quickstart.py"), encoding="utf-8") as file:
            right = file.read()
        for place, (old, new, message) in enumerate((
                ("painted.SplitSeamOn()", "painted.SplitSeemOn()", '"vtkSphericalTextureMap" has no attribute "SplitSeemOn"'),
                ("scan.SetFileName(", "scan.SetFilename(", '"vtkConformalPLYReader" has no attribute "SetFilename"'),
                ("mesh.SetInputConnection(", "mesh.SetInputConection(", 'has no attribute "SetInputConection"'),
                ("painted.SplitSeamOn()", 'painted.SetMargin("0.1")', 'incompatible type "str"; expected "float"'),
                ("painted.SplitSeamOn()", "painted.SetSplitSeam()", 'Too few arguments for "SetSplitSeam"'),
                ("vtkConformalSOM,", "vtkConformalSom,", 'has no attribute "vtkConformalSom"'),
                ("painted.SplitSeamOn()", "painted.GetViewUp().x", 'has no attribute "x"'),
                ("painted.SplitSeamOn()", "mesh.GetNumberOfNeurons().lower()", '"int" has no attribute "lower"'))):
            with self.subTest(new):
                path = os.path.join(self.temporary.name, f"mistaken{place}.py")  # mypy may keep what it found in a file
                self.assertIn(old, right)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(right.replace(old, new))
                self.assertIn(message, "\n".join(self.check(path)))


if __name__ == "__main__":
    unittest.main()
