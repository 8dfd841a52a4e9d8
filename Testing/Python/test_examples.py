"""The examples run as programs, and Examples/README.md shows each with a picture and its command."""
import glob
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

import compare_surfaces

PYTHON = os.path.dirname(os.path.abspath(compare_surfaces.__file__))
EXAMPLES = os.path.dirname(PYTHON)
SCRIPTS = sorted(os.path.basename(path) for path in glob.glob(os.path.join(PYTHON, "*.py")))


def run(script, *arguments):
    """Run a program from a folder of its own, as a user would."""
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run([sys.executable, os.path.join(PYTHON, script), *arguments], cwd=folder,
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)


class TestExamples(unittest.TestCase):
    def test_every_program_explains_itself(self):
        self.assertIn("quickstart.py", SCRIPTS)
        for script in SCRIPTS:
            with self.subTest(script):
                completed = run(script, "--help")
                self.assertEqual((completed.returncode, completed.stderr), (0, ""))
                self.assertIn("usage: " + script, completed.stdout)

    def test_surfaces_are_compared_on_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            scan = os.path.join(folder, "ball.xyz")
            with open(scan, "w", encoding="ascii") as file:
                for i in range(2000):  # along a spiral from pole to pole
                    z, turn = (2 * i + 1) / 2000 - 1, 2.399963 * i
                    r = (1 - z * z) ** 0.5
                    file.write(f"{r * math.cos(turn)} {r * math.sin(turn)} {z}\n")
            completed = run(
                "compare_surfaces.py", scan, "--frequency", "4", "--surface-frequency", "12")
        self.assertEqual((completed.returncode, completed.stderr), (0, ""))
        rows = {line[:16].rstrip(): line[16:].split() for line in completed.stdout.splitlines()}
        for row in ("learned mesh", "butterfly", "Loop", "PN triangles",
                    *("CSS " + height for height in compare_surfaces.DOME_HEIGHTS)):
            self.assertIn(row, rows)
        self.assertEqual(rows["learned mesh"][0], "162")
        self.assertEqual(rows["CSS Fitted"][0], "1,442")
        self.assertLess(float(rows["CSS Curvature"][1]), float(rows["learned mesh"][1]))

    def test_surfaces_are_judged_by_points_held_out(self):
        completed = run("compare_surfaces.py", "--held-out", "--frequency", "8", "--surface-frequency", "20")
        self.assertEqual(completed.returncode, 0, completed.stderr)  # few neurons: it warns
        lines = completed.stdout.splitlines()
        for lattice in ("Geodesic", "Adaptive"):
            begin = next(i for i, line in enumerate(lines) if line.startswith(lattice))
            self.assertEqual(lines[begin].count("/"), 3)
            rows = {line[:16].rstrip(): line[16:].split() for line in lines[begin + 1:begin + 11]}
            best = [min(float(rows[name][k]) for name in compare_surfaces.RIVALS) for k in range(3)]
            for k, ratio in enumerate(rows["default / best"]):
                self.assertAlmostEqual(float(ratio), float(rows["CSS Curvature"][k]) / best[k], delta=0.02)

    def test_missing_scan_ends_with_a_message(self):
        completed = run("compare_surfaces.py", "missing.ply")
        self.assertEqual(completed.returncode, 1)
        self.assertEqual(completed.stderr, "compare_surfaces: missing.ply: no such file\n")

    def test_gallery_shows_each_with_picture_and_command(self):
        with open(os.path.join(EXAMPLES, "README.md"), encoding="utf-8") as file:
            sections = re.split(r"^## ", file.read(), flags=re.MULTILINE)[1:]
        commands = ""
        for section in sections:
            with self.subTest(section.partition("\n")[0]):
                pictures = re.findall(r"^!\[.+\]\((.+)\)$", section, flags=re.MULTILINE)
                self.assertEqual(len(pictures), 1)
                self.assertTrue(os.path.isfile(os.path.join(EXAMPLES, pictures[0])))
                commands += re.search(r"```sh\n(.+?)```", section, flags=re.DOTALL).group(1)
        for script in glob.glob(os.path.join(EXAMPLES, "*.sh")):
            self.assertIn("bash Examples/" + os.path.basename(script), commands)
        for project in os.listdir(os.path.join(EXAMPLES, "Cxx")):
            self.assertIn("-S Examples/Cxx/" + project, commands)
        for script in set(SCRIPTS) - {"quickstart.py"}:  # what quickstart.sh runs
            self.assertIn("python3 Examples/Python/" + script, commands)


if __name__ == "__main__":
    unittest.main()
