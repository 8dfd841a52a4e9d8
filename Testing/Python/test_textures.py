"""The pictures of the examples are what they say, the same in every run."""
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from helpers import textures
from helpers.opera_face import opera_face

SIZE = 128


def pixels(image):
    """Rows from the top, three bytes a pixel."""
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, 3)[::-1]


class TestTextures(unittest.TestCase):
    def test_are_pictures_and_the_same_again(self):
        for paint in (textures.rosette, textures.checkerboard, textures.wood,
                      textures.numbered_grid, opera_face):
            with self.subTest(paint.__name__):
                image = pixels(paint(SIZE))
                self.assertEqual(image.shape, (SIZE, SIZE, 3))
                self.assertEqual(image.dtype, np.uint8)
                self.assertGreater(image.std(), 10.0)
                self.assertTrue((image == pixels(paint(SIZE))).all())

    def test_every_field_of_the_grid_is_its_own(self):
        image = pixels(textures.numbered_grid(320, 8))
        fields = image.reshape(8, 40, 8, 40, 3).transpose(0, 2, 1, 3, 4).reshape(64, -1)
        self.assertEqual(len(np.unique(fields, axis=0)), 64)

    def test_the_grid_counts_upwards_from_the_lower_left(self):
        dark = (pixels(textures.numbered_grid(320, 8)) < 80).all(axis=2)
        ink = dark.reshape(8, 40, 8, 40).transpose(0, 2, 1, 3)  # by row from the top, and column
        # Of all digits 0 and 8 have the most dots, 1 the fewest: 00, 11 and 08 in the lower left.
        self.assertGreater(ink[7, 0].sum(), ink[6, 3].sum())
        self.assertGreater(ink[6, 0].sum(), ink[6, 3].sum())
        # A 7 is dark at its top, and has but a foot below.
        seven = ink[7, 7][:, 20:]
        self.assertGreater(seven[:20].sum(), seven[20:].sum())

    def test_the_face_is_the_same_on_both_sides_and_stands_upright(self):
        image = pixels(opera_face(SIZE)).astype(int)
        self.assertLessEqual(np.abs(image - image[:, ::-1]).max(), 1)
        white = (image > 200).all(axis=2)
        eyes = white[int(0.40 * SIZE):int(0.46 * SIZE)].sum()
        mouth = white[int(0.66 * SIZE):int(0.68 * SIZE)].sum()
        self.assertGreater(eyes, mouth)
        self.assertTrue((image[0] == image[-1]).all())  # the border is of one color

    def test_wood_grain_runs_upwards(self):
        image = pixels(textures.wood(256)).astype(float).mean(axis=2)
        across, along = np.abs(np.diff(image, axis=1)).mean(), np.abs(np.diff(image, axis=0)).mean()
        self.assertGreater(across, 2.0 * along)


if __name__ == "__main__":
    unittest.main()
