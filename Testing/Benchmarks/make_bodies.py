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
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
from helpers import paper_models  # pylint: disable=wrong-import-position
from conformalsom import vtkConformalOFFWriter, vtkGenusZeroCheck  # pylint: disable=wrong-import-position

X, Y, Z = np.eye(3)


def turned(direction, axis, angle):
    """Rotate a direction about an axis (Rodrigues)."""
    axis = axis / np.linalg.norm(axis)
    return (direction * np.cos(angle) + np.cross(axis, direction) * np.sin(angle)
            + axis * (axis @ direction) * (1 - np.cos(angle)))


class Body:
    """Round cones, and rays to landmarks."""

    def __init__(self, blend):
        self.cones, self.rays, self.blend = [], [], blend

    def cone(self, begin, end, first, last):
        self.cones.append((np.array(begin, float), np.array(end, float), first, last))
        return np.array(end, float)

    def landmark(self, origin, direction):
        self.rays.append((np.array(origin, float), np.array(direction, float) / np.linalg.norm(direction)))

    def height(self, points):
        """Signed distance (about), negative inside: soft minimum over all cones."""
        total = np.zeros(len(points))
        for begin, end, first, last in self.cones:
            along = end - begin
            t = np.clip((points - begin) @ along / max(along @ along, 1e-12), 0, 1)
            distance = np.linalg.norm(points - begin - t[:, None] * along, axis=1) - (first + t * (last - first))
            total += np.exp(np.clip(-distance / self.blend, -60, 60))
        return -self.blend * np.log(total)

    def mesh(self, size):
        ends = np.array([p for cone in self.cones for p in cone[:2]])
        widest = max(max(cone[2:]) for cone in self.cones) + 3 * self.blend
        lower, upper = ends.min(axis=0) - widest, ends.max(axis=0) + widest
        spacing = (upper - lower).max() / size
        counts = np.ceil((upper - lower) / spacing).astype(int) + 1
        z, y, x = np.meshgrid(*(lower[k] + spacing * np.arange(counts[k]) for k in (2, 1, 0)), indexing="ij")
        image, contour = vtkImageData(), vtkFlyingEdges3D()
        image.SetDimensions(*counts)
        image.SetSpacing(spacing, spacing, spacing)
        image.SetOrigin(*lower)
        values = self.height(np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1))
        image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
        contour.SetInputData(image)
        contour.SetValue(0, 0.0)
        contour.ComputeNormalsOff()
        contour.ComputeScalarsOff()
        return paper_models.run(contour)

    def landmarks(self, mesh):
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        steps = np.linspace(0.0, 2.0, 2001)
        ids = []
        for origin, direction in self.rays:
            ray = origin + steps[:, None] * direction
            leaves = ray[np.argmax(self.height(ray) > 0)]
            ids.append(int(np.linalg.norm(points - leaves, axis=1).argmin()))
        return ids


def limb(body, begin, direction, axis, lengths, widths, bends):
    """A chain of cones, bent about an axis; a landmark at its tip. Returns the joints."""
    joints = [np.array(begin, float)]
    for length, bend, first, last in zip(lengths, bends, widths[:-1], widths[1:]):
        direction = turned(direction, axis, bend)
        joints.append(body.cone(joints[-1], joints[-1] + length * direction, first, last))
    body.landmark(joints[-1], direction)
    return joints


def animal(random, extra):
    """Four legs, neck, head with ears, tail. x is ahead, y is left, z is up."""
    body = Body(0.012)
    u = random.uniform
    length, width = u(0.5, 0.75), u(0.09, 0.14)
    sag, side = u(-0.12, 0.12), u(-0.25, 0.25)
    spine = [np.array([length * (t - 0.5), 4 * side * length * t * (t - 1) * 0.3, sag * t * (1 - t)])
             for t in (0, 0.33, 0.67, 1)]
    widths = [width * u(0.85, 1.15) for _ in range(4)]
    for k in range(3):
        body.cone(spine[k], spine[k + 1], widths[k], widths[k + 1])
    for k in (1, 2):
        middle = spine[k]
        body.landmark(middle, Z)
        body.landmark(middle, -Z)
    ahead = (spine[3] - spine[2]) / np.linalg.norm(spine[3] - spine[2])
    back = (spine[0] - spine[1]) / np.linalg.norm(spine[0] - spine[1])
    # Neck and tail are of similar length in some animals.
    rise = u(0.2, 1.3)
    neck = [u(0.06, 0.2), u(0.06, 0.2)]
    direction = turned(ahead, Y, -rise)
    throat = body.cone(spine[3], spine[3] + neck[0] * direction, widths[3] * 0.8, u(0.05, 0.08))
    direction = turned(turned(direction, Y, u(-0.2, 0.4)), Z, u(-0.5, 0.5))
    crown = body.cone(throat, throat + neck[1] * direction, u(0.05, 0.07), u(0.055, 0.08))
    forward = turned(turned(ahead, Y, u(-0.1, 0.7)), Z, u(-0.5, 0.5))
    body.cone(crown, crown + u(0.08, 0.2) * forward, u(0.055, 0.08), u(0.025, 0.05))
    body.landmark(body.cones[-1][1], forward)
    left = np.cross(Z, forward) / np.linalg.norm(np.cross(Z, forward))
    up = np.cross(forward, left)
    for sign in (1, -1):
        limb(body, crown + sign * 0.03 * left, up + sign * u(0.3, 0.9) * left - 0.3 * forward, left,
             [u(0.06, 0.12)], [0.025, 0.012], [0.0])
    joints = limb(body, spine[0], turned(back, Y, u(-0.5, 0.6)), Y, [u(0.04, 0.18) for _ in range(3)],
                  [0.045, 0.03, 0.025, u(0.014, 0.022)], [u(-0.4, 0.4) for _ in range(3)])
    body.landmark(joints[0], turned(back, Y, -0.9))
    for at, sign in ((3, 1), (3, -1), (0, 1), (0, -1)):
        hip = spine[at] + sign * widths[at] * 0.45 * Y
        down = turned(-Z, Y, u(-0.5, 0.5)) + sign * 0.12 * Y
        bend = u(0.1, 0.6) * (1 if at == 3 else -1)
        joints = limb(body, hip, down, Y, [u(0.12, 0.22), u(0.12, 0.24), 0.05], [0.065, 0.04, 0.028, 0.03],
                      [0.0, bend, -bend])
        body.landmark(joints[1], sign * Y + 0.2 * X)
    if random.random() < extra:
        for sign in (1, -1):  # horns
            limb(body, crown + sign * 0.03 * left, up + 0.4 * sign * left, left, [u(0.08, 0.14), u(0.05, 0.12)],
                 [0.025, 0.018, 0.012], [0.3, u(0.2, 0.8)])
            body.rays.pop()
    return body


def hand(random, extra):
    """Wrist, palm, five fingers. x is to the fingers, y to the thumb, z out of the back of the hand."""
    body = Body(0.012)
    u = random.uniform
    scale = u(0.85, 1.15)
    for y in (-0.12, -0.04, 0.04, 0.12):
        body.cone((-0.14, 0.6 * y, 0), (0.14, y, 0), 0.075, 0.06)
    wrist = limb(body, (-0.14, 0, 0), turned(-X, Y, u(-0.4, 0.4)), Y, [u(0.12, 0.3)], [0.085, u(0.065, 0.08)], [0.0])
    body.landmark((0, 0, 0), Z)
    body.landmark((0, 0, 0), -Z)
    body.landmark((0, -0.1, 0), -Y)
    body.landmark(wrist[0], Z)
    curl = u(0.0, 0.6)
    for k, y in enumerate((-0.135, -0.045, 0.045, 0.135)):
        lengths = np.array([0.12, 0.08, 0.06]) * scale * (0.78, 0.97, 1.05, 0.95)[k] * u(0.9, 1.1)
        outward = turned(X, Z, 2.0 * y * u(0.8, 1.6))
        joints = limb(body, (0.15, y, 0), outward, Y, lengths, [0.045, 0.038, 0.034, 0.03],
                      [curl + u(-0.15, 0.3) for _ in range(3)])
        body.landmark(joints[1], turned(outward, Y, -1.3))
    joints = limb(body, (-0.04, 0.11, 0), X * 0.6 + Y * u(0.5, 0.9), Z, np.array([0.1, 0.09, 0.06]) * scale,
                  [0.055, 0.045, 0.038, 0.034], [u(-0.2, 0.2) for _ in range(3)])
    body.landmark(joints[1], Y + 0.2 * Z)
    if random.random() < extra:  # a sixth finger
        limb(body, (-0.02, -0.1, 0), X - 0.9 * Y, Y, [0.07, 0.05], [0.04, 0.034, 0.03], [0.1, 0.2])
        body.rays.pop()
    return body


def head(random, extra):
    """Skull, jaw, nose, brows, ears, neck. x is ahead, y is left, z is up."""
    body = Body(0.02)
    u = random.uniform
    skull = u(0.2, 0.26)
    body.cone((-u(0.08, 0.14), 0, 0.06), (0.05, 0, 0.06), skull, skull * u(0.9, 1.0))
    chin = np.array([u(0.13, 0.2), 0, -u(0.17, 0.25)])
    body.cone((0.05, 0, -0.05), chin, u(0.13, 0.17), u(0.06, 0.09))
    body.landmark(chin, X - 0.5 * Z)
    root = np.array([0.05 + skull * 0.85, 0, 0.06])
    nose = body.cone(root, root + (u(0.04, 0.1), 0, -u(0.06, 0.12)), 0.022, u(0.028, 0.045))
    body.landmark(nose, X)
    for sign in (1, -1):
        brow = np.array([0.05 + skull * 0.75, sign * 0.09, 0.12])
        body.cone(brow - (0, sign * 0.05, 0), brow + (0, sign * 0.05, -0.02), 0.03, 0.025)
        body.landmark(brow, X)
        cheek = np.array([0.1, sign * 0.12, -0.05])
        body.cone(cheek, cheek + (0.03, 0, 0), u(0.05, 0.08), 0.05)
        body.landmark(cheek, X + sign * Y)
        ear = np.array([-0.03, sign * skull * 0.95, 0.02])
        limb(body, ear, sign * Y + u(-0.6, -0.1) * X + u(-0.2, 0.8) * Z, X, [u(0.04, 0.1)], [0.045, u(0.02, 0.04)],
             [0.0])
    body.landmark((-0.05, 0, 0.06), Z)
    body.landmark((-0.05, 0, 0.06), -X)
    tilt = u(-0.3, 0.3)
    neck = limb(body, (-0.07, 0, -0.1), turned(turned(-Z, Y, tilt), X, u(-0.3, 0.3)), Y, [u(0.2, 0.35)],
                [0.13, u(0.11, 0.16)], [0.0])
    body.landmark(neck[0], -X - 0.3 * Z)
    if random.random() < extra:  # a bun
        body.cone((-0.25, 0, 0.2), (-0.3, 0, 0.24), 0.08, 0.08)
    return body


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
    makers = {"animals": animal, "hands": hand, "heads": head}
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
