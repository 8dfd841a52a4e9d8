"""Animals, hands and heads made by code: smooth unions of round cones along a skeleton.

A round cone is a ball whose radius changes along a segment. animal(), hand() and head() make bodies with random
lengths, widths and bends, and with landmarks, which are where rays from the skeleton leave the body. The cones of all
animals without further limbs (extra = 0) are in the same order.
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import level_sets

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
        values = self.height(np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1))
        return level_sets.zero_level(values, counts, lower, spacing)

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
