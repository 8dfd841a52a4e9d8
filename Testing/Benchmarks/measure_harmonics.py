"""How close harmonics of few degrees come to surfaces, on which maps, and what they take.

    measure_harmonics.py bunny.ply spot.ply > harmonics.txt

Each file is a closed surface of genus zero, mapped by vtkGlobalConformalMap with several area balances.
Distances are root mean squares over the surface, its largest radius being 1; seconds are those of the
harmonics alone, on one thread.
"""
import os
import sys
import time

from vtkmodules.vtkCommonCore import vtkSMPTools

from conformalsom import vtkConformalPLYReader, vtkGlobalConformalMap, vtkSurfaceHarmonics

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))

from helpers import mapped_models  # pylint: disable=wrong-import-position

BALANCES = (0.0, 0.25, 0.5, 1.0)
DEGREES = (12, 20, 32, 64, 128)


def measure(mapped, degree):
    """Distance and seconds."""
    harmonics = vtkSurfaceHarmonics()
    harmonics.SetInputData(mapped)
    harmonics.SetDegree(degree)
    start = time.process_time()
    harmonics.Update()
    seconds = time.process_time() - start
    distance = harmonics.GetOutput().GetFieldData().GetArray("RootMeanSquareDistance").GetValue(0)
    return distance / mapped_models.largest_radius(mapped), seconds


def main(names):
    vtkSMPTools.SetBackend("Sequential")
    print("file points AreaBalance " + " ".join(f"L={degree} seconds" for degree in DEGREES))
    for name in names:
        for balance in BALANCES:
            reader = vtkConformalPLYReader()
            reader.SetFileName(name)
            sphere_map = vtkGlobalConformalMap()
            sphere_map.SetInputConnection(reader.GetOutputPort())
            sphere_map.SetAreaBalance(balance)
            sphere_map.Update()
            mapped = sphere_map.GetOutput()
            figures = [measure(mapped, degree) for degree in DEGREES]
            print(name, mapped.GetNumberOfPoints(), balance,
                  *(f"{distance:.3g} {seconds:.2f}" for distance, seconds in figures), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
