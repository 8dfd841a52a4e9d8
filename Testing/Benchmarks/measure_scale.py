#!/usr/bin/python3
"""Measure error over processor time for many points: ConformalSOM beside Poisson reconstruction. Prints a table.

    pip install open3d pymeshlab
    PYTHONPATH=build/dev/python:Examples/Python python3 Testing/Benchmarks/measure_scale.py --scans FOLDER \\
      [--points 100000,1000000] [--methods ConformalSOM,pymeshlab] [--picture scale.png]

Points are random positions on the triangles of an object, without noise. Errors are measured to the triangles, which
no method gets. Open3D's Poisson reconstruction gets the exact normals ("true"), or estimates normals ("own").
pymeshlab's screened Poisson reconstruction gets the exact normals, and runs on one thread, since threads that wait
would count as time of the processor. ConformalSOM gets no normals. Each method runs in a process of its own. Rows of a
package that is not installed are left out.

    CPU s       seconds of the processor, on all threads, without imports
    MB          growth of the process's memory
    p2s, s2p    mean square distance from the object's vertices to the surface, and from the surface to the object;
                the object's largest radius is 1
    web         fraction of the surface's area farther than 0.02 from the object
--picture draws p2s over CPU seconds, one line for each method and number of points.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401 pylint: disable=unused-import

from conformalsom import vtkSurfaceMismatch

import known_objects
import reconstruction_methods as methods
from compare_smoothing import surface_of
from separate_process import measured, missing, print_header, print_row, rounded

COLORS = {"ConformalSOM": (30, 90, 200), "Open3D, true": (200, 90, 20), "Open3D, own": (120, 120, 120),
          "pymeshlab, true": (30, 140, 60)}


def runs(neurons, depths):
    """Name, library, function, argument, and whether the object's normals are given, of each run."""
    for number in neurons:
        yield "ConformalSOM", "conformalsom", methods.learned_with_neurons, number, False
    for given in (True, False):
        for depth in depths:
            yield f"Open3D, {'true' if given else 'own'}", "open3d", methods.open3d_poisson, depth, given
    for depth in depths:
        yield "pymeshlab, true", "pymeshlab", methods.pymeshlab_poisson, depth, True


def errors(surface, mesh):
    measure = vtkSurfaceMismatch()
    measure.SetInputData(0, surface_of(*surface))
    measure.SetReferenceData(mesh)
    measure.Update()
    return [known_objects.field_value(measure.GetOutput(), name) for name in (
        "MeanSquarePointToSurface", "MeanSquareSurfaceToPoint", "WebFraction")]


def measure(options):
    """Rows of the table, as (name, points, CPU seconds, p2s)."""
    print_header("points", "method", "neurons or depth", "triangles", "CPU s", "MB", "p2s", "s2p", "web %")
    rows = []
    for count in options.points:
        mesh = known_objects.known_object(options.object, options.scans, count).mesh()
        places = known_objects.points_of(mesh)
        mesh.SetPoints(known_objects.vtk_points(places / known_objects.largest_radius(places)))
        thing = known_objects.Scan(mesh, count)
        normals = thing.facets[thing.ids]
        for name, library, function, argument, given in runs(options.neurons, options.depths):
            if library not in options.methods or missing([library]) or (not given and library == "open3d" and count > options.most):
                continue
            try:
                surface, seconds, memory = measured(library, function, thing.points, normals if given else None, argument)
            except RuntimeError as error:
                print_row(f"{count:,}", name, f"{argument:,}", error)
                continue
            p2s, s2p, web = errors(surface, mesh)
            rows.append((name, count, seconds, p2s))
            print_row(f"{count:,}", name, f"{argument:,}", f"{len(surface[1]):,}", f"{seconds:.1f}", f"{memory:,.0f}",
                      rounded(p2s), rounded(s2p), f"{100 * web:.2f}")
    return rows


def column(name, values):
    array = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
    array.SetName(name)
    return array


def draw(rows, path):
    """Draw p2s over CPU seconds, both on logarithmic axes."""
    view = vtkContextView()
    view.GetRenderWindow().SetOffScreenRendering(1)
    view.GetRenderWindow().SetSize(1000, 700)
    view.GetRenderer().SetBackground(1.0, 1.0, 1.0)
    chart = vtkChartXY()
    view.GetScene().AddItem(chart)
    chart.SetShowLegend(True)
    for side, title in ((vtkAxis.BOTTOM, "processor seconds"), (vtkAxis.LEFT, "p2s")):
        chart.GetAxis(side).SetTitle(title)
        chart.GetAxis(side).SetLogScale(True)
    for number, (name, count) in enumerate(dict.fromkeys((name, count) for name, count, *_ in rows)):
        chosen = [(seconds, p2s) for of, size, seconds, p2s in rows if (of, size) == (name, count)]
        table = vtkTable()
        table.AddColumn(column("seconds", [seconds for seconds, _ in chosen]))
        table.AddColumn(column(f"{name}, {count:,} points", [p2s for _, p2s in chosen]))
        line = chart.AddPlot(vtkChart.LINE)
        line.SetInputData(table, 0, 1)
        line.SetColor(*COLORS[name], 255)
        line.SetWidth(2.0 + number % 2)
        line.SetMarkerStyle(1 + number % 5)
    view.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(view.GetRenderWindow())
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def main():
    parser = known_objects.parser_of_object(__doc__)
    parser.add_argument("--points", type=known_objects.numbers, default=[100000, 1000000], help="default 100000,1000000")
    parser.add_argument("--neurons", type=known_objects.numbers, default=[12962, 40000, 100000], help="default 12962,40000,100000")
    parser.add_argument("--depths", type=known_objects.numbers, default=[8, 9, 10], help="of Poisson's octree, default 8,9,10")
    parser.add_argument("--most", type=int, default=100000,
                        help="Open3D estimates normals of at most so many points, default %(default)s")
    parser.add_argument("--methods", type=lambda text: text.lower().split(","),
                        default=["conformalsom", "open3d", "pymeshlab"], help="packages, default all")
    parser.add_argument("--picture", metavar="FILE")
    options = parser.parse_args()
    rows = measure(options)
    if options.picture:
        draw(rows, options.picture)


if __name__ == "__main__":
    main()
