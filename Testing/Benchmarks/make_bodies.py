#!/usr/bin/python3
"""Make closed meshes of animals, hands and heads with corresponding landmarks, for compare_registrations.py.

    make_bodies.py FOLDER [--kinds animals hands heads] [--number 10] [--seed 1] [--extra 0.3]

A body is a smooth union of round cones (balls whose radius changes along a segment) along a skeleton. Lengths,
widths, bends and the orientation are random; with a probability of --extra, a body has further limbs, which have no
landmarks. FOLDER gets NAME.off and NAME.landmarks for each body. Landmarks are where rays from the skeleton leave the
body: tips of limbs, and points at the sides. Bodies whose parts meet by accident, so that they have handles, are made
again.
"""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
from helpers import bodies, paper_models  # pylint: disable=wrong-import-position
from conformalsom import vtkConformalOFFWriter, vtkGenusZeroCheck  # pylint: disable=wrong-import-position

def write(body, mesh, name, folder, random):
    ids = body.landmarks(mesh)
    rotation = np.linalg.qr(random.normal(size=(3, 3)))[0]
    rotation *= np.linalg.det(rotation)
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float) @ rotation.T
    mesh.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    writer = vtkConformalOFFWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(os.path.join(folder, name + ".off"))
    if not writer.Write():
        raise OSError(f"{folder}/{name}.off: cannot be written")
    with open(os.path.join(folder, name + ".landmarks"), "w", encoding="ascii") as file:
        file.writelines(f"{i}\n" for i in ids)


def main():
    makers = {"animals": bodies.animal, "hands": bodies.hand, "heads": bodies.head}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="folder to write, made if necessary; each kind has a folder in it")
    parser.add_argument("--kinds", nargs="+", choices=sorted(makers), default=sorted(makers))
    parser.add_argument("--number", type=int, default=10, help="bodies of each kind, default 10")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--extra", type=float, default=0.3, help="probability of further limbs, default 0.3")
    parser.add_argument("--size", type=int, default=110, help="cells of the grid along the longest side, default 110")
    args = parser.parse_args()
    for kind in args.kinds:
        folder = os.path.join(args.folder, kind)
        os.makedirs(folder, exist_ok=True)
        random = np.random.default_rng([args.seed, sorted(makers).index(kind)])
        made = 0
        for _ in range(20 * args.number):
            if made == args.number:
                break
            body = makers[kind](random, args.extra)
            mesh = body.mesh(args.size)
            check = vtkGenusZeroCheck()
            check.SetInputData(mesh)
            checked = paper_models.run(check)
            if checked.GetFieldData().GetArray("IsGenusZero").GetValue(0) == 1:
                write(body, checked, f"{kind[:-1]}{made:02}", folder, random)
                made += 1
        print(f"{kind}: {made} meshes of about {checked.GetNumberOfPoints()} points, {len(body.rays)} landmarks")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, paper_models.StepFailed) as error:
        sys.exit(f"make_bodies: {error}")
