"""Surfaces as web pages: in a notebook, and in the web browser."""
import os
import sys
import tempfile
import typing
import webbrowser

from vtkmodules.vtkFiltersCore import vtkDecimatePro, vtkTriangleFilter

import conformalsom
from conformalsom.exports import writer_of
from conformalsom.running import run

if typing.TYPE_CHECKING:
    from conformalsom.surface import Surface

MAXIMUM_POINTS = 30_000  # in a frame; the page of a painted surface then has less than 3 MB
MAXIMUM_PIXELS = 1024  # along a side of the picture in a frame
STYLE = "width: 100%; height: 480px; border: 0"


def show(surface: "Surface") -> None:
    """Show a surface in the notebook that runs this code, or else in the web browser."""
    if in_notebook():
        from IPython.display import display  # pylint: disable=import-outside-toplevel
        display(surface)
        return
    path = os.path.join(tempfile.mkdtemp(prefix="conformalsom-"), "surface.html")
    surface.save(path)
    if not webbrowser.open("file://" + path):
        print(f"Open {path} in a web browser", file=sys.stderr)


def in_notebook() -> bool:
    """Return whether this code runs in a notebook, which shows HTML."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return hasattr(shell, "kernel")


def frame(surface: "Surface") -> str:
    """Return HTML that shows a surface: its page in a frame, without network, under 3 MB."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "surface.html")
        writer = writer_of(reduced(surface), path)
        writer.SetMaximumTextureSize(MAXIMUM_PIXELS)
        writer.SetFileName(path)
        run(writer)
        with open(path, encoding="utf-8") as file:
            page = file.read()
    page = page.replace("&", "&amp;").replace('"', "&quot;")
    return f'<iframe srcdoc="{page}" sandbox="allow-scripts" style="{STYLE}"></iframe>'


def reduced(surface: "Surface") -> "Surface":
    """Return a surface with fewer triangles, if it has more than a frame shows."""
    if len(surface) <= MAXIMUM_POINTS:
        return surface
    triangles, fewer = vtkTriangleFilter(), vtkDecimatePro()
    triangles.SetInputData(surface.polydata)
    fewer.SetInputConnection(triangles.GetOutputPort())
    fewer.SetTargetReduction(1 - MAXIMUM_POINTS / len(surface))
    fewer.PreserveTopologyOn()
    fewer.SplittingOff()
    run(fewer)
    return conformalsom.Surface(fewer.GetOutput()).painted_as(surface)
