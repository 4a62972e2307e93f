"""The page with real images beside simulated ones: charts, tables, HTML."""
import html

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

from realism import compare, measures
from realism.measures import CHANNELS

SHOWN = 6  # images of each set
COLORS = {"ERS-7": "black", "NAO": "gray", "benign": "tab:blue", "padova": "tab:green", "rough": "tab:red"}

STYLE = """body{font-family:sans-serif;max-width:76em;margin:2em auto;padding:0 1em;color:#222}
img{max-width:100%} table{border-collapse:collapse;margin:1em 0} td,th{padding:.2em .7em;border-bottom:1px solid #ddd;
text-align:right} td:first-child,th:first-child{text-align:left} figure{margin:1.5em 0} figcaption{color:#555}"""


def rgb(image):
    return Image.fromarray(image.astype(np.uint8), "YCbCr").convert("RGB")


def gallery(sets, file):
    """A row of images of each set; below each image its plainest window of middle brightness, enlarged, with
    eight times the contrast."""
    figure, axes = plt.subplots(2 * len(sets), SHOWN, figsize=(15, 4.4 * len(sets)),
                                gridspec_kw={"height_ratios": [4, 2.2] * len(sets)})
    for axis in axes.ravel():
        axis.axis("off")
    for row, images in enumerate(sets):
        numbers = np.linspace(0, len(images.images) - 1, min(SHOWN, len(images.images))).astype(int)
        for column, number in enumerate(numbers):
            image = images.images[number]
            axes[2 * row, column].imshow(rgb(image))
            found = np.flatnonzero(images.window_image == number)
            if len(found):
                plain = images.windows.residual[found[images.windows.variance[found].sum(1).argmin()]]
                patch = np.clip(128 + 8 * plain, 0, 255)
                axes[2 * row + 1, column].imshow(rgb(patch), interpolation="nearest")
        axes[2 * row, 0].set_title(images.name, loc="left", fontsize=16)
    save(figure, file)


def save(figure, file):
    figure.tight_layout()
    figure.savefig(file, dpi=80)
    plt.close(figure)


def panels(rows):
    return plt.subplots(rows, 3, figsize=(15, 3.6 * rows), squeeze=False)


def spectra(sets, file):
    figure, axes = panels(2)
    for row, (axis, direction) in enumerate(((2, "rows"), (1, "columns"))):
        for channel, name in enumerate(CHANNELS):
            chart = axes[row][channel]
            for images in sets:
                frequency, power = measures.spectrum(images.windows.residual, axis)
                chart.semilogy(frequency, power[:, channel], "o-", color=COLORS[images.name], label=images.name)
            chart.set(title=f"{name} along {direction}", xlabel="cycles per pixel", ylabel="power per pixel")
            chart.grid(alpha=0.3)
    axes[0][0].legend()
    save(figure, file)


def noise_by_light(sets, file):
    figure, axes = panels(1)
    middles = np.arange(0, 256, compare.BAND) + compare.BAND / 2
    for channel, name in enumerate(CHANNELS):
        chart = axes[0][channel]
        for images in sets:
            band = images.windows.light // compare.BAND
            values = [np.median(images.noise[band == b, channel]) if (band == b).sum() >= compare.LEAST else np.nan
                      for b in range(len(middles))]
            chart.plot(middles, values, "o-", color=COLORS[images.name], label=images.name)
        chart.set(title=f"noise of {name}", xlabel="Y", ylabel="standard deviation", ylim=(0, None))
        chart.grid(alpha=0.3)
    axes[0][0].legend()
    save(figure, file)


def edges(sets, file):
    figure, axes = panels(2)
    for channel, direction in compare.KINDS:
        chart = axes[direction][channel]
        for images in sets:
            found = images.profile((channel, direction))
            if found:
                chart.plot(*found[:2], color=COLORS[images.name], label=f"{images.name}: {found[2]:.2f} degrees")
        chart.set(title=f"{CHANNELS[channel]} along {compare.DIRECTIONS[direction]}", xlabel="degrees from the middle",
                  ylabel="share of the step", xlim=(-1.8, 1.8))
        chart.legend()
        chart.grid(alpha=0.3)
    save(figure, file)


def corners(sets, file):
    figure, axes = panels(1)
    bins = np.linspace(0, 1, 11)
    middles = (bins[1:] + bins[:-1]) / 2
    for images in sets:
        lines = []
        for image in images.images:
            if not measures.rim(image):
                continue
            green = measures.carpet(image)
            place = np.digitize(measures.from_middle(image)[green], bins) - 1
            values = image[green]
            line = np.array([values[place == b].mean(0) if (place == b).sum() > 30 else [np.nan] * 3
                             for b in range(len(middles))])
            inner = np.nanmean(line[:3], 0)
            lines.append(np.stack([line[:, 0] / inner[0], line[:, 1] - inner[1], line[:, 2] - inner[2]], 1))
        if not lines:
            continue
        lines = np.array(lines)
        seen = np.isfinite(lines[..., 0]).any(0)
        middle = np.nanmedian(lines[:, seen], 0)
        for channel in range(3):
            axes[0][channel].plot(middles[seen], middle[:, channel], "o-", color=COLORS[images.name],
                                  label=f"{images.name} ({len(lines)} images)")
    for channel, label in enumerate(("Y over that of the middle", "Cb less that of the middle",
                                     "Cr less that of the middle")):
        axes[0][channel].set(title=f"carpet, {CHANNELS[channel]}", ylabel=label,
                             xlabel="squared distance from the middle (corner: 1)")
        axes[0][channel].grid(alpha=0.3)
    axes[0][0].legend()
    save(figure, file)


def colors(sets, file):
    figure, axes = panels(len(compare.REGIONS))
    for row, (region, mask) in enumerate(compare.REGIONS.items()):
        for images in sets:
            if region == "lines" and images.name == "ERS-7":  # There are none.
                continue
            found = compare.histograms(images.images, mask)
            if found is None:
                continue
            for channel in range(3):
                axes[row][channel].step(np.arange(64) * 4, found[channel], where="post", color=COLORS[images.name],
                                        label=images.name)
        for channel, name in enumerate(CHANNELS):
            axes[row][channel].set(title=f"{name} of {region}", xlabel=name, ylabel="share of pixels")
        axes[row][0].legend()
    save(figure, file)


def features(distances, file):
    figure, chart = plt.subplots(figsize=(15, 7))
    names = compare.NOISE + compare.EDGES
    width = 0.8 / len(distances)
    for at, (name, found) in enumerate(distances.items()):
        chart.bar(np.arange(len(names)) + at * width, [found.get(feature, 0) for feature in names], width,
                  color=COLORS[name], label=name)
    chart.set_xticks(np.arange(len(names)) + 0.4, names, rotation=60, ha="right")
    chart.set(ylabel="distance from the ERS-7", ylim=(0, 1))
    chart.legend()
    save(figure, file)


CHARTS = (
    ("images.png", gallery, "Real and simulated images. Below each: the noise of its plainest window of 8 x 8 pixels, "
     "with eight times the contrast."),
    ("spectra.png", spectra, "Spectra of the noise in the plainest quarter of the windows of each band of brightness. "
     "A level line is white noise; what is lowest in frequency is lost with the plane of each window."),
    ("noise.png", noise_by_light, "Noise by brightness, median of the same windows."),
    ("edges.png", edges, "Profiles of steps between plain sides, and their widths from 10 to 90 %."),
    ("corners.png", corners, "What the carpet tells of the light and the color cast toward the corners."),
    ("colors.png", colors, "Colors of the field's green, its lines (none in the ERS-7's images), and all else."),
)


def table(heading, rows):
    cells = ["<tr>" + "".join(f"<th>{html.escape(str(cell))}</th>" for cell in heading) + "</tr>"]
    cells += ["<tr>" + "".join(f"<td>{html.escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows]
    return "<table>" + "\n".join(cells) + "</table>"


def write(out, sets, distances, tables):
    """Writes index.html with its charts. `distances` are by set and feature; `tables` are pairs of a sentence and rows,
    the first of which is the heading."""
    parts = ["<!doctype html><meta charset=utf-8><title>Real images beside simulated ones</title>",
             f"<style>{STYLE}</style><h1>Real images beside simulated ones</h1>",
             "<p>" + html.escape(", ".join(f"{images.name}: {len(images.images)} images" for images in sets)) +
             ". docs/realism.md says what the figures mean.</p>"]
    for sentence, (heading, *rows) in tables:
        parts.append(f"<p>{html.escape(sentence)}</p>" + table(heading, rows))
    for file, draw, caption in CHARTS:
        draw(sets, out / file)
        parts.append(f"<figure><img src={file}><figcaption>{html.escape(caption)}</figcaption></figure>")
    features(distances, out / "features.png")
    parts.append("<figure><img src=features.png><figcaption>Distance from the ERS-7's images by feature."
                 "</figcaption></figure>")
    (out / "index.html").write_text("\n".join(parts))
