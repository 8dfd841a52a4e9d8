#!/usr/bin/python3
"""Measure the command conformalsom movie: the tables and a picture of Documentation/Tissue.md.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_movie.py [FOLDER]

    cells     A body made by code (helpers/moving_cells.py) that grows by 3 % and turns by 4 degrees between two frames,
              with cells of different brightness: mean and largest angle on the sphere between the places of a cell in
              the first and in a later frame [degrees], with and without the brightness as a feature. The weight of the
              feature was chosen with 60, 150, 400 and 1000 cells of random brightness; cells here have other ones.
    files     Frames of a movie and volumes in FOLDER, with the names that the project blender-tissue-cartography has
              given them: CPU seconds of the command, notes that it prints, and frames that it maps.

--picture FILE draws the first and the last frame of the movie in FOLDER with their maps, PNG or JPEG; needs a display.
"""
import argparse
import glob
import os
import resource
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

import conformalsom as cs
from conformalsom.command import pictures, scan_files
from helpers import moving_cells
from time_series import warm_and_cold

COMMAND = [sys.executable, "-m", "conformalsom", "movie"]
MIDGUT, EMBRYO, ORGANOID = "midgut_*.ply", "Drosophila_CAAX-mCherry-tiny-8bit.tif", "Neural_tube_organoid_DAPI_betaCat-small.tif"
PANEL = 400, 300
STEPS = 4


def measure_cells():
    """Print the table of cells that keep their places."""
    print("| brightness | frame | cells move by | slip, mean | largest |\n| --- | --- | --- | --- | --- |")
    surfaces = []
    for step in range(STEPS):
        volume = moving_cells.frame_of(step)
        start = surfaces[-1] if surfaces else None
        surface = cs.surface_from_volume(volume, spacing=moving_cells.SPACING, start=start)
        surfaces.append(surface.layers(volume, spacing=moving_cells.SPACING, image_size=(1, 1)).surface)
    cells = moving_cells.cells() / np.linalg.norm(moving_cells.cells(), axis=1)[:, None]
    for name, features in (("not used", ()), ("used", [("LayerMean", 1.0)])):
        series = cs.time_series(surfaces, features=features)
        places = [moving_cells.sphere_positions(surface, moving_cells.positions_of_cells(step))
                  for step, surface in enumerate(series.surfaces)]
        for step in range(1, STEPS):
            moved = np.degrees(moving_cells.angles(cells @ moving_cells.rotation(step).T, cells))
            slip = np.degrees(moving_cells.angles(places[step], places[0]))
            print(f"| {name} | {step} | {moved.mean():.2f} | {slip.mean():.2f} | {slip.max():.2f} |", flush=True)


def run(*arguments):
    """Run the command; return CPU seconds and what it printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    completed = subprocess.run([*COMMAND, *arguments], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if completed.returncode:
        raise ValueError(completed.stderr)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, completed


def measure_files(folder, work):
    """Print the table of files; leave the maps and surfaces of the movie in a folder for the picture."""
    midgut = sorted(glob.glob(os.path.join(folder, MIDGUT)))
    embryo, organoid = (os.path.join(folder, name) for name in (EMBRYO, ORGANOID))
    rows = [("midgut, maps", midgut, []), ("midgut, all files", midgut, ["--surfaces", "s", "--table", "t.csv", "--page", "p.html"]),
            ("embryo", [embryo], []), ("organoid", [organoid], ["--channel", "1"])]
    print("| frames | CPU s | notes | mapped |\n| --- | --- | --- | --- |")
    for name, files, options in rows:
        options = [os.path.join(work, word) if "." in word or word == "s" else word for word in options]
        seconds, completed = run(*files, "-o", os.path.join(work, name + ".tif"), "--size", "1000", "--time-step", "60",
                                 *options)
        notes = completed.stderr.count(": note: ")
        print(f"| {name} | {seconds:.1f} | {notes} | {completed.stdout.partition(': ')[2].strip()} |", flush=True)


def colors_of(values, limit):
    colors = numpy_to_vtk(warm_and_cold(np.append(values, [limit, -limit]))[:-2], deep=True)
    colors.SetName("Colors")
    return colors


def draw(work, path):
    """Draw the growth of areas at the second and at the last frame, on surfaces and maps."""
    files = sorted(glob.glob(os.path.join(work, "s", "*.vtp")))
    scenes, aspect = [], PANEL[0] / PANEL[1]
    for frame in (1, len(files) - 1):
        scan = scan_files.scan_reader(files[frame])
        scan.Update()
        normals = vtkPolyDataNormals()
        normals.SetInputData(scan.GetOutput())
        normals.SplittingOff()
        normals.Update()
        surface = normals.GetOutput()
        rates = vtk_to_numpy(surface.GetPointData().GetArray("AreaRate"))
        surface.GetPointData().SetScalars(colors_of(rates, 0.0))
        actor = pictures.actor_of(surface)
        actor.GetMapper().ScalarVisibilityOn()
        camera = pictures.camera_on(surface, (0.2, -1.0, 0.2), (0.0, 0.0, 1.0), aspect)
        scenes.append(pictures.scene(actor, f"growth of areas, frame {frame}", camera))
        reader = cs.vtkTIFFStackReader()
        reader.SetFileName(os.path.join(work, "midgut, maps.tif"))
        reader.SetYAxisToUp()
        reader.UpdateTimeStep(60.0 * frame)
        image = vtkImageData()
        image.CopyStructure(reader.GetOutput())
        image.GetPointData().SetScalars(colors_of(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()), 0.0))
        scenes.append(pictures.image_scene(image, f"its map, frame {frame}", aspect))
    pictures.write_side_by_side(path, scenes, 4 * PANEL[0], PANEL[1])
    print(f"wrote {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", help="with the frames of a movie and the volumes")
    parser.add_argument("--picture", metavar="FILE", help="to draw, PNG or JPEG")
    args = parser.parse_args()
    if args.picture and (not args.folder or not pictures.can_draw()):
        parser.error("--picture needs FOLDER and a display: put xvfb-run before the command")
    measure_cells()
    if args.folder:
        with tempfile.TemporaryDirectory() as work:
            measure_files(args.folder, work)
            if args.picture:
                draw(work, args.picture)


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError) as error:
        sys.exit(f"measure_movie: {error}")
