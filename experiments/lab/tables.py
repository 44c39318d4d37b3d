"""A table as CSV, Markdown and LaTeX."""
from __future__ import annotations

import csv


def text(value):
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return f"{value:,}" if abs(value) >= 10_000 else str(value)
    return str(value)


def latex(value):
    for char in "%_&#":
        value = value.replace(char, "\\" + char)
    return value.replace("²", "$^2$").replace("±", "$\\pm$").replace("≤", "$\\le$").replace("×", "$\\times$")


def write(stem, caption, titles, lines):
    """`stem`.csv, `stem`.md and `stem`.tex. Numbers come formatted as text where their digits matter."""
    cells = [[text(value) for value in line] for line in lines]
    with open(f"{stem}.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(titles)
        writer.writerows([cell.replace(",", "") if cell.replace(",", "").isdigit() else cell for cell in line] for line in cells)
    with open(f"{stem}.md", "w") as file:
        file.write(f"{caption}\n\n| " + " | ".join(titles) + " |\n" + "|---" * len(titles) + "|\n")
        file.writelines("| " + " | ".join(line) + " |\n" for line in cells)
    with open(f"{stem}.tex", "w") as file:
        file.write(f"% {caption}\n\\begin{{tabular}}{{l{'r' * (len(titles) - 1)}}}\n\\hline\n")
        file.write(" & ".join(map(latex, titles)) + " \\\\\n\\hline\n")
        file.writelines(" & ".join(map(latex, line)) + " \\\\\n" for line in cells)
        file.write("\\hline\n\\end{tabular}\n")


def number(value, digits=3):
    """So many significant digits, no exponent; empty for nothing."""
    if value is None or value == "":
        return ""
    value = float(value)
    if value == 0:
        return "0"
    if abs(value) >= 10 ** digits:
        return f"{value:,.0f}"
    return f"{value:.{digits}g}"


def percent(share, digits=2):
    """A share as percent; what is not all never reads as 100, what is not nothing never as 0."""
    if share is None or share == "":
        return ""
    value = 100 * float(share)
    shown = f"{value:.{digits}f}"
    least = 10 ** -digits
    if value > 0 and float(shown) == 0:
        return f"< {least:.{digits}f}"
    if value < 100 and float(shown) >= 100:
        return f"> {100 - least:.{digits}f}"
    return shown
