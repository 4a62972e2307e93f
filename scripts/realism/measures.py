"""What a camera does to its images, measured in them: noise, sharpness, rim, colors.

An image is an array of rows, columns and the channels Y, Cb, Cr.
"""
import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

CHANNELS = ("Y", "Cb", "Cr")
WINDOW = 8  # pixels: noise is what remains of a window without its plane
REACH = 9  # pixels to each side of a step's middle
MOST_SLANT = 0.5  # pixels by which an edge may move from line to line: one that is crossed obliquely seems wider
BINS = np.arange(-6, 6.01, 0.5)  # pixels: of the profile of steps


class Windows:
    """The windows of an image, each half a window from the next: mean brightness, variances of the
    channels (n x 3), residuals (n x rows x columns x 3)."""

    def __init__(self, image):
        y, x = np.mgrid[0:WINDOW, 0:WINDOW]
        plane = np.stack([np.ones(WINDOW**2), x.ravel(), y.ravel()], 1)
        rest = (np.eye(WINDOW**2) - plane @ np.linalg.pinv(plane)).astype(image.dtype)
        parts = sliding_window_view(image, (WINDOW, WINDOW), (0, 1))[:-1:WINDOW // 2, :-1:WINDOW // 2]
        parts = parts.reshape(-1, 3, WINDOW**2)
        self.light = parts[:, 0].mean(1)
        residual = parts @ rest
        self.variance = (residual**2).sum(2) / (WINDOW**2 - 3)
        self.residual = residual.transpose(0, 2, 1).reshape(-1, WINDOW, WINDOW, 3)

    @classmethod
    def of(cls, images):
        """Those of all images in one."""
        return cls.join([cls(image) for image in images])

    @classmethod
    def join(cls, parts):
        all_windows = cls.__new__(cls)
        for name in ("light", "variance", "residual"):
            setattr(all_windows, name, np.concatenate([getattr(part, name) for part in parts]))
        return all_windows

    def __getitem__(self, chosen):
        part = Windows.__new__(Windows)
        part.light, part.variance, part.residual = self.light[chosen], self.variance[chosen], self.residual[chosen]
        return part

    def __len__(self):
        return len(self.light)

    def plainest(self, share):
        """The windows that vary least, all channels together."""
        sums = self.variance.sum(1)
        return self[sums < np.quantile(sums, share)]


def neighbors(residual, axis):
    """Products of neighbors, in a row (axis 2) or in a column (axis 1)."""
    size = residual.shape[axis]
    return residual.take(range(1, size), axis) * residual.take(range(size - 1), axis)


def correlation_of_neighbors(residual, axis, each=False):
    """Of the noise, by channel; of each window by itself or of all together."""
    over = (1, 2) if each else (0, 1, 2)
    return neighbors(residual, axis).mean(over) / np.maximum((residual**2).mean(over), 1e-9)


def correlation_of_channels(residual):
    """Of Y with Cb, Y with Cr and Cb with Cr, of each window (n x 3)."""
    power = (residual**2).mean((1, 2))
    pairs = [(0, 1), (0, 2), (1, 2)]
    shared = [(residual[..., a] * residual[..., b]).mean((1, 2)) for a, b in pairs]
    own = [np.sqrt(np.maximum(power[:, a] * power[:, b], 1e-9)) for a, b in pairs]
    return np.stack(shared, 1) / np.stack(own, 1)


def spectrum(residual, axis):
    """Power of the noise by frequency (cycles per pixel) and channel, along rows (axis 2) or columns."""
    power = (np.abs(np.fft.rfft(residual, axis=axis)) ** 2 / WINDOW).mean(tuple(a for a in range(3) if a != axis))
    return np.fft.rfftfreq(WINDOW)[1:], power[1:]


def steps(image, channel, along_columns):
    """Clear steps between two plain sides, of edges nearly perpendicular to the lines that cross them: places
    relative to the middle, and levels 0 to 1 (n x 19)."""
    plane = image[..., channel].T if along_columns else image[..., channel]
    lines = sliding_window_view(plane, 2 * REACH + 1, 1)[:, 1:-1]
    low, high = lines[1:-1, :, :5], lines[1:-1, :, -5:]
    rise = high.mean(2) - low.mean(2)
    # By how many pixels the edge moves from a line to the next.
    slant = (lines[2:] - lines[:-2]).sum(2) / 2 / np.where(rise == 0, np.inf, rise)
    least = 50 if channel == 0 else 25
    clear = (low.std(2) < 4) & (high.std(2) < 4) & (abs(rise) > least) & (abs(slant) < MOST_SLANT)
    level = (lines[1:-1][clear] - low.mean(2)[clear][:, None]) / rise[clear][:, None]
    level = level[(level[:, REACH - 1] < 0.5) & (level[:, REACH] >= 0.5)]
    before, behind = level[:, REACH - 1], level[:, REACH]
    return np.arange(1 - REACH, REACH + 2) - ((0.5 - before) / (behind - before))[:, None], level


def profile_of_steps(place, level):
    """The median level at each of BINS."""
    return np.array([np.median(level[abs(place - b) <= 0.25]) for b in BINS])


def width(place, level):
    """The way from 10 to 90 % of one step or of a profile, pixels."""
    low, high = np.interp((0.1, 0.9), np.maximum.accumulate(level), place)
    return high - low


def from_middle(image):
    """The squared distance of each pixel from the middle: 0 there, 1 in the corners."""
    height, width = image.shape[:2]
    y, x = np.mgrid[0:height, 0:width] + 0.5
    return ((2 * x / width - 1) ** 2 + (2 * y / height - 1) ** 2) / 2


def carpet(image):
    """Which pixels show a green carpet: cr below 124, cb below 135, the lower part, not black."""
    lower = np.arange(image.shape[0])[:, None] + 0.5 > 0.37 * image.shape[0]
    return (image[..., 2] < 124) & (image[..., 1] < 135) & lower & (image[..., 0] > 15)


def rim(image):
    """The share of light that is lost in the corners and what is added to cb and cr there, as the carpet
    shows it; None where there is little carpet."""
    green = carpet(image)
    if green.mean() < 0.15:
        return None
    terms = np.stack([np.ones(green.sum()), from_middle(image)[green]], 1)
    fits = [np.linalg.lstsq(terms, image[..., c][green], rcond=None)[0] for c in range(3)]
    lost = -fits[0][1] / fits[0][0]
    return (lost, *(fits[c][1] - lost * (128 - fits[c][0]) for c in (1, 2)))


def line(image):
    """Which pixels show a white line: gray, much brighter than the carpet that is above and below."""
    green = carpet(image)
    if not green.any():
        return green
    near = 12  # pixels
    padded = np.pad(green, ((near, near), (0, 0)))
    above = sliding_window_view(padded[:-near - 1], near, 0).any(2)
    below = sliding_window_view(padded[near + 1:], near, 0).any(2)
    gray = (abs(image[..., 1:] - 128) < 30).all(2)
    return gray & above & below & (image[..., 0] > 1.3 * np.median(image[..., 0][green]))
