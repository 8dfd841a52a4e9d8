"""The bear painted in a script, and again from a saved state."""
import os
import sys
import tempfile
import unittest

from paraview import servermanager, smstate
from paraview import simple

import scenes
from baselines import expect_picture

class TestPictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="paint ")
        cls.folder = cls.temporary.name
        scan, picture = scenes.write_scan(cls.folder), scenes.write_picture(cls.folder)
        cls.painted = scenes.open_and_paint(scan, picture)
        simple.SaveState(cls.path("state.pvsm"))
        with open(cls.path("state.py"), "w", encoding="ascii") as file:
            file.write(smstate.get_state())
        scenes.draw(cls.path("painted.png"))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    def test_bear_is_painted(self):
        expect_picture(self, scenes.picture_of(self.path("painted.png")), "ParaViewBear")

    def test_picture_is_laid_by_the_active_texture_coordinates(self):
        surface = servermanager.Fetch(self.painted)
        self.assertEqual(surface.GetPointData().GetTCoords().GetName(), "Texture Coordinates")
        self.assertEqual(simple.GetDisplayProperties(self.painted).SelectTCoordArray,
                         "Texture Coordinates")

    def test_replays_to_the_same_picture(self):
        """In a process of its own, which knows nothing but the file."""
        for name in ("state.pvsm", "state.py"):
            with self.subTest(name):
                scenes.replay(self.path(name), self.path(name + ".png"))
                with open(self.path(name + ".png"), "rb") as again:
                    with open(self.path("painted.png"), "rb") as first:
                        self.assertEqual(again.read(), first.read())


if __name__ == "__main__":
    if not os.environ.get("DISPLAY"):
        print("Pictures need a display: run ctest under xvfb-run")
        sys.exit(125)
    unittest.main()
