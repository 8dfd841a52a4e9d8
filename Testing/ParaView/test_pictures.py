"""The bear painted in a script, and again from a saved state."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest

import numpy as np
from paraview import servermanager, smstate
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import scenes
from baselines import expect_picture, require_display
GUIDE = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                     "..", "..", "Documentation", "ParaView.md")


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
        scenes.draw(cls.path("chain.png"))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    def test_bear_is_painted(self):
        expect_picture(self, scenes.picture_of(self.path("chain.png")), "ParaViewBear")

    def test_picture_is_laid_by_the_active_texture_coordinates(self):
        surface = servermanager.Fetch(self.painted)
        self.assertEqual(surface.GetPointData().GetTCoords().GetName(), "Texture Coordinates")
        self.assertEqual(simple.GetDisplayProperties(self.painted).SelectTCoordArray,
                         "Texture Coordinates")

    def test_replays_to_the_same_picture(self):
        for name in ("state.pvsm", "state.py"):
            with self.subTest(name):
                scenes.replay(self.path(name), self.path(name + ".png"))
                with open(self.path(name + ".png"), "rb") as again:
                    with open(self.path("chain.png"), "rb") as first:
                        self.assertEqual(again.read(), first.read())

    def test_script_of_the_guide(self):
        with open(GUIDE, encoding="ascii") as file:
            script = re.search("```python\n(.*?)```", file.read(), re.DOTALL).group(1)
        script = script.replace("PLUGINS", os.environ["PV_PLUGIN_PATH"])
        for name, its_name in (("bear.ply", "igea.ply"), ("rosette.png", "picture.png")):
            shutil.copy(self.path(name), self.path(its_name))
        with open(self.path("paint.py"), "w", encoding="ascii") as file:
            file.write(script)
        subprocess.run(["pvbatch", "paint.py"], cwd=self.folder, check=True)
        picture = scenes.picture_of(self.path("painted.png")).GetOutput()
        colors = np.unique(vtk_to_numpy(picture.GetPointData().GetScalars()), axis=0)
        self.assertGreater(len(colors), 1000)  # those of the light on the rosette


if __name__ == "__main__":
    require_display()
    unittest.main()
