"""The page of a study: one file that shows the mean with its modes by sliders, and the groups of the scans."""
import base64
import html
import json
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

FOLDER = os.path.dirname(os.path.abspath(__file__))
STEPS = 32767  # of coordinates, which have 16 bits


def template(page="shapes"):
    """The page of this name without data; raises OSError if the package is incomplete."""
    parts = []
    for name in (f"{page}.html", "base.css", "panel.css", f"{page}.css", "surface_view.js", f"{page}.js"):
        with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
            parts.append(file.read())
    text, *styles, view, program = parts
    program = f'"use strict";\n{{\n{view}{program}}}\n'
    return text.replace("{{style}}", "".join(styles)).replace("{{program}}", program)


def filled(text, title, description, data):
    """A template with its title, description (of JSON) and Data."""
    page = html.escape(title).join(text.split("{{title}}"))
    described = json.dumps(description).replace("<", "\\u003c")
    return page.replace("{{description}}", described).replace("{{data}}", base64.b64encode(data.bytes).decode())


class Data:
    """Arrays of a page: base64 of all, and where each begins."""

    def __init__(self):
        self.bytes = bytearray()

    def add(self, values, kind):
        """Append an array, aligned to 4 bytes; returns its place and its number of values."""
        self.bytes += bytes(-len(self.bytes) % 4)
        place = len(self.bytes)
        array = np.ascontiguousarray(values, dtype=kind)
        self.bytes += array.tobytes()
        return [place, array.size]

    def add_vectors(self, vectors):
        """Append vectors as 16-bit integers; returns their place, number and unit."""
        unit = float(np.abs(vectors).max(initial=0.0)) / STEPS or 1.0
        return [*self.add(np.rint(vectors / unit), "<i2"), unit]


def page_of(mean, shares, scores, report, options):
    """The text of the page."""
    points = vtk_to_numpy(mean.GetPoints().GetData()).astype(float)
    points = points - 0.5 * (points.min(axis=0) + points.max(axis=0))
    size = float(np.linalg.norm(points, axis=1).max())
    arrays, data = mean.GetPointData(), Data()
    description = {
        "points": data.add_vectors(points / size),
        "triangles": data.add(vtk_to_numpy(mean.GetPolys().GetConnectivityArray()), "<u4"),
        "modes": [{"share": float(shares[k]), "vectors": data.add_vectors(
            vtk_to_numpy(arrays.GetArray(f"ShapeMode{k + 1}")) / size)} for k in range(scores.shape[1])],
        "axes": axes(options.view, options.up),
        "scans": [{"name": name, "scores": [float(score) for score in row]}
                  for name, row in zip(options.names, scores)],
        "groups": options.groups_of,
        "permutations": report.get("Permutations", 0),
        "tests": [[label, data.add(vtk_to_numpy(arrays.GetArray(name)), "<f4")] for label, name in (
            ("p of groups, corrected", "GroupPCorrected"), ("p of groups, each vertex alone", "GroupP"))
            if arrays.GetArray(name)],
    }
    title = os.path.basename(os.path.realpath(options.output)) or "Shapes"
    return filled(template(), title, description, data)


def axes(view, up):
    """Rows of unit vectors that point right, up and to the viewer."""
    front = np.array(view, dtype=float) / np.linalg.norm(view)
    right = np.cross(up, front)
    right /= np.linalg.norm(right)
    return [*right.tolist(), *np.cross(front, right).tolist(), *front.tolist()]
