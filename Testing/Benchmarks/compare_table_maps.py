#!/usr/bin/env python3
"""Compare self-organizing maps of tables: vtkSphericalSOM, Somoclu and MiniSom.

    compare_table_maps.py [--repetitions N] [TABLE ...]

The tables are those of scikit-learn: iris, wine, breast_cancer and digits (default: all). Values are standardized. All
maps have about the same number of neurons: 92 on the sphere beside 9 by 10 on a grid, or 252 beside 14 by 18. Grids are
hexagonal, so that inner neurons of all maps have 6 neighbors. Somoclu (https://somoclu.readthedocs.io) runs with its
defaults from the principal plane, on a plane and on a torus. MiniSom (https://github.com/JustGlowing/minisom) runs for 20
epochs from the principal plane, with sigma from half of the grid. Programs that are not installed are left out, and
scikit-learn is necessary.

Errors are computed here from the weight vectors, in the same way for all maps: the quantization error is the mean
distance of a row from its closest neuron, the topographic error is the fraction of the rows whose two closest neurons
are no neighbors, and the held-out error is the quantization error of every fifth row in maps of the others. Seconds are
CPU seconds of all threads. All numbers are means over the repetitions (default 5), with seeds 1, 2, ...

The options of vtkSphericalSOM were chosen by iris and wine only.
"""

import argparse
import contextlib
import importlib
import importlib.util
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkTable

from conformalsom import vtkSphericalSOM

NAMES = ("iris", "wine", "breast_cancer", "digits")
SMALL_TABLE = 300  # rows, up to which maps have 92 neurons


def load(name):
    """The rows of a table, standardized, without constant columns."""
    datasets = importlib.import_module("sklearn.datasets")
    rows = getattr(datasets, "load_" + name)().data
    rows = rows[:, rows.std(axis=0) > 0.0]
    return (rows - rows.mean(axis=0)) / rows.std(axis=0)


def hexagonal_neighbors(positions):
    """Whether neurons are neighbors, from their positions on a hexagonal grid with edges of length 1."""
    distances = np.linalg.norm(positions[:, None] - positions[None], axis=2)
    return distances < 1.2


def grid_positions(rows, columns):
    """Positions of the neurons of a hexagonal grid, row by row; odd rows are shifted by half an edge."""
    i, j = np.divmod(np.arange(rows * columns), columns)
    return np.column_stack([j + 0.5 * (i % 2), i * np.sqrt(0.75)])


def torus_neighbors(rows, columns):
    """Neighbors on a grid whose opposite borders are joined; the number of rows must be even."""
    around = np.zeros((rows * columns,) * 2, dtype=bool)
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            shift = np.array([j * columns, i * rows * np.sqrt(0.75)])
            positions = grid_positions(rows, columns)
            around |= np.linalg.norm(positions[:, None] - positions[None] - shift, axis=2) < 1.2
    return around


# Each method returns weight vectors, a matrix of neighbors, and the CPU seconds of learning.


def spherical(rows, seed, size):
    """vtkSphericalSOM."""
    table = vtkTable()
    for k, column in enumerate(rows.T):
        array = numpy_to_vtk(np.ascontiguousarray(column), deep=True)
        array.SetName(f"c{k}")
        table.AddColumn(array)
    som = vtkSphericalSOM()
    som.SetInputData(table)
    som.SetNumberOfNeurons(size[0])
    som.SetRandomSeed(seed)
    som.StandardizeOff()
    start = time.process_time()
    som.Update()
    seconds = time.process_time() - start
    sphere = som.GetOutput()
    weights = np.column_stack([vtk_to_numpy(sphere.GetPointData().GetArray(f"c{k}")) for k in range(rows.shape[1])])
    triangles = vtk_to_numpy(sphere.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    neighbors = np.zeros((len(weights),) * 2, dtype=bool)
    for k in range(3):
        neighbors[triangles[:, k], triangles[:, (k + 1) % 3]] = True
    return weights, neighbors | neighbors.T, seconds


def somoclu_map(rows, seed, size, maptype):
    """Somoclu, whose defaults are 10 epochs with a radius from half of the grid to 1."""
    import somoclu
    np.random.seed(seed)
    som = somoclu.Somoclu(size[2], size[1], maptype=maptype, gridtype="hexagonal", initialization="pca", verbose=0)
    start = time.process_time()
    som.train(rows.astype(np.float32))
    seconds = time.process_time() - start
    weights = som.codebook.reshape(-1, rows.shape[1]).astype(float)
    neighbors = (hexagonal_neighbors(grid_positions(size[1], size[2])) if maptype == "planar"
                 else torus_neighbors(size[1], size[2]))
    return weights, neighbors, seconds


def minisom_map(rows, seed, size):
    """MiniSom: 20 epochs, with sigma from half of the grid, and further defaults."""
    from minisom import MiniSom
    som = MiniSom(size[1], size[2], rows.shape[1], sigma=0.5 * size[1], topology="hexagonal",
                  sigma_decay_function="linear_decay_to_one", random_seed=seed)
    start = time.process_time()
    som.pca_weights_init(rows)
    som.train(rows, 20, random_order=True, use_epochs=True)
    seconds = time.process_time() - start
    x, y = som.get_euclidean_coordinates()
    positions = np.column_stack([x.ravel(), y.ravel() * np.sqrt(0.75)])
    return som.get_weights().reshape(-1, rows.shape[1]), hexagonal_neighbors(positions), seconds


METHODS = {
    "vtkSphericalSOM": (None, spherical),
    "Somoclu, plane": ("somoclu", lambda *arguments: somoclu_map(*arguments, "planar")),
    "Somoclu, torus": ("somoclu", lambda *arguments: somoclu_map(*arguments, "toroid")),
    "MiniSom": ("minisom", minisom_map),
}


def errors_of(rows, weights, neighbors):
    """Quantization error and topographic error."""
    distances = np.sqrt(((rows**2).sum(axis=1)[:, None] - 2.0 * rows @ weights.T + (weights**2).sum(axis=1)).clip(0.0))
    first, second = np.argsort(distances, axis=1, kind="stable")[:, :2].T
    return distances.min(axis=1).mean(), 1.0 - neighbors[first, second].mean()


@contextlib.contextmanager
def silence():
    """Without what libraries print."""
    with open(os.devnull, "w") as nothing, contextlib.redirect_stdout(nothing):
        yield


def measure(method, rows, repetitions):
    """Mean quantization error, topographic error, held-out error and CPU seconds, and the number of neurons."""
    size = (92, 10, 9) if len(rows) <= SMALL_TABLE else (252, 14, 18)
    held_out = np.arange(len(rows)) % 5 == 4
    figures = []
    for seed in range(1, repetitions + 1):
        with silence():
            weights, neighbors, seconds = method(rows, seed, size)
            others, _, _ = method(rows[~held_out], seed, size)
        figures.append([*errors_of(rows, weights, neighbors), errors_of(rows[held_out], others, neighbors)[0], seconds])
    return [*np.mean(figures, axis=0), len(weights)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help="names of tables (default: all)")
    parser.add_argument("--repetitions", type=int, default=5, help="number of seeds (default 5)")
    options = parser.parse_args()
    if importlib.util.find_spec("sklearn") is None:
        sys.exit("scikit-learn, which has the tables, is not installed")
    print("| table | rows | columns | program | neurons | quantization error | topographic error | held-out error | CPU s |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for name in options.tables or NAMES:
        rows = load(name)
        for title, (module, method) in METHODS.items():
            if module and importlib.util.find_spec(module) is None:
                print(f"{title}: {module} is not installed", file=sys.stderr)
                continue
            quantization, topographic, held_out, seconds, neurons = measure(method, rows, options.repetitions)
            print(f"| {name} | {rows.shape[0]} | {rows.shape[1]} | {title} | {neurons:.0f} | {quantization:.3f} "
                  f"| {topographic:.3f} | {held_out:.3f} | {seconds:.3f} |", flush=True)


if __name__ == "__main__":
    main()
