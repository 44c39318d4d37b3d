"""Figures in one manner: PNG and PDF, colours that differ in grey too, no dates inside, so that equal data give equal files."""
from __future__ import annotations

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

# Okabe and Ito's colours, by falling contrast.
COLOURS = ["#000000", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]
MARKS = ["o", "s", "^", "D", "v", "P", "X"]

pyplot.rcParams.update({
    "figure.figsize": (6.0, 4.0), "figure.dpi": 110, "savefig.bbox": "tight", "font.size": 10, "axes.grid": True, "grid.alpha": 0.3,
    "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False, "lines.markersize": 5, "lines.linewidth": 1.4,
})


def axes(xlabel, ylabel, title="", log=""):
    figure, ax = pyplot.subplots()
    ax.set(xlabel=xlabel, ylabel=ylabel, title=title)
    if "x" in log:
        ax.set_xscale("log")
    if "y" in log:
        ax.set_yscale("log")
    return figure, ax


def style(index):
    return {"color": COLOURS[index % len(COLOURS)], "marker": MARKS[index % len(MARKS)]}


def save(figure, stem):
    figure.savefig(f"{stem}.png", metadata={"Software": None})
    figure.savefig(f"{stem}.pdf", metadata={"CreationDate": None, "Creator": None, "Producer": None})
    pyplot.close(figure)


def mean_and_interval(values):
    """Mean and half the width of its 95 % confidence interval (Student's t); no width for one value."""
    n = len(values)
    mean = sum(values) / n
    if n < 2:
        return mean, 0.0
    # Quantiles 0.975 of Student's t for 1, 2, ... degrees of freedom.
    quantiles = [12.71, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101,
                 2.093]
    t = quantiles[n - 2] if n - 2 < len(quantiles) else 1.96
    deviation = (sum((value - mean) ** 2 for value in values) / (n - 1)) ** 0.5
    return mean, t * deviation / n ** 0.5
