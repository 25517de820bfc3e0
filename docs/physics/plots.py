#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The plots and tables of docs/physics.md, from `kushi rod --json`, `kushi bench --growth --json`
and the references of the tests.

    docs/physics/plots.py build/release/apps/cli/kushi

writes docs/physics/*.svg and prints the table of tip errors.
"""

import csv
import json
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SEGMENTS = (5, 10, 20, 40, 80)
COLORS = {"equilibrium": "#1b6ca8", "cantilever": "#c2571a", "reference": "#222222"}


def references():
    with open(ROOT / "tests/rod/heavy_elastica.csv", encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [
            (float(r["load_parameter"]), float(r["x_tip_over_L"]), float(r["y_tip_over_L"]))
            for r in rows
            if r["load"] == "self_weight" and float(r["clamp_deg"]) == 0
        ]


def rod(kushi, gamma, segments, method):
    """Nodes of a level rod of a metre with EI = 1 N m2, whose weight per metre is then Gamma."""
    out = subprocess.run(
        [kushi, "rod", "--length", "100", "--segments", str(segments), "--rigidity", "1",
         "--weight", repr(gamma), "--angle", "0", "--method", method, "--json"],
        check=True, capture_output=True, text=True).stdout
    return json.loads(out)["nodes"]


def dashed(pattern):
    return f' stroke-dasharray="{pattern}"' if pattern else ""


class Plot:
    """An SVG with two axes, each linear or logarithmic."""

    def __init__(self, title, x, y, size=(640, 420)):
        self.width, self.height = size
        self.x, self.y = x, y  # (label, low, high, log, ticks)
        self.parts = [
            f'<text x="{self.width / 2:.0f}" y="24" text-anchor="middle" font-size="15">{title}</text>'
        ]
        self.legend_at = 0
        self._axes()

    def _share(self, axis, value):
        _, low, high, log, _ = axis
        if log:
            return math.log(value / low) / math.log(high / low)
        return (value - low) / (high - low)

    def at(self, x, y):
        return (70 + self._share(self.x, x) * (self.width - 95),
                self.height - 55 - self._share(self.y, y) * (self.height - 100))

    def _axes(self):
        _, x0, x1, _, xticks = self.x
        _, y0, y1, _, yticks = self.y
        left, bottom = self.at(x0, y0)
        right, top = self.at(x1, y1)
        for value in xticks:
            px, _ = self.at(value, y0)
            self.parts.append(f'<path d="M{px:.1f} {bottom:.1f}V{top:.1f}" stroke="#ddd"/>'
                              f'<text x="{px:.1f}" y="{bottom + 18:.1f}" text-anchor="middle">{value:g}</text>')
        for value in yticks:
            _, py = self.at(x0, value)
            self.parts.append(f'<path d="M{left:.1f} {py:.1f}H{right:.1f}" stroke="#ddd"/>'
                              f'<text x="{left - 7:.1f}" y="{py + 4:.1f}" text-anchor="end">{value:g}</text>')
        self.parts.append(f'<rect x="{left:.1f}" y="{top:.1f}" width="{right - left:.1f}" '
                          f'height="{bottom - top:.1f}" fill="none" stroke="#666"/>')
        self.parts.append(f'<text x="{(left + right) / 2:.0f}" y="{self.height - 15}" '
                          f'text-anchor="middle">{self.x[0]}</text>')
        self.parts.append(f'<text transform="translate(18 {(top + bottom) / 2:.0f}) rotate(-90)" '
                          f'text-anchor="middle">{self.y[0]}</text>')

    def line(self, points, color, dash=""):
        path = " ".join("{:.1f},{:.1f}".format(*self.at(x, y)) for x, y in points)
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{color}" '
                          f'stroke-width="1.8"{dashed(dash)}/>')

    def dots(self, points, color, radius=3.2):
        for x, y in points:
            px, py = self.at(x, y)
            self.parts.append(f'<circle cx="{px:.1f}" cy="{py:.1f}" r="{radius}" fill="{color}"/>')

    def note(self, text, x, y, color="#222"):
        px, py = self.at(x, y)
        self.parts.append(f'<text x="{px:.1f}" y="{py:.1f}" fill="{color}">{text}</text>')

    def legend(self, text, color, dash=""):
        y = 60 + 17 * self.legend_at
        self.legend_at += 1
        self.parts.append(f'<path d="M85 {y}h26" stroke="{color}" stroke-width="1.8"'
                          f'{dashed(dash)}/><text x="117" y="{y + 4}">{text}</text>')

    def write(self, name):
        body = "\n".join(self.parts)
        (HERE / name).write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
            f'font-family="sans-serif" font-size="12" fill="#222">\n'
            f'<rect width="100%" height="100%" fill="#fff"/>\n{body}\n</svg>\n', encoding="utf-8")


def master_curve(kushi):
    plot = Plot("A level rod under its own weight", ("Γ = w L³ / EI", 0.01, 1000, True,
                                                     (0.01, 0.1, 1, 10, 100, 1000)),
                ("H / W of the tip", 0.0005, 50, True, (0.001, 0.01, 0.1, 1, 10)))
    loads = [10 ** (-2 + 5 * i / 60) for i in range(61)]
    for method, dash in (("equilibrium", ""), ("cantilever", "6 3")):
        points = []
        for gamma in loads:
            x, y = rod(kushi, gamma, 20, method)[-1]
            # Past the vertical the walk has no such ratio.
            if x > 0 and 0.0005 <= -y / x <= 50:
                points.append((gamma, -y / x))
        plot.line(points, COLORS[method], dash)
        plot.legend(f"{method}, 20 segments", COLORS[method], dash)
    plot.dots([(g, -y / x) for g, x, y in references()], COLORS["reference"])
    plot.legend("continuous rod (dots)", COLORS["reference"], "1 5")
    plot.write("master-curve.svg")


def tip_errors(kushi):
    plot = Plot("Error of the tip, level clamp", ("segments", 4, 100, True, SEGMENTS),
                ("distance from the continuous rod / L", 1e-8, 1, True,
                 (1e-8, 1e-6, 1e-4, 1e-2, 1)))
    print("| Γ | " + " | ".join(f"n = {n}" for n in SEGMENTS) + " | "
          + " | ".join(f"paper, {n}" for n in SEGMENTS) + " |")
    print("|---" * (1 + 2 * len(SEGMENTS)) + "|")
    for gamma, x, y in references():
        if gamma not in (0.1, 1, 10, 100, 1000):
            continue
        row = [f"{gamma:g}"]
        for method, dash in (("equilibrium", ""), ("cantilever", "6 3")):
            points = []
            for n in SEGMENTS:
                tip = rod(kushi, gamma, n, method)[-1]
                points.append((n, math.hypot(tip[0] - x, tip[1] - y)))
                row.append(f"{points[-1][1]:.1e}")
            shown = [(n, max(e, 1e-8)) for n, e in points]
            plot.line(shown, COLORS[method], dash)
            plot.dots(shown, COLORS[method], 2.4)
            plot.note(f"{gamma:g}", 83, shown[-1][1], COLORS[method])
        print("| " + " | ".join(row) + " |")
    plot.legend("equilibrium, by Γ", COLORS["equilibrium"])
    plot.legend("cantilever, by Γ", COLORS["cantilever"], "6 3")
    plot.write("tip-error.svg")


def shapes(kushi):
    plot = Plot("Level rods of 25 segments", ("x / L", -0.25, 1.1, False, (0, 0.25, 0.5, 0.75, 1)),
                ("y / L", -1.05, 0.12, False, (-1, -0.75, -0.5, -0.25, 0)), (640, 580))
    known = {gamma: (x, y) for gamma, x, y in references()}
    for gamma in (1, 10, 100, 1000):
        for method, dash in (("equilibrium", ""), ("cantilever", "6 3")):
            nodes = rod(kushi, gamma, 25, method)
            plot.line(nodes, COLORS[method], dash)
            if method == "equilibrium":
                plot.note(f"Γ {gamma}", nodes[-1][0] + 0.015, nodes[-1][1] - 0.02)
        plot.dots([known[gamma]], COLORS["reference"])
    plot.legend("equilibrium", COLORS["equilibrium"])
    plot.legend("cantilever", COLORS["cantilever"], "6 3")
    plot.legend("tip of the continuous rod (dots)", COLORS["reference"], "1 5")
    plot.write("shapes.svg")


def growth(kushi):
    out = subprocess.run([kushi, "bench", "--growth", "--runs", "5", "--json"],
                         check=True, capture_output=True, text=True).stdout
    timings = json.loads(out)
    plot = Plot("Time to rest, two threads", ("nodes", 3e5, 2e7, True, (1e6, 1e7)),
                ("ms", 1, 3000, True, (1, 10, 100, 1000)))
    for name, color in (("equilibrium", "#1b6ca8"), ("contact", "#c2571a"), ("curly", "#3a7d44")):
        for state, dash in (("cold", ""), ("warm", "6 3")):
            points = sorted((t["strands"] * (t["segments"] + 1), t["median_ms"])
                            for t in timings if t["name"] == f"{name}-{state}")
            plot.line(points, color, dash)
            plot.dots(points, color, 2.4)
        plot.legend(f"{name}, cold (warm dashed)", color)
    plot.write("growth.svg")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for draw in (master_curve, tip_errors, shapes, growth):
        draw(sys.argv[1])


if __name__ == "__main__":
    main()
