#!/usr/bin/python3
"""Measure how much of learning can use threads, and compute the time on more threads than this machine has.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_speedup.py [--scans FOLDER]
      [--points 60000,1000000] [--neurons 12962,100000] [--runs 3] [--modeled 8,64]

Points are random positions on the triangles of an object, without noise. Each run is a process of its own, with 1 or 2
threads in turn, and times are the shortest of all runs. On a machine with other programs, the figures mean nothing.

    seconds         wall-clock time of learning (vtkConformalSOM) and of the smooth surface (vtkCurvedSeamlessSurface)
    time ratio      time with 2 threads over time with 1 thread
    serial          percent of the time of 1 thread that cannot use threads: 2 ratio - 1, by Amdahl's law
    computed        by Amdahl's law, not measured: serial + (1 - serial) / threads, times the time of 1 thread

Points of the meshes must have the same bits for both numbers of threads; otherwise the program ends with status 1.
"""
import hashlib
import os
import time

import conformalsom

import known_objects
from helpers.clouds import cloud_of
from separate_process import measured, print_header, print_row

STEPS = "learning", "smooth surface"


def seconds_of(points, neurons):
    """Seconds of each filter, and a digest of all points."""
    network = conformalsom.vtkConformalSOM()
    network.SetInputData(cloud_of(points))
    network.SetNumberOfNeurons(neurons)
    surface = conformalsom.vtkCurvedSeamlessSurface()
    surface.SetInputConnection(network.GetOutputPort())
    seconds, digest = [], hashlib.sha256()
    for stage in (network, surface):
        begin = time.perf_counter()
        stage.Update()
        seconds.append(time.perf_counter() - begin)
        digest.update(known_objects.points_of(stage.GetOutput()).tobytes())
    return seconds, digest.hexdigest()


def shortest(points, neurons, runs):
    """Shortest seconds of each filter by number of threads. Raises SystemExit if points differ."""
    best, digests = {}, set()
    for _ in range(runs):
        for threads in (1, 2):
            os.environ["VTK_SMP_MAX_THREADS"] = str(threads)
            (seconds, digest), _, _ = measured("conformalsom", seconds_of, points, neurons)
            best[threads] = [min(pair) for pair in zip(seconds, best.get(threads, seconds))]
            digests.add(digest)
    if len(digests) > 1:
        raise SystemExit("the meshes of 1 and 2 threads have different points")
    return best


def main():
    parser = known_objects.parser_of_object(__doc__)
    parser.add_argument("--points", type=known_objects.numbers, default=[60000, 1000000], help="default 60000,1000000")
    parser.add_argument("--neurons", type=known_objects.numbers, default=[12962, 100000],
                        help="one for each number of points, default 12962,100000")
    parser.add_argument("--runs", type=int, default=3, help="default %(default)s")
    parser.add_argument("--modeled", type=known_objects.numbers, default=[8, 64], help="numbers of threads, default 8,64")
    options = parser.parse_args()
    print_header("points", "neurons", "step", "seconds, 1 thread", "seconds, 2 threads", "time ratio",
                 "serial % of time",
                 *(f"seconds, {threads} threads, computed" for threads in options.modeled))
    for count, neurons in zip(options.points, options.neurons):
        mesh = known_objects.known_object(options.object, options.scans, count).mesh()
        best = shortest(known_objects.Scan(mesh, count).points, neurons, options.runs)
        for step, one, two in zip(STEPS, best[1], best[2]):
            serial = max(0.0, 2.0 * two / one - 1.0)
            times = one, two, two / one
            print_row(f"{count:,}", f"{neurons:,}", step, *(f"{value:.2f}" for value in times), f"{100 * serial:.0f}",
                      *(f"{one * (serial + (1.0 - serial) / threads):.2f}" for threads in options.modeled))


if __name__ == "__main__":
    main()
