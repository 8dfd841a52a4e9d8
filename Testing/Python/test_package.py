"""The package imports as one, knows its version, and documents every class."""
import os
import pydoc
import re
import unittest

import conformalsom
from conformalsom import *  # noqa: F401,F403 (a part of what is tested)

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def listed_classes():
    """The classes in the lists of the modules."""
    for folder in ("Filters/Conformal", "IO/Surface"):
        with open(os.path.join(SOURCE, folder, "CMakeLists.txt"), encoding="ascii") as file:
            yield from re.search(r"set\(classes([^)]*)\)", file.read()).group(1).split()


class TestPackage(unittest.TestCase):
    def test_star_import_brings_every_class(self):
        for name in listed_classes():
            self.assertIn(name, globals())

    def test_version_is_the_projects(self):
        with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="ascii") as file:
            version = re.search(r"project\(ConformalSOM\s+VERSION (\S+)", file.read()).group(1)
        self.assertEqual(conformalsom.__version__, version)

    def test_help_tells_what_a_class_does(self):
        for name in listed_classes():
            with self.subTest(name):
                text = pydoc.plain(pydoc.render_doc(getattr(conformalsom, name)))
                self.assertIn(f"{name} - ", text)

    def test_help_tells_what_a_property_means(self):
        for name in listed_classes():
            methods = vars(getattr(conformalsom, name))
            for method in methods:
                if method.startswith("Set") and "G" + method[1:] in methods:
                    with self.subTest(f"{name}.{method}"):
                        _, _, meaning = methods[method].__doc__.partition("\n\n")
                        self.assertNotEqual(meaning.strip(), "")

    def test_every_class_is_made_and_printed(self):
        bases = {"vtkSurfaceFileReader", "vtkSurfaceFileWriter"}  # abstract
        for name in set(listed_classes()) - bases:
            with self.subTest(name):
                self.assertIn(name, str(getattr(conformalsom, name)()))


if __name__ == "__main__":
    unittest.main()
