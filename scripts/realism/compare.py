"""How far apart two sets of images are, and whether a classifier can tell them apart."""
import numpy as np
from scipy.spatial.distance import jensenshannon
from scipy.stats import ks_2samp
from sklearn.ensemble import RandomForestClassifier
from sklearn.metrics import balanced_accuracy_score

from realism import measures
from realism.measures import CHANNELS

BAND = 32  # of brightness
LEAST = 50  # windows or steps that a comparison takes
PLACES = np.linspace(-1.5, 1.5, 21)  # degrees
DIRECTIONS = ("rows", "columns")
KINDS = [(channel, direction) for channel in range(3) for direction in range(2)]
NOISE = ([f"noise {c}" for c in CHANNELS] + [f"neighbors in a row {c}" for c in CHANNELS] +
         [f"neighbors in a column {c}" for c in CHANNELS] + ["Y with Cb", "Y with Cr", "Cb with Cr"])
EDGES = [f"edge {CHANNELS[c]} along {DIRECTIONS[d]}" for c, d in KINDS]


class ImageSet:
    """Images of one camera with what is measured in them: windows (the plainest quarter in each band of
    brightness) and steps; both have the number of their image. Lengths of steps are in degrees."""

    def __init__(self, name, images, focal_length):
        self.name = name
        self.pixel = np.degrees(1 / focal_length)
        self.images = [image.astype(np.float32) for image in images]
        parts = [measures.Windows(image) for image in self.images]
        windows = measures.Windows.join(parts)
        image = np.repeat(np.arange(len(parts)), [len(part) for part in parts])
        chosen = []
        for low in range(0, 256, BAND):
            band = np.flatnonzero((windows.light >= low) & (windows.light < low + BAND))
            if len(band) >= LEAST:
                sums = windows.variance[band].sum(1)
                chosen.append(band[sums <= np.quantile(sums, 0.25)])
        chosen = np.concatenate(chosen)
        self.windows, self.window_image = windows[chosen], image[chosen]
        residual = self.windows.residual
        self.noise = np.concatenate(
            [np.sqrt(self.windows.variance), measures.correlation_of_neighbors(residual, 2, each=True),
             measures.correlation_of_neighbors(residual, 1, each=True),
             measures.correlation_of_channels(residual)], 1)
        self.steps = {kind: self.steps_of(*kind) for kind in KINDS}

    def steps_of(self, channel, along_columns):
        """Of all images: the number of the image, places and levels."""
        found = [measures.steps(image, channel, along_columns) for image in self.images]
        number = np.repeat(np.arange(len(found)), [len(place) for place, _ in found])
        place, level = (np.concatenate(part) for part in zip(*found))
        return number, place * self.pixel, level

    def part(self, images):
        """The same of some of the images only."""
        some = ImageSet.__new__(ImageSet)
        some.name, some.pixel, some.images = self.name, self.pixel, [self.images[i] for i in images]
        kept = np.isin(self.window_image, images)
        some.windows, some.noise = self.windows[kept], self.noise[kept]
        some.window_image = np.searchsorted(images, self.window_image[kept])
        some.steps = {}
        for kind, (number, place, level) in self.steps.items():
            kept = np.isin(number, images)
            some.steps[kind] = np.searchsorted(images, number[kept]), place[kept], level[kept]
        return some

    def widths(self, kind):
        _, place, level = self.steps[kind]
        return np.array([measures.width(p, v) for p, v in zip(place, level)])

    def profile(self, kind):
        """Places, levels and width of the median step; None if there are too few."""
        _, place, level = self.steps[kind]
        if len(place) < LEAST:
            return None
        edge = measures.profile_of_steps(place / self.pixel, level)
        bins = measures.BINS * self.pixel
        return bins, edge, measures.width(bins, edge)

    def rims(self):
        return [found for found in map(measures.rim, self.images) if found]


def matched(a, b, chance):
    """As many windows of either set in each band of brightness: their numbers."""
    chosen = [], []
    for low in range(0, 256, BAND):
        bands = [np.flatnonzero((s.windows.light >= low) & (s.windows.light < low + BAND)) for s in (a, b)]
        size = min(map(len, bands))
        if size >= LEAST:
            for list_, band in zip(chosen, bands):
                list_.append(chance.choice(band, size, replace=False))
    return [np.concatenate(list_) if list_ else np.array([], int) for list_ in chosen]


def distances(a, b):
    """By feature the Kolmogorov-Smirnov distance of both sets: the greatest difference of the cumulative
    distributions. 0: distributed alike; 1: one threshold separates them. Features with too few values are left out."""
    of_a, of_b = matched(a, b, np.random.default_rng(1))
    found = {}
    if len(of_a):
        for feature, name in enumerate(NOISE):
            found[name] = ks_2samp(a.noise[of_a, feature], b.noise[of_b, feature]).statistic
    for kind, name in zip(KINDS, EDGES):
        widths = a.widths(kind), b.widths(kind)
        if min(map(len, widths)) >= LEAST:
            found[name] = ks_2samp(*widths).statistic
    return found


def cross_validated(real, simulated, folds):
    """Accuracies of a random forest, by fold. Both arguments are the numbers of images and features."""
    accuracies = []
    number = np.concatenate([real[0], simulated[0]])
    features = np.concatenate([real[1], simulated[1]])
    truth = np.repeat([1, 0], [len(real[0]), len(simulated[0])])
    for fold in range(folds):
        test = number % folds == fold
        if min(np.bincount(truth[test], minlength=2)) < 10:
            continue
        forest = RandomForestClassifier(100, min_samples_leaf=5, class_weight="balanced", random_state=1)
        forest.fit(features[~test], truth[~test])
        accuracies.append(balanced_accuracy_score(truth[test], forest.predict(features[test])))
    return accuracies


def noise_accuracies(real, simulated):
    """Can windows be told apart by their noise? An image is either learned from or tested on."""
    of_real, of_simulated = matched(real, simulated, np.random.default_rng(2))
    return cross_validated((real.window_image[of_real], real.noise[of_real]),
                           (simulated.window_image[of_simulated], simulated.noise[of_simulated]), len(real.images))


def edge_accuracies(real, simulated):
    """Can steps be told apart by their profiles? As many of each kind from either set."""
    chance = np.random.default_rng(3)
    rows = [], []
    for at, kind in enumerate(KINDS):
        sets = [s.steps[kind] for s in (real, simulated)]
        size = min(len(s[0]) for s in sets)
        for list_, (number, place, level) in zip(rows, sets):
            for i in chance.choice(len(number), size, replace=False):
                list_.append((number[i], *np.interp(PLACES, place[i], level[i]), at))
    real_rows, simulated_rows = map(np.array, rows)
    return cross_validated((real_rows[:, 0].astype(int), real_rows[:, 1:]),
                           (simulated_rows[:, 0].astype(int), simulated_rows[:, 1:]), len(real.images))


def histograms(images, mask):
    """Shares of the values 0 to 255 in 64 bins, by channel, of the pixels that a mask chooses; None if they are few."""
    pixels = np.concatenate([image[mask(image)] for image in images])
    if len(pixels) < 500:
        return None
    return np.stack([np.histogram(pixels[:, c], 64, (0, 256))[0] / len(pixels) for c in range(3)])


def divergence(a, b):
    """The mean Jensen-Shannon divergence of the channels' histograms, in bits: 0 alike, 1 nothing in common."""
    return float(np.mean([jensenshannon(p, q, base=2) ** 2 for p, q in zip(a, b)]))


REGIONS = {
    "green": measures.carpet,
    "lines": measures.line,
    "background": lambda image: ~measures.carpet(image) & ~measures.line(image),
}
