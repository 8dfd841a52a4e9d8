"""The package imports as one, knows its version, and documents every class."""
import glob
import os
import pydoc
import re
import sys
import unittest

import conformalsom
from conformalsom import *  # noqa: F401,F403 (a part of what is tested)

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def classes_of_modules():
    """Names of the classes that the headers of the VTK modules export."""
    for module in glob.glob(os.path.join(SOURCE, "*", "*", "vtk.module")):
        for header in glob.glob(os.path.join(os.path.dirname(module), "vtk*.h")):
            with open(header, encoding="ascii") as file:
                yield from re.findall(r"^class VTK\w+_EXPORT (vtk\w+)", file.read(), flags=re.M)


def methods_of(name):
    """The methods that the header of a class declares, also where Python derives from it."""
    class_ = getattr(conformalsom, name)
    return vars(getattr(sys.modules[class_.__module__], name))


def enumerations():
    """Classes, their properties that are enumerations, and the names of the values of each."""
    for name in classes_of_modules():
        values = {}
        for method in methods_of(name):
            match = re.fullmatch(r"Set([A-Z]\w*)To([A-Z]\w*)", method)
            if match:
                values.setdefault(match[1], []).append(match[2])
        for property_, names in values.items():
            yield name, property_, names


class TestPackage(unittest.TestCase):
    def test_star_import_brings_every_class(self):
        for name in classes_of_modules():
            self.assertIn(name, globals())

    def test_version_is_the_projects(self):
        with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="ascii") as file:
            version = re.search(r"project\(ConformalSOM\s+VERSION (\S+)", file.read()).group(1)
        self.assertEqual(conformalsom.__version__, version)

    def test_help_tells_what_a_class_does(self):
        for name in classes_of_modules():
            with self.subTest(name):
                text = pydoc.plain(pydoc.render_doc(getattr(conformalsom, name)))
                self.assertIn(f"{name} - ", text)

    def test_help_tells_what_a_property_means(self):
        for name in classes_of_modules():
            methods = methods_of(name)
            for method in methods:
                if method.startswith("Set") and "G" + method[1:] in methods:
                    with self.subTest(f"{name}.{method}"):
                        _, _, meaning = methods[method].__doc__.partition("\n\n")
                        self.assertNotEqual(meaning.strip(), "")

    def test_old_names_are_errors_that_have_the_new_ones(self):
        for class_name, old, new in (("vtkConformalSOM", "SetLatticeToAdaptive", "MeshType"),
                                     ("vtkConformalSOM", "GetFrequency", "NumberOfNeurons"),
                                     ("vtkCurvedSeamlessSurface", "SetPolished", "VertexShift"),
                                     ("vtkConformalSOM", "GenerateErrorScalarsOn", "the array QuantizationError"),
                                     ("vtkConformalSOM", "AutomaticPriorityOff", "always on"),
                                     ("vtkCurvedSeamlessMap", "SetSeamMode", "SeamMode of the vtkCurvedSeamless"),
                                     ("vtkGenusZeroHull", "SetIndicator", "Method"),
                                     ("vtkConsistentRemesh", "SetLattice", "MeshType"),
                                     ("vtkConsistentRemesh", "GetMeanShape", "MeanSurface"),
                                     ("vtkSphericalMorph", "SetLatticeToGeodesic", "MeshType"),
                                     ("vtkSurfaceHarmonics", "GetLattice", "MeshType")):
            with self.subTest(old), self.assertRaisesRegex(AttributeError, f"is now {new}"):
                getattr(getattr(conformalsom, class_name)(), old)
        for class_name, renamed in conformalsom.RENAMED.items():
            for old in renamed:
                self.assertFalse(hasattr(getattr(conformalsom, class_name), "Set" + old), old)
        with self.assertRaisesRegex(AttributeError, "no attribute 'SetNothing'"):
            conformalsom.vtkConformalSOM().SetNothing()

    def test_the_changelog_has_all_old_names(self):
        root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
        with open(os.path.join(root, "CHANGELOG.md"), encoding="utf-8") as file:
            rows = [line for line in file if line.startswith("| `vtk")]
        for class_name, renamed in conformalsom.RENAMED.items():
            for old in renamed:
                self.assertTrue(any(class_name in row and f"`{old}`" in row for row in rows), f"{class_name}, {old}")

    def test_every_class_is_made_and_printed(self):
        bases = {"vtkSurfaceFileReader", "vtkSurfaceFileWriter"}  # abstract
        for name in set(classes_of_modules()) - bases:
            with self.subTest(name):
                self.assertIn(name, str(getattr(conformalsom, name)()))

    def test_enumerations_are_printed_by_name(self):
        """A property with methods SetPropertyToName: str() shows the Name, for each of them."""
        found = 0
        for name, property_, values in enumerations():
            for value in values:
                with self.subTest(f"{name}: {property_} {value}"):
                    object_ = getattr(conformalsom, name)()
                    getattr(object_, f"Set{property_}To{value}")()
                    self.assertIn(f"{property_}: {value}", [line.strip() for line in
                                                            str(object_).splitlines()])
                    found += 1
        self.assertGreater(found, 30)

    def test_enumerations_keep_their_range(self):
        """Whatever number is set, the value is one that has a name."""
        for name, property_, values in enumerations():
            object_ = getattr(conformalsom, name)()
            named = set()
            for value in values:
                getattr(object_, f"Set{property_}To{value}")()
                named.add(getattr(object_, "Get" + property_)())
            for number in (-(2**31), -1, len(values), 255, 2**31 - 1):
                with self.subTest(f"{name}: {property_} {number}"):
                    getattr(object_, "Set" + property_)(number)
                    self.assertIn(getattr(object_, "Get" + property_)(), named)


if __name__ == "__main__":
    unittest.main()
