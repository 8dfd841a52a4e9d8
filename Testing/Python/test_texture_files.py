"""Pictures from strangers: whatever is in a PNG or JPEG file, it is decoded or refused, in bounded time and memory."""
import base64
import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGWriter

from conformalsom.command import decoding, textures


def chunk(kind, data):
    """A chunk of a PNG file, its checksum right."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def header(columns=4, rows=4, bits=8, color=2, interlaced=0):
    return chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, bits, color, 0, 0, interlaced))


def pixels(data):
    return chunk(b"IDAT", zlib.compress(data))


SIGNATURE, END = b"\x89PNG\r\n\x1a\n", chunk(b"IEND", b"")
ROWS = b"".join(b"\0" + bytes(range(12 * row, 12 * row + 12)) for row in range(4))
PALETTE = chunk(b"PLTE", bytes(range(12)))

INKS = (  # a JPEG file of 8 x 8 pixels in CMYK
    "/9j/7gAOQWRvYmUAZAAAAAAA/9sAQwAIBgYHBgUIBwcHCQkICgwUDQwLCwwZEhMPFB0aHx4dGhwcICQuJyAiLCMcHCg3KSwwMTQ0"
    "NB8nOT04MjwuMzQy/8AAFAgACAAIBEMRAE0RAFkRAEsRAP/EABQAAQAAAAAAAAAAAAAAAAAAAAf/xAAUEAEAAAAAAAAAAAAAAAAA"
    "AAAA/9oADgRDAE0AWQBLAAA/AHUbGErv/9k=")


def png(*chunks):
    return SIGNATURE + b"".join(chunks)


class TestPictures(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="pictures of ")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def file(self, content, name="a.png"):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(content)
        return path

    def refuses(self, message, content, name="a.png"):
        path = self.file(content, name)
        with self.assertRaisesRegex(ValueError, message) as caught:
            textures.read_picture(path)
        self.assertTrue(str(caught.exception).startswith(path + ": "), caught.exception)
        self.assertNotIn("\n", str(caught.exception))

    def test_good_ones(self):
        expected = np.arange(48).reshape(4, 4, 3)[::-1]  # the lowest row first
        np.testing.assert_array_equal(textures.read_picture(self.file(png(header(), pixels(ROWS), END))), expected)
        colors = textures.read_picture(self.file(png(header(color=3, bits=2), PALETTE, pixels(b"\0\x1b" * 4), END)))
        np.testing.assert_array_equal(colors, np.broadcast_to(np.arange(12).reshape(4, 3), (4, 4, 3)))
        name = "gr\u00fc\u00df a.PNG"
        np.testing.assert_array_equal(
            textures.read_picture(self.file(png(header(), pixels(ROWS), END), name)), expected)

    def test_broken_ones_with_right_checksums(self):
        broken = "the picture is broken"
        for what, content in (
                ("zlib", png(header(), chunk(b"IDAT", b"\x78\x9c" + b"\xff" * 20), END)),
                ("filter", png(header(), pixels(b"\7" + ROWS[1:]), END)),
                ("no pixels", png(header(0, 0), pixels(ROWS), END)),
                ("3 bits", png(header(bits=3), pixels(ROWS), END)),
                ("color type 1", png(header(color=1), pixels(ROWS), END)),
                ("color type 5", png(header(color=5), pixels(ROWS), END)),
                ("no palette", png(header(color=3), pixels(b"\0" * 20), END)),
                ("IHDR twice", png(header(), header(400, 400), pixels(ROWS), END)),
                ("IHDR late", png(chunk(b"gAMA", b"\0\0\0\1"), header(), pixels(ROWS), END)),
                ("IHDR too long", png(chunk(b"IHDR", header()[8:21] + b"\0"), pixels(ROWS), END)),
                ("IHDR too short", png(chunk(b"IHDR", header()[8:20]), pixels(ROWS), END)),
                ("too few pixels", png(header(4, 400), pixels(ROWS), END)),
                ("no IDAT", png(header(), END)), ("nothing", SIGNATURE)):
            with self.subTest(what):
                self.refuses(broken, content)
        self.refuses("not a PNG file", b"text")
        self.refuses("not a PNG file", b"")
        for content in b"text", b"", b"\xff\xd8\xff" + bytes(500):
            self.refuses("not a JPEG file|the picture is broken", content, "a.jpg")

    def jpeg(self, channels=3, size=None):
        """A JPEG file; of another size in its header if one is given."""
        image = vtkImageData()
        image.SetDimensions(16, 16, 1)
        values = np.arange(256 * channels, dtype=np.uint8).reshape(256, channels)
        image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
        data = bytearray(self.written(image))
        if size:
            place = data.index(b"\xff\xc0") + 5
            data[place:place + 4] = struct.pack(">HH", *size)
        return bytes(data)

    def written(self, image):
        """The bytes of a JPEG file."""
        writer = vtkJPEGWriter()
        writer.ProgressiveOff()
        writer.SetInputData(image)
        writer.SetFileName(self.file(b"", "written.jpg"))
        writer.Write()
        with open(writer.GetFileName(), "rb") as file:
            return file.read()

    def test_bombs_are_refused_for_their_number_of_pixels(self):
        limit = f"there can be 1 to {textures.MAXIMUM_PIXELS:,}"
        self.assertEqual(textures.MAXIMUM_PIXELS, decoding.MAXIMUM_PIXELS)
        self.refuses(f"65500 x 65500 pixels; {limit}", self.jpeg(size=(65500, 65500)), "a.jpg")
        for bits, color in ((1, 0), (1, 3), (8, 3)):
            self.refuses(f"60000 x 60000 pixels; {limit}",
                         png(header(60000, 60000, bits, color), PALETTE, pixels(bytes(7501 * 100)), END))

    def test_work_is_limited_by_the_number_of_pixels(self):
        """A picture that takes more memory or time than that is refused, by whatever the system does."""
        content = png(header(3000, 3000), pixels(bytes(9001 * 3000)), END)
        self.assertEqual(textures.read_picture(self.file(content)).shape, (3000, 3000, 3))
        with open(textures.DECODER, encoding="utf-8") as file:
            source = file.read()
        for old, new, message in (
                ("BYTES_PER_PIXEL = 24", "BYTES_PER_PIXEL = 1", "broken|more memory"),
                ("def checked_size(reader):\n", "def checked_size(reader):\n    while True: pass\n", "more time")):
            if old.startswith("BYTES") and not os.path.exists("/proc/self/statm"):
                continue
            changed = source.replace(old, new).replace("SPARE_BYTES = 2**28", "SPARE_BYTES = 2**20")
            self.assertNotEqual(changed, source)
            changed = changed.replace("SECONDS = 5", "SECONDS = 0")
            with mock.patch.object(textures, "DECODER", self.file(changed.encode(), "decoding.py")):
                self.refuses(message, content)

    def test_decoder_that_crashes_or_prints_is_a_broken_picture(self):
        for program, message in (("import os; os.kill(os.getpid(), 11)", r"crashed by signal 11 \(SIGSEGV\)"),
                                 ("print('{\"rows\": 9, \"columns\": 9, \"channels\": 3}')", "broken"),
                                 ("import sys; sys.stderr.write('libpng error: bad\\n')", "broken: bad"),
                                 ("import no_such_module", "ended with status 1: ModuleNotFoundError")):
            with mock.patch.object(textures, "DECODER", self.file(program.encode(), "decoding.py")):
                self.refuses(message, png(header(), pixels(ROWS), END))

    def test_cmyk_is_refused(self):
        """A JPEG file of four components has no opacity."""
        self.refuses("CMYK", base64.b64decode(INKS), "a.jpg")

    def test_jpeg_files_are_turned_as_their_exif_data_say(self):
        image = vtkImageData()
        image.SetDimensions(24, 16, 1)
        stored = np.zeros((16, 24), np.uint8)  # highest row first
        stored[:8, :8], stored[:8, 8:], stored[8:, :8] = 240, 160, 80
        image.GetPointData().SetScalars(numpy_to_vtk(stored[::-1].ravel(), deep=True))
        data = self.written(image)
        # What is at the top and at the left in the file is shown at the sides that EXIF's specification lists.
        shown = {1: stored, 2: np.fliplr(stored), 3: np.rot90(stored, 2), 4: np.flipud(stored), 5: stored.T,
                 6: np.rot90(stored, -1), 7: np.rot90(stored, 2).T, 8: np.rot90(stored)}

        def read(exif):
            segment = b"\xff\xe1" + struct.pack(">H", len(exif) + 8) + b"Exif\0\0" + exif
            path = self.file(data[:2] + b"\xff\xfe\0\4hi" + segment + data[2:], "a.jpg")
            return textures.read_picture(path)[::-1, :, 0].astype(int)

        def exif(order, orientation):
            """Data with two tags, of which the second is the orientation."""
            head = {"<": b"II*\0", ">": b"MM\0*"}[order]
            return head + struct.pack(order + "IHHHIIHHIHHI", 8, 2, 0x0100, 4, 1, 24, 0x0112, 3, 1, orientation, 0, 0)

        for order in "<>":
            for orientation, expected in shown.items():
                with self.subTest(order + str(orientation)):
                    np.testing.assert_allclose(read(exif(order, orientation)), expected, atol=3)
        good = exif("<", 6)
        for what, damaged in (("no header", b"JJ*\0" + good[4:]), ("cut short", good[:24]), ("0", exif("<", 0)),
                              ("9", exif(">", 9)), ("far away", good[:4] + b"\xff\xff\xff\xff" + good[8:]),
                              ("a long", good.replace(b"\x12\x01\3", b"\x12\x01\4")), ("nothing", b"")):
            with self.subTest(what):
                self.assertNotEqual(damaged, good)
                np.testing.assert_allclose(read(damaged), stored, atol=3)

    def test_interpreter_of_a_program_that_python_is_a_part_of(self):
        with mock.patch.object(sys, "executable", "/usr/bin/pvpython"):
            done = subprocess.run([textures.interpreter(), "-c", "print(1)"], stdout=subprocess.PIPE, check=True)
            self.assertEqual(done.stdout.strip(), b"1")
            self.assertEqual(textures.read_picture(self.file(png(header(), pixels(ROWS), END))).shape, (4, 4, 3))
            with mock.patch.object(sys, "base_exec_prefix", self.folder), mock.patch.dict(os.environ, PATH=self.folder):
                self.refuses("there is no python3", png(header(), pixels(ROWS), END))
        with mock.patch.object(sys, "executable", None):
            self.assertRegex(os.path.basename(textures.interpreter()), "^python3")

    def test_nothing_is_left(self):
        before = set(os.listdir(tempfile.gettempdir()))
        self.refuses("broken", png(header(), END))
        self.assertEqual(os.listdir(self.folder), ["a.png"])
        left = {name for name in set(os.listdir(tempfile.gettempdir())) - before if "conformal" in name}
        self.assertEqual(left, set())
        with self.assertRaises(ChildProcessError):
            os.waitpid(-1, os.WNOHANG)


if __name__ == "__main__":
    unittest.main()
