#!/usr/bin/python3
"""The paper's schematics in this project's conventions, as one SVG file: the network and the model, the way of
a direction to the surface, the height of domes, and the projection of a picture to the sphere.

    paper_schematics.py [--output schematics.svg]
"""
import argparse
import math
import os
import sys

WIDTH, HEIGHT = 300, 260  # of a panel
LINE, FILL, MARK = "#34495e", "#dbe7f3", "#c0392b"


class Panel:
    """Shapes in a panel's own coordinates, x to the right and y up, about [-1.3, 1.3] by [-1, 1]."""

    def __init__(self, title):
        self.title, self.shapes = title, []

    @staticmethod
    def place(point):
        return WIDTH * (0.5 + point[0] / 2.8), HEIGHT * (0.55 - point[1] / 2.5)

    def path(self, points, closed=False, color=LINE, fill="none", dashes=""):
        places = " L ".join(f"{x:.1f} {y:.1f}" for x, y in map(self.place, points))
        self.shapes.append(f'<path d="M {places}{" Z" if closed else ""}" fill="{fill}" stroke="{color}" '
                           f'stroke-width="1.5" stroke-dasharray="{dashes}"/>')

    def dot(self, point, label="", to=(6, -6)):
        x, y = self.place(point)
        self.shapes.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{MARK}"/>')
        self.text(point, label, to)

    def text(self, point, label, to=(0, 0)):
        x, y = self.place(point)
        self.shapes.append(f'<text x="{x + to[0]:.1f}" y="{y + to[1]:.1f}">{label}</text>')

    def svg(self, left):
        return (f'<g transform="translate({left}, 0)"><text x="10" y="18" font-weight="bold">{self.title}'
                f'</text>{"".join(self.shapes)}</g>')


def arc(begin, end, radius=1.0, middle=(0.0, 0.0)):
    """Points of a circle between two angles in degrees."""
    angles = [math.radians(begin + (end - begin) * i / 40) for i in range(41)]
    return [(middle[0] + radius * math.cos(a), middle[1] + radius * math.sin(a)) for a in angles]


def between(a, b, share):
    return tuple((1.0 - share) * p + share * q for p, q in zip(a, b))


def network():
    panel = Panel("Network and model")
    place, model = [(-1.2, -0.4), (-0.3, -0.4), (-0.75, 0.4)], [(0.2, -0.5), (1.2, -0.2), (0.5, 0.6)]
    for corners, name in ((place, "n"), (model, "w")):
        panel.path(corners, closed=True, fill=FILL)
        for corner, index, to in zip(corners, "ijk", ((-4, 16), (-4, 16), (-4, -8))):
            panel.dot(corner, f"{name}<tspan dy=\"4\" font-size=\"9\">{index}</tspan>", to)
    panel.dot((-0.75, -0.1), "r = M(x)", (-24, 18))
    panel.dot((0.62, -0.02), "foot of x", (-26, 18))
    panel.path([(0.55, 0.0), (-0.05, 0.2), (-0.65, -0.05)], color=MARK, dashes="4 3")
    panel.text((-0.95, 0.8), "Eqs. 4 and 5: conformal")
    return panel


def projection():
    panel = Panel("p, p', q' and q (Eqs. 9 to 12)")
    center, flat = (-0.75, -0.6), ((-1.3, 0.2), (-0.2, 0.2))
    radius = math.dist(center, flat[0])
    angles = [math.degrees(math.atan2(y - center[1], x - center[0])) for x, y in flat]
    panel.path(arc(angles[0], angles[1], radius, center))
    panel.path(flat)
    below = between(*flat, 0.6)
    length = math.dist(center, below)
    panel.path([center, between(center, below, radius / length)], dashes="4 3")
    panel.dot(center, "c", (8, 4))
    panel.dot(below, "p'", (6, 14))
    panel.dot(between(center, below, radius / length), "p")
    model = ((0.25, -0.3), (1.25, 0.1))
    panel.path(model)
    panel.path([between(*model, t) if t in (0.0, 1.0) else
                (between(*model, t)[0] - 0.28 * t * (1 - t), between(*model, t)[1] + 0.75 * t * (1 - t))
                for t in (i / 30 for i in range(31))])
    foot = between(*model, 0.6)
    panel.dot(foot, "q'", (6, 14))
    panel.dot((foot[0] - 0.28 * 0.24, foot[1] + 0.75 * 0.24), "q")
    return panel


def domes():
    panel = Panel("Published, and Curvature")
    for left, inwards in ((-1.2, False), (0.15, True)):
        corners = [(left, 0.1), (left + 0.55, -0.35), (left + 1.1, 0.1)]
        panel.path(corners)
        for a, b in zip(corners, corners[1:]):
            side = -1.0 if inwards else 1.0
            panel.path([(x - side * 0.3 * t * (1 - t) * (b[1] - a[1]) * 2,
                         y + side * 0.5 * t * (1 - t)) for t in (i / 20 for i in range(21))
                        for x, y in (between(a, b, t),)], color=MARK)
        for corner in corners:
            panel.dot(corner)
    panel.text((-1.2, 0.5), "outwards in hollows")
    panel.text((0.15, 0.5), "with the hollow")
    return panel


def texture():
    panel = Panel("A picture on the sphere")
    panel.path(arc(0, 360, 0.6, (0.0, -0.2)), fill=FILL)
    panel.path([(-1.2, 0.4), (1.2, 0.4)])
    south, top = (0.0, -0.8), (0.0, 0.4)
    panel.dot(south)
    panel.dot(top, "view point", (-30, -8))
    for x in (0.5, 1.0):
        # The second intersection of the line with the sphere.
        share = 1.44 / (x * x + 1.44)
        panel.path([south, (x, 0.4)], dashes="4 3")
        panel.dot(between(south, (x, 0.4), share))
        panel.dot((x, 0.4))
    panel.text((-1.2, 0.5), "picture")
    return panel


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", metavar="FILE", default="schematics.svg", help="default schematics.svg")
    output = parser.parse_args().output
    if os.path.lexists(output):
        parser.error(f"{output} already exists")
    panels = [network(), projection(), domes(), texture()]
    body = "".join(panel.svg(i * WIDTH) for i, panel in enumerate(panels))
    with open(output, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{len(panels) * WIDTH}" height="{HEIGHT}" '
                   f'font-family="sans-serif" font-size="13"><rect width="100%" height="100%" '
                   f'fill="white"/>{body}</svg>\n')


if __name__ == "__main__":
    try:
        main()
    except OSError as error:
        sys.exit(f"paper_schematics: {error}")
