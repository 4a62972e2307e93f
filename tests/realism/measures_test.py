"""Measures images whose noise, blur and light are known."""
import math
import unittest

import numpy as np

from realism import measures

SIZE = (160, 208)


def plain(values=(100, 120, 110)):
    return np.ones((*SIZE, 3)) * values


class Noise(unittest.TestCase):
    def setUp(self):
        self.noise = np.random.default_rng(1).normal(0, (1, 2, 3), (*SIZE, 3))

    def test_standard_deviation_on_a_slope(self):
        slope = np.arange(SIZE[1])[:, None] * (0.3, 0.1, -0.1)
        windows = measures.Windows(plain() + slope + self.noise)
        np.testing.assert_allclose(np.sqrt(windows.variance.mean(0)), (1, 2, 3), rtol=0.03)

    def test_correlation_and_spectrum(self):
        # The mean of two neighbors in a row correlates by a half; its power is that times cos^2(pi f).
        mixed = (self.noise + np.roll(self.noise, 1, 1)) / 2
        residual = measures.Windows(mixed).residual
        # Taking each window's plane out lowers both a little.
        np.testing.assert_allclose(measures.correlation_of_neighbors(residual, 2), 0.45, atol=0.05)
        np.testing.assert_allclose(measures.correlation_of_neighbors(residual, 1), -0.05, atol=0.05)
        frequency, power = measures.spectrum(residual, 2)
        np.testing.assert_allclose(frequency, (0.125, 0.25, 0.375, 0.5))
        np.testing.assert_allclose(power[1], np.array((1, 4, 9)) * 0.5, rtol=0.1)
        self.assertTrue((power[3] < 0.2 * power[1]).all())

    def test_correlation_of_channels(self):
        image = plain() + self.noise
        image[..., 1] -= 2 * self.noise[..., 0]
        found = measures.correlation_of_channels(measures.Windows(image).residual).mean(0)
        np.testing.assert_allclose(found, (-math.sqrt(0.5), 0, 0), atol=0.03)


class Steps(unittest.TestCase):
    def image(self, slant, blur):
        """A step from 50 to 200 at column 100, which moves by `slant` pixels from row to row."""
        y, x = np.mgrid[0:SIZE[0], 0:SIZE[1]]
        level = np.vectorize(math.erf)((x - 100 - slant * (y - 80)) / (blur * math.sqrt(2)))
        return np.repeat((125 + 75 * level)[..., None], 3, 2)

    def test_width(self):
        for along_columns in (False, True):
            image = self.image(0.1, 1.2)
            found = measures.steps(image.transpose(1, 0, 2) if along_columns else image, 0, along_columns)
            self.assertGreater(len(found[0]), 140)
            profile = measures.profile_of_steps(*found)
            self.assertAlmostEqual(measures.width(measures.BINS, profile), 2.56 * 1.2, delta=0.15)

    def test_oblique_edges_are_left_out(self):
        self.assertEqual(len(measures.steps(self.image(0.8, 1.2), 0, False)[0]), 0)


class Field(unittest.TestCase):
    def test_rim(self):
        r2 = measures.from_middle(plain())[..., None]
        green = plain((100, 118, 108))
        image = 128 + (green - 128) * (1 - 0.4 * r2) + r2 * (0, 12, 5)
        image[..., 0] = 100 * (1 - 0.4 * r2[..., 0])
        np.testing.assert_allclose(measures.rim(image), (0.4, 12, 5), atol=1e-6)
        self.assertIsNone(measures.rim(plain((100, 128, 128))))

    def test_lines(self):
        image = plain((80, 118, 108))
        image[:70] = (200, 128, 128)  # a wall
        image[100:104] = (200, 128, 128)
        rows = np.flatnonzero(measures.line(image).all(1))
        np.testing.assert_array_equal(rows, range(100, 104))


if __name__ == "__main__":
    unittest.main()
