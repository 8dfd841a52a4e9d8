"""ParaView's window, driven through its menus: a scan opened, learned, smoothed and painted."""
import os
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from vtkmodules.util.numpy_support import vtk_to_numpy

import scenes
from baselines import expect_picture, require_display

FOLDER = os.path.dirname(os.path.abspath(__file__))
# Tools > Start Trace; what was recorded is written when the window saves its state.
RECORD = """
import os
from paraview import servermanager, smtrace
def write(*_):
    with open(os.path.join(os.environ["PARAVIEW_TEST_DIR"], "window.py"), "w") as file:
        file.write(smtrace.get_current_trace_output())
servermanager.ProxyManager().SMProxyManager.AddObserver("SaveStateEvent", write)
smtrace.start_trace()
"""


def drive(folder, events):
    """Start a ParaView, and lead it through events."""
    with open(os.path.join(folder, "record.py"), "w", encoding="ascii") as file:
        file.write(RECORD)
    environment = dict(os.environ, PARAVIEW_TEST_DIR=folder, PARAVIEW_DATA_ROOT=folder,
                       HOME=folder, XDG_RUNTIME_DIR=folder)
    return subprocess.run(
        ["paraview", "--disable-registry", "--script=" + os.path.join(folder, "record.py"),
         "--test-script=" + os.path.join(FOLDER, events), "--exit"],
        env=environment, timeout=500, text=True, check=False,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


class TestGui(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="window ")
        scenes.write_scan(cls.temporary.name, 60000)
        scenes.write_picture(cls.temporary.name)
        cls.completed = drive(cls.temporary.name, "guide.xml")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_menus_lead_there(self):
        self.assertEqual(self.completed.returncode, 0, self.completed.stdout)
        self.assertNotIn("critical", self.completed.stdout)

    def test_replays_to_the_same_picture(self):
        """The saved state and the recorded script, without the window."""
        for name in ("window.pvsm", "window.py"):
            with self.subTest(name):
                file = os.path.join(self.temporary.name, name)
                scenes.replay(file, file + ".png")
                expect_picture(self, scenes.picture_of(file + ".png"), "ParaViewWindow")


class TestOneClick(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="window ")
        scenes.write_scan(cls.temporary.name, 4000, colored=True)
        cls.completed = drive(cls.temporary.name, "one_click.xml")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_the_menu_leads_there_without_errors(self):
        self.assertEqual(self.completed.returncode, 0, self.completed.stdout)
        for word in ("critical", "ERR|"):
            self.assertNotIn(word, self.completed.stdout)

    def saved(self, type_, name):
        """The values of a property of all proxies of a type in the saved state."""
        state = ElementTree.parse(os.path.join(self.temporary.name, "one_click.pvsm"))
        return [element.get("value")
                for proxy in state.iter("Proxy") if proxy.get("type") == type_
                for property_ in proxy.iter("Property") if property_.get("name") == name
                for element in property_.iter("Element")]

    def test_scan_and_surface_have_no_color_map(self):
        self.assertEqual(self.saved("GeometryRepresentation", "MapScalars"), ["0", "0"])
        self.assertEqual(self.saved("ScalarBarWidgetRepresentation", "Visibility"), ["0"])

    def test_replays_in_the_colors_of_the_scan(self):
        """The bear becomes redder to the right, and only redder, in the saved state and the recorded script."""
        for name in ("one_click.pvsm", "window.py"):
            with self.subTest(name):
                file = os.path.join(self.temporary.name, name)
                scenes.replay(file, file + ".png")
                image = scenes.picture_of(file + ".png").GetOutput()
                width, height, _ = image.GetDimensions()
                pixels = vtk_to_numpy(image.GetPointData().GetScalars())[:, :3].reshape(height, width, 3).astype(float)
                bear = abs(pixels - pixels[0, 0]).sum(axis=2) > 30
                self.assertGreater(bear.mean(), 0.1)
                columns = bear.any(axis=0).nonzero()[0]
                middle = (columns[0] + columns[-1]) // 2
                left, right = (pixels[:, part][bear[:, part]].mean(axis=0) for part in
                               (slice(0, middle), slice(middle, width)))
                red, *others = abs(right - left)
                self.assertGreater(right[0], left[0])
                self.assertGreater(red, 2 * max(others), (left, right))


if __name__ == "__main__":
    require_display()
    unittest.main()
