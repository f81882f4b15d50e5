# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots with two logarithmic axes, written as SVG by Python alone."""

import math
from html import escape

COLOURS = ["#1f6fb4", "#d9541e", "#2a9d4a", "#8d4bb0", "#a3741c", "#c2307e", "#5a6472", "#16a3a8", "#000000", "#8aa800"]
COLOURS += ["#e8a317", "#5b2a86", "#7fb3e0"]
MARKERS = "osdt"  # circle, square, diamond, triangle
WIDTH, HEIGHT = 640, 420
LEFT, TOP, BOTTOM = 72, 40, 56


def number(x):
    """A short label of a value."""
    if x == 0:
        return "0"
    if 1e-3 <= abs(x) < 1e4:
        return f"{x:g}"
    exponent = math.floor(math.log10(abs(x)) + 1e-9)
    mantissa = x / 10**exponent
    power = f"1e{exponent}"
    return power if abs(mantissa - 1) < 1e-9 else f"{mantissa:g}e{exponent}"


class Axis:
    """Maps values to positions on a line, by their logarithms."""

    def __init__(self, values, start, end):
        low, high = math.log10(min(values)), math.log10(max(values))
        margin = max(0.06 * (high - low), 0.08)
        self.low, self.high, self.start, self.end = low - margin, high + margin, start, end

    def __call__(self, value):
        part = (math.log10(value) - self.low) / (self.high - self.low)
        return self.start + part * (self.end - self.start)

    def ticks(self):
        """Powers of ten if there are enough of them, with 2 and 5 if not."""
        steps = [1] if self.high - self.low > 2.5 else [1, 2, 5]
        if self.high - self.low < 0.9:
            steps = [1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9]
        skip = max(1, math.ceil((self.high - self.low) / 9))
        for exponent in range(math.floor(self.low), math.ceil(self.high) + 1):
            if exponent % skip:
                continue
            for step in steps:
                if self.low <= exponent + math.log10(step) <= self.high:
                    yield step * 10.0**exponent


def marker(kind, x, y, colour):
    if kind == "o":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.6" fill="{colour}"/>'
    corners = {
        "s": [(-3.3, -3.3), (3.3, -3.3), (3.3, 3.3), (-3.3, 3.3)],
        "d": [(0, -4.6), (4.6, 0), (0, 4.6), (-4.6, 0)],
        "t": [(0, -4.6), (4.2, 3.4), (-4.2, 3.4)],
    }[kind]
    points = " ".join(f"{x + dx:.1f},{y + dy:.1f}" for dx, dy in corners)
    return f'<polygon points="{points}" fill="{colour}"/>'


def write_plot(path, title, x_label, y_label, series, lines=True):
    """`series`: pairs of a label and a list of points (x, y); only points with positive coordinates are drawn."""
    series = [(label, [p for p in points if p[0] > 0 and p[1] > 0]) for label, points in series]
    series = [s for s in series if s[1]]
    if not series:
        return False
    legend_width = 32 + round(6.3 * max(len(label) for label, _ in series))
    right = WIDTH - 14
    x_axis = Axis([p[0] for _, points in series for p in points], LEFT, right)
    y_axis = Axis([p[1] for _, points in series for p in points], HEIGHT - BOTTOM, TOP)
    total = WIDTH + legend_width
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{total}" height="{HEIGHT}" viewBox="0 0 {total} {HEIGHT}" '
        'font-family="sans-serif" font-size="12">',
        f'<rect width="{total}" height="{HEIGHT}" fill="white"/>',
        f'<text x="{LEFT}" y="24" font-size="15">{escape(title)}</text>',
    ]
    for value in x_axis.ticks():
        x = x_axis(value)
        out.append(f'<path d="M{x:.1f},{TOP}V{HEIGHT - BOTTOM}" stroke="#dddddd"/>')
        out.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{number(value)}</text>')
    for value in y_axis.ticks():
        y = y_axis(value)
        out.append(f'<path d="M{LEFT},{y:.1f}H{right}" stroke="#dddddd"/>')
        out.append(f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{number(value)}</text>')
    out.append(
        f'<rect x="{LEFT}" y="{TOP}" width="{right - LEFT}" height="{HEIGHT - BOTTOM - TOP}" fill="none" stroke="#444444"/>'
    )
    middle = (LEFT + right) / 2
    out.append(f'<text x="{middle}" y="{HEIGHT - 14}" text-anchor="middle">{escape(x_label)}</text>')
    out.append(
        f'<text transform="translate(18,{(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle">'
        f"{escape(y_label)}</text>"
    )
    for i, (label, points) in enumerate(series):
        colour, kind = COLOURS[i % len(COLOURS)], MARKERS[i % len(MARKERS)]
        places = [(x_axis(x), y_axis(y)) for x, y in points]
        if lines:
            bends = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
            out.append(f'<polyline points="{bends}" fill="none" stroke="{colour}" stroke-width="1.4"/>')
        out += [marker(kind, x, y, colour) for x, y in places]
        y = TOP + 14 + 19 * i
        out.append(marker(kind, WIDTH + 6, y - 4, colour))
        out.append(f'<text x="{WIDTH + 16}" y="{y}">{escape(label)}</text>')
    out.append("</svg>")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(out) + "\n")
    return True
