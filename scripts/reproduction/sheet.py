# SPDX-License-Identifier: GPL-2.0-or-later
"""What every figure shares: sheets of axes that can be printed in grey, and the files that go into docs/results."""
import csv
import io
import os

from PIL import Image

from appearance import MARKERS, plt, shades  # noqa: F401, for all figures

RESULTS = os.path.join("docs", "results")
plt.rcParams.update({"font.size": 9, "svg.hashsalt": "mikromakro", "lines.linewidth": 1.2})


def axes(columns=1, rows=1, width=5.4, height=3.9, **options):
    figure, sheet = plt.subplots(rows, columns, figsize=(width * columns, height * rows), **options)
    return figure, sheet


def save_picture(figure, name, dots_per_inch=110, colours=64, **options):
    """As PNG, which all browsers and printers show alike, and small."""
    os.makedirs(RESULTS, exist_ok=True)
    path = os.path.join(RESULTS, f"{name}.png")
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=dots_per_inch, format="png", **options)
    plt.close(figure)
    Image.open(drawn).convert("RGB").quantize(colours).save(path, optimize=True)
    return path


def written(value):
    return value if isinstance(value, str) else f"{value:.6g}"


def save_numbers(name, columns, notes=()):
    """A CSV of named columns, which may differ in length; `notes` come first as comments."""
    os.makedirs(RESULTS, exist_ok=True)
    with open(os.path.join(RESULTS, f"{name}.csv"), "w", newline="") as file:
        for note in notes:
            file.write(f"# {note}\n")
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(columns)
        length = max(len(values) for values in columns.values())
        for k in range(length):
            rows.writerow([written(values[k]) if k < len(values) else "" for values in columns.values()])
