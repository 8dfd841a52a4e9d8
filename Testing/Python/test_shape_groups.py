"""The permutation test of groups: its statistic is that of an analysis of variance, p is uniform without an effect,
and small where there is one. Tables of groups that do not fit the scans are refused."""
import itertools
import os
import tempfile
import unittest

import numpy as np

from conformalsom.command import shape_groups

HALVES = ["a"] * 6 + ["b"] * 6
STUDIES = 300
PERMUTATIONS = 99


def shapes_of(seed, number=12, vertices=30):
    """Points that differ by noise alone; neighbors share a half of it."""
    noise = np.random.RandomState(seed).standard_normal((number, vertices, 3))
    return noise + np.roll(noise, 1, axis=1)


class TestGroups(unittest.TestCase):
    def test_statistic_is_that_of_an_analysis_of_variance(self):
        shapes = shapes_of(1)
        shapes[:, :, 1:] = 0.0  # one coordinate: F of the textbook
        groups = ["a", "b", "c", "a", "b", "c", "a", "a", "b", "c", "c", "c"]
        found = shape_groups.test_groups(shapes, groups, 99, 0).statistic
        for vertex in (0, 13, 29):
            parts = [[x for x, group in zip(shapes[:, vertex, 0], groups) if group == name] for name in "abc"]
            mean = np.mean(shapes[:, vertex, 0])
            between = sum(len(part) * (np.mean(part) - mean)**2 for part in parts) / (3 - 1)
            within = sum((x - np.mean(part))**2 for part in parts for x in part) / (12 - 3)
            self.assertAlmostEqual(found[vertex], between / within, places=9)

    def test_p_is_that_of_all_orders(self):
        shapes, groups = shapes_of(2, number=6, vertices=4), ["a", "a", "a", "b", "b", "b"]

        def statistics(first):
            means = shapes[list(first)].mean(axis=0), shapes[[i for i in range(6) if i not in first]].mean(axis=0)
            between = 1.5 * ((means[0] - means[1])**2).sum(axis=1)
            total = ((shapes - shapes.mean(axis=0))**2).sum(axis=(0, 2))
            return 4 * between / (total - between)

        own = statistics((0, 1, 2))
        orders = np.array([statistics(first) for first in itertools.combinations(range(6), 3)])
        exact = (orders >= own - 1e-9).mean(axis=0)
        corrected = (orders.max(axis=1)[:, None] >= own - 1e-9).mean(axis=0)
        test = shape_groups.test_groups(shapes, groups, 9999, 5)
        np.testing.assert_allclose(test.statistic, own, rtol=1e-9)
        np.testing.assert_allclose(test.p, exact, atol=0.02)  # four standard errors
        np.testing.assert_allclose(test.corrected, corrected, atol=0.02)

    def test_p_is_uniform_without_an_effect(self):
        tests = [shape_groups.test_groups(shapes_of(10 + i), HALVES, PERMUTATIONS, 1000 + i) for i in range(STUDIES)]
        smallest = np.array([test.corrected.min() for test in tests])
        alone = np.array([test.p[7] for test in tests])
        for values in (smallest, alone):
            for level in (0.05, 0.1, 0.25, 0.5, 0.75):
                error = np.sqrt(level * (1 - level) / STUDIES)
                self.assertLess(abs((values <= level + 1e-9).mean() - level), 3.5 * error, level)
        # Without correction, many studies have a small p somewhere.
        self.assertGreater(np.mean([test.p.min() <= 0.05 for test in tests]), 0.4)

    def test_planted_difference_is_found_where_it_is(self):
        shapes = shapes_of(8)
        shapes[6:, 10:15, 2] += 6.0
        test = shape_groups.test_groups(shapes, HALVES, 999, 0)
        self.assertLess(test.corrected[10:15].max(), 0.01)
        self.assertGreater(np.delete(test.corrected, range(10, 15)).min(), 0.1)
        self.assertTrue((test.corrected >= test.p).all())
        again = shape_groups.test_groups(shapes, HALVES, 999, 0)
        for first, second in zip(test, again):
            np.testing.assert_array_equal(first, second)
        self.assertTrue((shape_groups.test_groups(shapes, HALVES, 999, 1).p != test.p).any())

    def test_equal_shapes_have_no_difference(self):
        shapes = np.repeat(shapes_of(4)[:1], 12, axis=0)
        shapes[:, 3] += shapes_of(5)[:, 3]
        test = shape_groups.test_groups(shapes, HALVES, 99, 0)
        self.assertEqual(set(np.delete(test.statistic, 3)), {0.0})
        self.assertEqual(set(np.delete(test.p, 3)), {1.0})
        self.assertGreater(test.statistic[3], 0.0)


class TestTables(unittest.TestCase):
    def read(self, text, names=("a", "b", "c.d", "e")):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "groups.csv")
            with open(path, "wb") as file:
                file.write(text if isinstance(text, bytes) else text.encode())
            return shape_groups.read_groups(path, list(names))

    def test_names_files_and_quotes(self):
        rows = "\ufeffGroup , age,Scan\r\n\"x, y\",1,e\r\nz,2,scans/a.ply\r\n\r\n\"x, y\",3,c.d\r\nz,4,b.ply\r\n"
        self.assertEqual(self.read(rows), ["z", "z", "x, y", "x, y"])

    def test_what_does_not_fit_is_refused(self):
        for text, message in (
                ("", "the first line must name the columns scan and group"),
                ("scan;group\na;x\n", "the first line must name the columns scan and group"),
                ("scan,group\na,x\nb,x\nc.d,y\n", "no group for e"),
                ("scan,group\na,x\nb,x\nc.d,y\ne,y\nf,y\n", "f is none of the scans"),
                ("scan,group\na,x\nb,x\nc.d,y\ne,y\na.ply,y\n", "a.ply has two rows"),
                ("scan,group\na,x\nb,x\nc.d,y\ne\n", "row 5 has 1 cells, but the first row has 2"),
                ("scan,group\na,x\nb,\nc.d,y\ne,y\n", "b has no group"),
                ("scan,group\na,x\nb,x\nc.d,x\ne,x\n", "all scans are in the group x"),
                ("scan,group\na,x\nb,x\nc.d,x\ne,y\n", "the group y has one scan"),
                (b"scan,group\na,\xff\n", "not a CSV file in UTF-8"),
                ("scan,group\n\"a,x\n", "not a CSV file in UTF-8")):
            with self.subTest(message), self.assertRaisesRegex(ValueError, message):
                self.read(text)


if __name__ == "__main__":
    unittest.main()
