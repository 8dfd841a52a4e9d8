"""Pages of vtkSurfacePageWriter in Debian's Chromium: what is drawn, what a picked point says, by
mouse, keyboard and touch, with the network off. Skipped without packages chromium and libjs-three."""
import glob
import os
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader

from baselines import LEFT_OVERS
from browser import CHROMIUM, Browser
from conformalsom import vtkGeodesicSphereSource, vtkSphericalTextureMap, vtkSurfacePageWriter
from helpers import textures

THREE = "/usr/share/javascript/three/three.min.js"
AXES = np.array([1.0, 1.3, 0.7])
HOSTILE = "</script><img src=x onerror='window.hacked=1'>\"&{{data}}"
QUADRANTS = np.array([[(200, 40, 40), (40, 160, 40)], [(40, 60, 200), (220, 200, 40)]])  # top row first
GRAY = (140, 140, 140)


def add(surface, name, values, kind=float):
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=kind), deep=True)
    array.SetName(name)
    surface.GetPointData().AddArray(array)


def ellipsoid(frequency):
    """An ellipsoid about (5, 0, 0) with the map to the sphere that is known, and arrays."""
    source = vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    directions = vtk_to_numpy(source.GetOutput().GetPointData().GetArray("SpherePosition"))
    points, surface = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(directions * AXES + (5.0, 0.0, 0.0), deep=True))
    surface.SetPoints(points)
    surface.SetPolys(source.GetOutput().GetPolys())
    add(surface, "SpherePosition", directions)
    add(surface, "Height", directions[:, 1])
    add(surface, "Patchy", np.where(directions[:, 0] > 0.0, np.nan, directions[:, 0]))
    add(surface, "Side", np.sign(directions[:, 0]) * 1000, np.int32)
    add(surface, "Wind", directions[:, :2] * 3.0)
    add(surface, "Spiky", np.where(directions[:, 1] > 0.995, 100.0, directions[:, 1]))
    add(surface, "Colors", np.where(directions[:, :1] > 0.0, (250, 20, 20), (20, 20, 250)), np.uint8)
    add(surface, HOSTILE, directions[:, 2])
    return surface


def picture():
    """One color in each quarter, none like another's mirror image."""
    return textures.to_image(np.repeat(np.repeat(QUADRANTS, 64, axis=0), 64, axis=1) / 255.0)


def write_page(path, surface, image=None, **properties):
    writer = vtkSurfacePageWriter()
    if image:
        painted = vtkSphericalTextureMap()
        painted.SetInputData(surface)
        painted.SplitSeamOn()
        writer.SetInputConnection(painted.GetOutputPort())
        writer.SetTextureData(image)
    else:
        writer.SetInputData(surface)
    for name, value in properties.items():
        getattr(writer, "Set" + name)(value)
    writer.SetFileName(path)
    return writer.Write()


@unittest.skipUnless(CHROMIUM and os.path.exists(THREE), "chromium or libjs-three is not installed")
class TestPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="page f\u00fcr ")
        cls.path = os.path.join(cls.temporary.name, "My <b>page &amp; more.html")
        assert write_page(cls.path, ellipsoid(20), picture()) == 1
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def setUp(self):
        self.browser.resize(1200, 700)
        self.browser.prefer("light")
        self.open(self.path)

    def tearDown(self):
        self.assertEqual(self.browser.messages, [])
        self.assertEqual([url[:30] for url in self.browser.requests if not url.startswith(("file:", "data:"))], [])
        self.assertLessEqual(sum(url.startswith("file:") for url in self.browser.requests), 1)

    def open(self, path):
        self.browser.open(path)
        self.browser.evaluate("page.ready")

    def value(self, expression):
        return self.browser.evaluate(expression)

    def box(self, name):
        return self.value(f"(({{left, top, width, height}}) => [left, top, width, height])"
                          f"(document.getElementById('{name}').getBoundingClientRect())")

    def middle(self, name):
        left, top, width, height = self.box(name)
        return np.array([left + width / 2, top + height / 2])

    def pick(self, name, x, y):
        return self.value(f"page.pick('{name}', {x}, {y})")

    def rows(self):
        """What the page says of the picked point."""
        return dict(self.value("[...document.querySelectorAll('#picked dt')].map((term) =>"
                               " [term.textContent, term.nextSibling.textContent])"))

    def choose(self, label):
        self.assertTrue(self.value(
            "((label) => { const menu = document.getElementById('color');"
            " const option = [...menu.options].find((o) => o.text === label);"
            " menu.value = option.value; menu.dispatchEvent(new Event('change')); return true; })"
            f"({label!r})"))

    def morph(self, fraction):
        self.value("(() => { const slider = document.getElementById('morph');"
                   f" slider.value = {fraction}; slider.dispatchEvent(new Event('input')); }})()")

    def shot(self, name):
        """What is seen, as rows of pixels from the top; the picture is left for people."""
        os.makedirs(LEFT_OVERS, exist_ok=True)
        path = os.path.join(LEFT_OVERS, f"Page{name}.png")
        self.browser.screenshot(path)
        reader = vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        image = reader.GetOutput()
        columns, rows, _ = image.GetDimensions()
        pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)
        return pixels[::-1, :, :3].astype(float)

    def view(self, pixels, name):
        """The pixels of a view, without its frame and heading."""
        left, top, width, height = np.rint(self.box(name)).astype(int)
        return pixels[top + 40:top + height - 4, left + 4:left + width - 4]

    def assert_like(self, color, expected):
        """A color in some light is one times a factor."""
        self.assertGreater(color @ expected / np.linalg.norm(color) / np.linalg.norm(expected), 0.985,
                           f"{color} is not like {expected}")

    def test_says_what_it_is(self):
        self.assertEqual(self.value("document.title"), "My <b>page &amp; more")
        self.assertEqual(self.value("document.querySelector('h1').textContent"), "My <b>page &amp; more")
        self.assertEqual(self.value("document.getElementById('message').textContent"), "")
        self.assertEqual(self.value("[...document.getElementById('color').options].map((o) => o.text)"),
                         ["Texture", "Colors", "Height", "Patchy", "Spiky", HOSTILE, "Wind (length)", "Side",
                          "OutsideImage", "OriginalPointIds"])
        self.assertIsNone(self.value("window.hacked"))
        for tag in ("input", "select", "button"):
            self.assertEqual(self.value(
                f"[...document.querySelectorAll('{tag}')].filter((e) => !e.labels.length &&"
                " !e.textContent).length"), 0)

    def test_picked_points_are_those_of_the_surface(self):
        width, height = self.box("surface")[2:]
        for x, y in ((0.5, 0.5), (0.4, 0.55), (0.6, 0.4), (0.45, 0.65)):
            with self.subTest((x, y)):
                point = self.pick("surface", x * width, y * height)
                direction = (np.array(point["position"]) - (5.0, 0.0, 0.0)) / AXES
                self.assertLess(abs(np.linalg.norm(direction) - 1.0), 0.01)  # on flat triangles
                direction /= np.linalg.norm(direction)
                longitude, latitude = np.radians([point["longitude"], point["latitude"]])
                on_sphere = np.array([np.cos(latitude) * np.cos(longitude),
                                      np.cos(latitude) * np.sin(longitude), np.sin(latitude)])
                self.assertLess(np.linalg.norm(on_sphere - direction), 0.005)
                values = {value["name"]: value["value"] for value in point["values"]}
                self.assertLess(abs(values["Height"] - direction[1]), 0.01)
                self.assertLess(abs(values["Wind"] - 3.0 * np.hypot(*direction[:2])), 0.03)
                if abs(direction[0]) > 0.1:
                    self.assertEqual(values["Side"], 1000 * np.sign(direction[0]))
                    self.assertEqual(values["Colors"],
                                     [250, 20, 20] if direction[0] > 0 else [20, 20, 250])
                    self.assertEqual(values["Patchy"] is None, bool(direction[0] > 0))
        # The viewer stands above +z, and sees +y upwards and +x to the right.
        self.assertGreater(self.pick("surface", 0.6 * width, 0.5 * height)["position"][0], 5.2)
        self.assertGreater(self.pick("surface", 0.5 * width, 0.4 * height)["position"][1], 0.2)
        self.assertIsNone(self.pick("surface", 3, height - 3))
        self.assertEqual(self.rows(), {})

    def test_a_point_of_the_one_is_that_of_the_other(self):
        width, height = self.box("sphere")[2:]
        for x, y in ((0.5, 0.5), (0.35, 0.6), (0.6, 0.35)):
            with self.subTest((x, y)):
                first = self.pick("surface", x * width, y * height)
                self.assertLess(np.abs(np.array(first["pixels"]["surface"])
                                       - (x * width, y * height)).max(), 0.01)
                second = self.pick("sphere", *first["pixels"]["sphere"])
                for name in ("longitude", "latitude"):
                    self.assertLess(abs(first[name] - second[name]), 0.01)
                self.assertLess(np.abs(np.subtract(first["position"], second["position"])).max(), 1e-4)
                pixels = self.shot("Marks")  # both marks are seen where the page says they are
                for view, (column, row) in second["pixels"].items():
                    left, top = self.box(view)[:2]
                    self.assert_like(pixels[int(top + row), int(left + column)], np.array([216, 27, 96]))

    def test_mouse_turns_both_or_one_and_picks(self):
        start = self.middle("surface")
        before = self.pick("surface", *(np.array(self.box("surface")[2:]) / 2))
        height = next(value["value"] for value in before["values"] if value["name"] == "Height")
        self.browser.click(*start)
        rows = self.rows()
        self.assertEqual(rows["Longitude"], f"{before['longitude']:.2f}\u00b0")
        self.assertEqual(rows["Latitude"], f"{before['latitude']:.2f}\u00b0")
        self.assertLess(abs(float(rows["x"]) - before["position"][0]), 1e-4)
        self.assertLess(abs(float(rows["Height"]) - height), 1e-4)
        self.assertIn(rows["Side"], ("1000", "-1000", "0"))
        self.assertIn(HOSTILE, rows)
        self.assertLess(self.value("document.querySelector('#picked dd').clientHeight"), 30)  # one line

        def seen(name):
            return np.array(self.pick(name, *(np.array(self.box(name)[2:]) / 2))["position"])
        surface, sphere = seen("surface"), seen("sphere")
        self.browser.drag(start, start + (60, 0))
        self.assertLess(seen("surface")[0], surface[0] - 0.1)  # what was on the left is in the middle
        self.assertLess(seen("sphere")[0], sphere[0] - 0.1)
        surface, sphere = seen("surface"), seen("sphere")
        self.value("document.getElementById('linked').click()")
        self.browser.drag(start, start + (0, 60))
        self.assertGreater(np.abs(seen("surface") - surface).max(), 0.1)
        self.assertEqual(seen("sphere").tolist(), sphere.tolist())
        self.value("document.getElementById('reset').click()")
        self.assertEqual(seen("surface").tolist(), before["position"])
        self.browser.mouse("mouseWheel", *start, deltaX=0, deltaY=-400)
        near = self.pick("surface", 150, 300)["position"]
        self.browser.mouse("mouseWheel", *start, deltaX=0, deltaY=400)
        self.assertGreater(np.linalg.norm(np.subtract(self.pick("surface", 150, 300)["position"], near)), 0.01)

    def test_keyboard_turns_zooms_and_picks(self):
        self.value("document.getElementById('surface').focus()")
        self.browser.key("Enter")
        first = self.rows()
        self.assertIn("Longitude", first)
        for name in ("ArrowRight", "ArrowDown", "+"):
            self.browser.key(name)
        self.browser.key("Enter")
        self.assertNotEqual(self.rows()["x"], first["x"])
        self.assertNotEqual(self.rows()["y"], first["y"])
        self.browser.key("Home")
        self.browser.key("Enter")
        self.assertEqual(self.rows(), first)
        self.assertEqual(self.value("document.getElementById('picked').getAttribute('aria-live')"), "polite")

    def test_a_phone_shows_all_and_picks_by_touch(self):
        self.browser.resize(390, 844, is_phone=True)
        self.browser.prefer("dark")
        self.assertLessEqual(self.value("document.documentElement.scrollWidth"), 390)
        surface, sphere = self.box("surface"), self.box("sphere")
        self.assertGreater(sphere[1], surface[1] + surface[3])  # one above the other
        self.assertLess(sphere[1] + sphere[3], 844)
        self.assertGreaterEqual(self.value(
            "parseFloat(getComputedStyle(document.getElementById('color')).fontSize)"), 16)
        slider, reset = self.box("morph"), self.box("reset")
        self.assertLessEqual(max(slider[1] + slider[3], reset[1] + reset[3]), 844)  # without scrolling
        x, y = self.middle("sphere")
        self.browser.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self.browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.assertIn("Longitude", self.rows())
        pixels = self.shot("Phone")
        self.assertLess(pixels[3, 3].max(), 60)  # dark around
        self.assertGreater(self.view(pixels, "surface").max(), 150)

    def test_swipes_scroll_a_phone_or_turn(self):
        self.browser.resize(390, 844, is_phone=True)
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=True)
        x, y = self.middle("surface")

        def swipe(across, up):
            steps = [{"x": x + across * i / 10, "y": y - up * i / 10} for i in range(11)]
            for kind, points in [("touchStart", steps[:1])] + [("touchMove", [step]) for step in steps[1:]]:
                self.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
            self.browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
            self.browser.drawn()

        before = self.shot("Swipe0")
        swipe(0, 150)
        self.assertGreater(self.value("window.scrollY"), 50)
        for _ in range(100):  # scrolling goes on after the swipe
            self.value("window.scrollTo(0, 0)")
            self.browser.drawn()
        self.assertLess(np.abs(self.shot("Swipe1") - before).max(), 2)  # nothing has turned
        swipe(100, 0)
        self.assertEqual(self.value("window.scrollY"), 0)
        self.assertGreater(np.abs(self.view(self.shot("Swipe2"), "surface") - self.view(before, "surface")).max(), 30)
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=False)

    def test_turntable_turns_until_it_is_stopped(self):
        before = self.pick("surface", 150, 300)["longitude"]
        self.value("document.getElementById('turntable').click()")
        for _ in range(5):
            self.browser.drawn()
        self.assertEqual(self.value("document.getElementById('turntable').getAttribute('aria-pressed')"), "true")
        self.value("document.getElementById('turntable').click()")
        self.browser.drawn()
        after = self.pick("surface", 150, 300)["longitude"]
        self.assertNotEqual(after, before)
        self.browser.drawn()
        self.assertEqual(self.pick("surface", 150, 300)["longitude"], after)

    def test_saves_what_it_shows(self):
        shown = self.value("page.picture().then((file) => createImageBitmap(file)).then((image) => {"
                           " const canvas = document.createElement('canvas');"
                           " [canvas.width, canvas.height] = [image.width, image.height];"
                           " const context = canvas.getContext('2d'); context.drawImage(image, 0, 0);"
                           " return [...context.getImageData(0, 0, image.width, image.height).data]; })")
        left, top, width, height = np.rint(self.box("views")).astype(int)
        saved = np.array(shown).reshape(height, width, 4)
        pixels = self.shot("Saved")[top:top + height, left:left + width]
        frame = np.array(self.middle("surface") - (left, top)).astype(int)
        inner = np.s_[frame[1] - 60:frame[1] + 60, frame[0] - 60:frame[0] + 60]
        self.assertLess(np.abs(saved[inner][..., :3] - pixels[inner]).max(), 3)
        self.assertEqual(saved[..., 3].min(), 255)

    def test_colors_do_not_follow_a_few_outliers(self):
        ends = "['low', 'high'].map((id) => document.getElementById(id).textContent)"
        self.choose("Height")
        self.assertTrue(self.value("document.getElementById('clipping').hidden"))
        self.choose("Spiky")
        self.assertFalse(self.value("document.getElementById('clipping').hidden"))
        low, high = self.value(ends)
        self.assertTrue(low.startswith("\u2264 -0.9") and high.startswith("\u2265 0.9"), (low, high))
        x, y = self.middle("sphere").astype(int)
        pixels = self.shot("Spiky")
        self.assertGreater(np.ptp([pixels[y + dy, x].max() for dy in (-100, 0, 100)]), 40)
        self.value("document.getElementById('whole').click()")
        self.assertEqual(self.value(ends)[1], "100")
        self.value("document.getElementById('whole').click()")

    def test_two_fingers_zoom_and_pick_nothing(self):
        x, y = self.middle("surface")
        before = self.pick("surface", 150, 300)["position"]
        self.value("page.pick('surface', 2, 2)")
        def fingers(kind, distance):
            points = [{"x": x + side * distance, "y": y, "id": i} for i, side in enumerate((-1, 1))]
            self.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=points if distance else [])
        fingers("touchStart", 40)
        fingers("touchMove", 60)
        fingers("touchMove", 80)
        fingers("touchEnd", 0)
        self.assertEqual(self.rows(), {})
        after = self.pick("surface", 150, 300)["position"]
        self.assertLess(np.linalg.norm(np.subtract(after, (5, 0, 0)) / AXES * (1, 1, 0)),
                        np.linalg.norm(np.subtract(before, (5, 0, 0)) / AXES * (1, 1, 0)))

    def test_texture_stands_upright_on_both(self):
        pixels = self.shot("Texture")
        for name in ("surface", "sphere"):
            x, y = self.middle(name).astype(int)
            for row in range(2):
                for column in range(2):
                    with self.subTest((name, row, column)):
                        color = pixels[y + 30 * (2 * row - 1), x + 30 * (2 * column - 1)]
                        self.assert_like(color, QUADRANTS[row, column])

    def test_arrays_are_colors_with_a_legend(self):
        self.assertTrue(self.value("document.getElementById('legend').hidden"))
        self.choose("Height")
        self.assertFalse(self.value("document.getElementById('legend').hidden"))
        self.assertEqual(self.value("['low', 'high'].map((id) => document.getElementById(id).textContent)"),
                         ["-1", "1"])
        self.assertTrue(self.value("document.getElementById('missing').hidden"))
        pixels = self.shot("Height")
        x, y = self.middle("sphere").astype(int)
        column = self.view(pixels, "sphere").sum(axis=2)
        self.assertGreater(column[:len(column) // 2].mean(), 0.0)
        self.assert_like(pixels[y - 130, x], np.array([170, 214, 70]))  # yellow is high, and above
        self.assert_like(pixels[y + 130, x], np.array([56, 70, 120]))  # blue is low
        self.choose("Patchy")
        self.assertFalse(self.value("document.getElementById('missing').hidden"))
        pixels = self.shot("Patchy")
        self.assert_like(pixels[y, x + 60], np.array(GRAY))
        self.assertGreater(np.ptp(pixels[y, x - 60]), 40)
        self.choose("Colors")
        self.assertTrue(self.value("document.getElementById('legend').hidden"))
        pixels = self.shot("Colors")
        self.assert_like(pixels[y, x + 60], np.array([250, 20, 20]))
        self.assert_like(pixels[y, x - 60], np.array([20, 20, 250]))

    def test_surface_becomes_the_sphere(self):
        self.choose("Height")
        before = self.shot("Morph0")
        difference = np.abs(self.view(before, "surface") - self.view(before, "sphere"))
        self.assertGreater((difference.max(axis=2) > 30).mean(), 0.05)
        self.morph(0.5)
        between = self.shot("Morph5")
        self.assertGreater((np.abs(between - before).max(axis=2) > 30).mean(), 0.005)
        self.morph(1)
        after = self.shot("Morph1")
        difference = np.abs(self.view(after, "surface") - self.view(after, "sphere"))
        self.assertLess((difference.max(axis=2) > 30).mean(), 0.005)  # but for borders of pixels

    def test_other_builds_of_three_draw_the_same(self):
        expected = self.view(self.shot("Texture"), "surface")
        for name in glob.glob("/usr/share/javascript/three/three.js"):
            path = os.path.join(self.temporary.name, "other.html")
            self.assertEqual(write_page(path, ellipsoid(20), picture(), ThreeJSFileName=name), 1)
            self.open(path)
            difference = np.abs(self.view(self.shot("OtherBuild"), "surface") - expected)
            self.assertLess(difference.max(), 2)

    def test_a_large_page_is_small_and_opens(self):
        path = os.path.join(self.temporary.name, "large.html")
        surface = ellipsoid(80)
        self.assertEqual(surface.GetNumberOfPoints(), 64002)
        random = np.random.default_rng(1)
        points = vtk_to_numpy(surface.GetPoints().GetData())
        points += 0.02 * np.sin(7.0 * points[:, ::-1]) + 1e-4 * random.standard_normal(points.shape)
        self.assertEqual(write_page(path, surface, textures.rosette()), 1)
        self.assertLess(os.path.getsize(path), 3_000_000)
        print(f"64,002 points, {surface.GetPointData().GetNumberOfArrays()} arrays and the texture:"
              f" {os.path.getsize(path):,} bytes", file=sys.stderr)
        self.open(path)
        self.assertEqual(self.value("document.getElementById('message').textContent"), "")
        self.assertGreater(self.view(self.shot("Large"), "surface").max(), 150)

    def test_a_page_without_arrays_is_plain(self):
        surface = ellipsoid(4)
        data = surface.GetPointData()
        for name in [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]:
            if name != "SpherePosition":
                data.RemoveArray(name)
        path = os.path.join(self.temporary.name, "plain.html")
        self.assertEqual(write_page(path, surface), 1)
        self.open(path)
        self.assertEqual(self.value("[...document.getElementById('color').options].map((o) => o.text)"), ["None"])
        x, y = self.middle("surface").astype(int)
        self.assert_like(self.shot("Plain")[y, x], np.array([201, 162, 124]))


if __name__ == "__main__":
    unittest.main()
