"""ParaView's window, driven through its menus: a scan opened, learned, smoothed and painted."""
import os
import subprocess
import tempfile
import unittest

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


class TestGui(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="window ")
        folder = cls.temporary.name
        scenes.write_scan(folder, 60000)
        scenes.write_picture(folder)
        with open(os.path.join(folder, "record.py"), "w", encoding="ascii") as file:
            file.write(RECORD)
        environment = dict(os.environ, PARAVIEW_TEST_DIR=folder, PARAVIEW_DATA_ROOT=folder,
                           HOME=folder, XDG_RUNTIME_DIR=folder)
        cls.completed = subprocess.run(
            ["paraview", "--disable-registry", "--script=" + os.path.join(folder, "record.py"),
             "--test-script=" + os.path.join(FOLDER, "guide.xml"), "--exit"],
            env=environment, timeout=500, text=True, check=False,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

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


if __name__ == "__main__":
    require_display()
    unittest.main()
