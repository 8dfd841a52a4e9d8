"""Tables of classes and properties in the README and the guides are those of the classes."""
import os
import sys
import unittest

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(SOURCE, "Wrapping", "Describe"))
import describe
import tables


class TestTables(unittest.TestCase):

    def test_documents_have_them(self):
        for path, _, difference in tables.differences():
            with self.subTest(path):
                self.fail(f"{path} differs from the classes:\n{difference}\nWrite it anew by\n  {tables.RENEW}")

    def test_classes_are_named_in_the_order_that_there_was(self):
        old = "| `vtkB` | once |\n| `vtkGone` | once |\n| `vtkA` | once |\n"
        self.assertEqual(tables.class_rows(old, {"vtkA": "a", "vtkB": "b", "vtkC": "c"}),
                         "| `vtkB` | b |\n| `vtkA` | a |\n| `vtkC` | c |\n")

    def test_properties_have_defaults_and_values(self):
        classes = describe.classes()
        table = tables.property_table(classes["vtkGlobalConformalMap"])
        self.assertIn("| `Method` | Robust | Robust, GuYau |\n", table)
        self.assertIn("| `AreaBalance` | 0 | 0 to 1 |\n", table)
        self.assertIn("| `MaximumNumberOfIterations` | 5,000 | at least 0 |\n", table)
        table = tables.property_table(classes["vtkSphericalRegistration"])
        self.assertIn("| `Landmarks` | none | any number of (2 integers) |\n", table)
        self.assertIn("| `Features` | none | any number of (text, number) |\n", table)
        self.assertEqual(tables.property_table(classes["vtkGenusZeroCheck"]), "")

    def test_a_section_has_one_table_at_its_end(self):
        classes = {"vtkGenusZeroRepair": describe.classes()["vtkGenusZeroRepair"]}
        text = "# Filters\n\n## Genus Zero Repair\n\nText.\n\n## Other\n\nText.\n"
        once = tables.renewed_guide(text, classes)
        table = tables.property_table(classes["vtkGenusZeroRepair"])
        self.assertEqual(once, text.replace("\n## Other", table + "\n## Other"))
        self.assertEqual(tables.renewed_guide(once, classes), once)


if __name__ == "__main__":
    unittest.main()
