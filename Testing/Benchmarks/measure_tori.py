#!/usr/bin/python3
"""Measure surfaces with handles, and conformal maps of surfaces of genus 1 to flat tori.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_tori.py [--only PART]

Part "moduli": surfaces of genus 1 whose modulus tau is known. Prints a row for each:

    points   of the surface
    error    absolute difference between tau and the known value
    K, K 95  quasi-conformal error, mean and value that 95 % of the triangles do not exceed; 1 if conformal
    flipped  triangles
    CPU      seconds of the processor for the map

Part "bodies": clouds of random points on bodies that are made by code, hulls with Genus AS_FOUND, and learned surfaces
with Genus AS_FOUND. The largest radius of a body is 1. Prints a row for each cloud:

    hull     number of handles of the hull by Method AUTOMATIC
    learned  number of handles of the learned surface
    p2s      mean square distance from other random points on the body to the learned surface
    web      percent of the learned surface's area that is farther than 0.02 from the body
    tau, K   modulus and mean quasi-conformal error of the learned surface's map to a flat torus, if it has one handle
"""
import argparse
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkCellArray

import conformalsom
from helpers import handle_bodies
from measure_borders import cloud_of, distances, points_of, sampled, scaled_to_one, triangles_of


def figure(output, name, component=0):
    """Return a number of the field data."""
    return output.GetFieldData().GetArray(name).GetComponent(0, component)


def grid_surface(along, around, position):
    """Return a surface of genus 1 from two periodic parameters in [0, 1)."""
    i, j = (index.ravel() for index in np.meshgrid(np.arange(along), np.arange(around), indexing="ij"))

    def number(s, t):
        return s % along * around + t % around

    points = np.column_stack(position(i / along, j / around))
    triangles = np.vstack([np.column_stack([number(i, j), number(i + 1, j), number(i + 1, j + 1)]),
                           np.column_stack([number(i, j), number(i + 1, j + 1), number(i, j + 1)])])
    return points, triangles


def revolution(radius):
    """Return the positions on a torus of revolution, whose major radius is 1."""
    def position(s, t):
        r = 1.0 + radius * np.cos(2 * np.pi * t)
        return r * np.cos(2 * np.pi * s), r * np.sin(2 * np.pi * s), radius * np.sin(2 * np.pi * t)
    return position


def inverted(s, t):
    """Return the positions on a torus of revolution after an inversion in a sphere."""
    p = np.array(revolution(0.5)(s, t)) - np.array([[0.3], [0.2], [0.9]])
    return tuple(p / (p * p).sum(axis=0))


def hopf(s, t):
    """Return the positions on a Hopf torus, projected to space (Pinkall, 1985)."""
    longitude, fiber = 2 * np.pi * s, 2 * np.pi * t
    half = 0.5 * (1.2 + 0.4 * np.sin(3 * longitude))
    rest = 1.0 - np.sin(half) * np.sin(fiber)
    return (np.cos(half) * np.cos(fiber + longitude) / rest, np.cos(half) * np.sin(fiber + longitude) / rest,
            np.sin(half) * np.cos(fiber) / rest)


def modulus_of_hopf():
    """Return the modulus of the Hopf torus: periods 2 pi and (A + i L) / 2 for the area A and length L of its curve."""
    longitude = (np.arange(4096) + 0.5) / 4096 * 2 * np.pi
    angle = 1.2 + 0.4 * np.sin(3 * longitude)
    length = np.hypot(1.2 * np.cos(3 * longitude), np.sin(angle)).mean() * 2 * np.pi
    tau = ((1 - np.cos(angle)).mean() * 2 * np.pi + 1j * length) / (4 * np.pi)
    while abs(tau) < 1 or abs(tau.real) > 0.5:
        tau -= round(tau.real)
        tau = -1 / tau if abs(tau) < 1 else tau
    return tau


def modulus_of_revolution(radius):
    """Return the modulus of a torus of revolution."""
    ratio = np.sqrt(1 - radius * radius) / radius
    return 1j * max(ratio, 1 / ratio)


def mapped(surface):
    """Return the mapped surface, and the seconds of the processor."""
    conformal = conformalsom.vtkGlobalConformalMap()
    conformal.SetInputData(surface)
    begin = time.process_time()
    conformal.Update()
    return conformal.GetOutput(), time.process_time() - begin


def print_moduli():
    """Print the rows of the surfaces with known moduli."""
    print("| surface | points | tau | error | K | K 95 | flipped | CPU |\n|" + " --- |" * 8)
    # The ratio of the two numbers of points makes edges of about equal length in the map.
    rows = [(f"torus of revolution, r / R = {radius}", revolution(radius), modulus_of_revolution(radius), size,
             np.sqrt(1 - radius * radius) / radius)
            for radius, size in ((0.2, 10000), (0.2, 40000), (0.5, 10000), (0.7, 10000), (0.9, 10000), (0.9, 40000),
                                 (0.5, 25000), (0.5, 50000), (0.5, 100000), (0.5, 200000), (0.5, 400000))]
    rows += [("inverted torus", inverted, modulus_of_revolution(0.5), 20000, 2.0),
             ("Hopf torus", hopf, modulus_of_hopf(), 20000, 2.0)]
    for name, position, known, size, ratio in rows:
        along = int(round(np.sqrt(size * ratio)))
        points, triangles = grid_surface(along, int(round(size / along)), position)
        output, seconds = mapped(surface_of(points, triangles))
        tau = complex(figure(output, "TorusModulus"), figure(output, "TorusModulus", 1))
        tau = complex(round(tau.real, 9) + 0.0, tau.imag)
        error = min(abs(tau - known), abs(-tau.conjugate() - known))
        print(f"| {name} | {len(points):,} | {tau.real:+.4f} {tau.imag:+.4f} i | {error:.1e} | "
              f"{figure(output, 'MeanQuasiConformalError'):.4f} | {figure(output, 'QuasiConformalError95'):.4f} | "
              f"{figure(output, 'NumberOfFlippedTriangles'):.0f} | {seconds:.2f} |", flush=True)


def surface_of(points, triangles):
    """Return a surface of VTK."""
    surface, cells = cloud_of(points), vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, np.int64).ravel(), deep=1))
    surface.SetPolys(cells)
    return surface


def print_bodies():
    """Print the rows of the bodies."""
    print("| body | handles | points | noise | hull | learned | p2s | web | tau | K |\n|" + " --- |" * 10)
    for name, (body, genus) in handle_bodies.BODIES.items():
        whole = scaled_to_one(handle_bodies.surface_of(body))
        x = points_of(whole)
        triangles = triangles_of(whole)[:, ::-1]  # the table was made of the samples that this order gives
        test = sampled(x, triangles, 20000, 8)
        for count, noise in ((40000, 0.0), (40000, 0.01)):
            cloud = cloud_of(sampled(x, triangles, count, 3)
                             + noise * np.random.default_rng(2).standard_normal((count, 3)))
            hull = conformalsom.vtkGenusZeroHull()
            som = conformalsom.vtkConformalSOM()
            hull.SetMethodToAutomatic()
            for algorithm in (hull, som):
                algorithm.SetInputData(cloud)
                algorithm.SetGenusToAsFound()
                algorithm.Update()
            learned = som.GetOutput()
            web = (distances(sampled(points_of(learned), triangles_of(learned), 20000, 9), whole) > 0.02).mean()
            p2s = (distances(test, learned) ** 2).mean()
            handles = 1 - handle_bodies.euler_number(learned)[0] / 2
            torus = " | "
            if handles == 1:
                output = mapped(learned)[0]
                torus = (f"{figure(output, 'TorusModulus'):+.3f} {figure(output, 'TorusModulus', 1):+.3f} i | "
                         f"{figure(output, 'MeanQuasiConformalError'):.3f}")
            print(f"| {name} | {genus} | {count:,} | {noise} | {figure(hull.GetOutput(), 'NumberOfHandles'):.0f} | "
                  f"{handles:.0f} | {p2s:.1e} | {100 * web:.2f} | {torus} |", flush=True)


def main():
    """Print the parts."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", choices=("moduli", "bodies"), help="part to measure; default: both")
    only = parser.parse_args().only
    if only != "bodies":
        print_moduli()
    if only != "moduli":
        print_bodies()


if __name__ == "__main__":
    main()
