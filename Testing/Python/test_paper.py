"""The paper's tables and figures: every row and every picture is made, on the built-in model with few
points; on the scans, where they are there, batch learning beats online learning by far."""
import contextlib
import io
import os
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np

import conformalsom
import paper_figures
import paper_tables
from baselines import require_display
from helpers import paper_models

HAS_GCM = hasattr(conformalsom, "vtkGlobalConformalMap")
METHODS = ("online, as published", "online, plain SOM", "online", "batch", "batch, conformal r", "batch, adaptive", "GCM Gu-Yau",
           "GCM robust")


def run(program, *arguments):
    """What a program prints, on small meshes."""
    text = io.StringIO()
    with mock.patch.object(sys, "argv", [program.__name__, *arguments]), \
            mock.patch.object(paper_models, "FEW", 3000), \
            mock.patch.object(paper_models.learned, "__defaults__", ("Batch", "Automatic", "Geodesic", 10)), \
            mock.patch.object(paper_models.smooth, "__defaults__", (False, "Directions", 20)), \
            contextlib.redirect_stdout(text):
        program.main()
    return text.getvalue()


class TestPaper(unittest.TestCase):
    def test_every_row_is_filled(self):
        with tempfile.TemporaryDirectory() as nothing:
            text = run(paper_tables, "--data", nothing)
        self.assertIn("the built-in bear stands in", text)
        for row in ("X_few", *METHODS, *(method + " + CSS" for method in METHODS)):
            lines = [line for line in text.splitlines() if line[:27].rstrip() == row]
            with self.subTest(row):
                self.assertGreaterEqual(len(lines), 2)  # for each unit
                for line in lines:
                    if "Gu-Yau" not in row and (HAS_GCM or "GCM" not in row):
                        self.assertNotIn("none", line)

    def test_a_conformal_map_keeps_right_angles(self):
        bear = paper_models.models("nowhere")[0]
        plain = paper_models.smooth(paper_models.learned(bear.more, frequency=16), frequency=32)
        deviation = paper_tables.checkerboard_deviation(plain, *bear.view)
        self.assertTrue(0.0 < deviation < 30.0)
        if HAS_GCM:
            conformal = paper_models.smooth(paper_models.mapped(bear.mesh), frequency=32)
            self.assertLess(paper_tables.checkerboard_deviation(conformal, *bear.view), 2.0)

    def test_cracks_are_those_of_the_curves(self):
        """Two parabolas over an edge, one of them drawn to one end; and a learned mesh."""
        places = np.linspace(0.0, 1.0, 1001)
        arc = places, 4.0 * places * (1.0 - places)
        self.assertEqual(paper_tables.crack((arc, arc)), 0.0)
        self.assertAlmostEqual(paper_tables.crack((arc, (places, 0.5 * arc[1]))), 0.5, delta=1e-9)
        drawn = places**2, arc[1]  # 4 sqrt(x) (1 - sqrt(x)) at x
        difference = np.abs(4.0 * np.sqrt(places) * (1.0 - np.sqrt(places)) - arc[1]).max()
        self.assertAlmostEqual(paper_tables.crack((arc, drawn)), difference, delta=1e-3)
        bear = paper_models.models("nowhere")[0]
        mean, largest = paper_tables.cracks(paper_models.learned(bear.more, frequency=8), 50)
        self.assertTrue(0.05 < mean < largest <= 1.0)

    def test_every_figure_is_drawn(self):
        figures = ("7", "8", "9", "10", "11") if HAS_GCM else ("9", "10")
        with tempfile.TemporaryDirectory() as folder:
            run(paper_figures, "--data", folder, "--output", folder, "--figures", *figures)
            self.assertEqual(sorted(os.listdir(folder)),
                             sorted(f"figure_{int(figure):02}.jpg" for figure in figures))

    @unittest.skipUnless(os.path.isfile(os.path.join(paper_models.DATA, "igea.ply")), "no scans")
    def test_batch_learning_is_fifty_times_closer(self):
        """From the same points, with the same surface."""
        for model in paper_models.models(paper_models.DATA):
            with self.subTest(model.name):
                worse, better = (
                    paper_tables.errors(paper_models.smooth(paper_models.learned(model.more, mode)),
                                        model.more, "MaxRadius")[0] for mode in ("Online", "Batch"))
                self.assertGreater(worse, 50.0 * better)


if __name__ == "__main__":
    require_display()
    unittest.main()
