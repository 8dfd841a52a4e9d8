"""Poses of animals and expressions of heads, by code.

posed() rotates the bones of an animal of bodies.animal() about their joints, by linear blend skinning: each point
moves by the mean of the motions of the bones near it. Bodies with the same angles are in the same pose, so that a pose
that is transferred from one animal to another one can be compared with that of the other one's own skeleton.
crouched() lowers the body of an animal above resting feet. expressed() moves jaw, brows and cheeks of a head of bodies.head().
"""
import numpy as np

X, Y, Z = np.eye(3)
# Parent of each cone of an animal: back, loin, chest, neck, crown, snout, ears, tail, legs (hip, knee, foot).
LOIN = 1
PARENTS = [1, -1, 1, 2, 3, 4, 4, 4, 0, 8, 9, 2, 11, 12, 2, 14, 15, 0, 17, 18, 0, 20, 21]
NECK, CROWN, TAIL = 3, 4, (8, 9, 10)
LEGS = {"front left": 11, "front right": 14, "rear left": 17, "rear right": 20}
SMOOTHNESS = 0.03  # of the skinning


def bent(name, swing, knee=0.0):
    """Angles of a leg about the y axis; above 0, it swings back."""
    hip = LEGS[name]
    return {hip: (Y, swing), hip + 1: (Y, knee), hip + 2: (Y, -0.5 * knee)}


# Axis and angle of each bone, relative to its parent.
POSES = {
    "stride": {**bent("front left", -0.6), **bent("front right", 0.5, 0.6), **bent("rear left", 0.55),
               **bent("rear right", -0.45, -0.5), NECK: (Y, 0.2), TAIL[0]: (Y, 0.4), TAIL[1]: (Y, 0.3)},
    "look": {NECK: (Z, 0.6), CROWN: (Z, 0.5), 0: (Z, 0.2), TAIL[0]: (Z, -0.5), TAIL[1]: (Z, -0.4),
             TAIL[2]: (Z, -0.4)},
    "bow": {2: (Y, 0.35), **bent("front left", -1.1, 0.3), **bent("front right", -1.0, 0.2), NECK: (Y, -0.5),
            TAIL[0]: (Y, 0.9), 0: (Y, -0.15)},
    "gallop": {**bent("front left", -0.9, 0.2), **bent("front right", -0.7, 0.3), **bent("rear left", 0.9, -0.2),
               **bent("rear right", 0.8, -0.3), NECK: (Y, 0.45), CROWN: (Y, -0.2), TAIL[0]: (Y, 0.6)},
}


def rotation(axis, angle):
    """Matrix of a rotation (Rodrigues)."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def cone_distances(points, body):
    """Signed distance of each point to each cone."""
    result = []
    for begin, end, first, last in body.cones:
        along = end - begin
        t = np.clip((points - begin) @ along / max(along @ along, 1e-12), 0, 1)
        result.append(np.linalg.norm(points - begin - t[:, None] * along, axis=1) - (first + t * (last - first)))
    return np.array(result).T


def posed(points, body, pose, share=1.0):
    """Points of an animal, moved by a pose, of which all angles are multiplied by a share."""
    if len(body.cones) != len(PARENTS):
        raise ValueError("only animals without further limbs have poses")
    motions = {}

    def motion(bone):
        if bone not in motions:
            turn, shift = motion(PARENTS[bone]) if PARENTS[bone] >= 0 else (np.eye(3), np.zeros(3))
            if bone in pose:
                axis, angle = pose[bone]
                own = rotation(axis, share * angle)
                # The back starts at the loin, although its cone ends there.
                joint = body.cones[bone][1 if bone == 0 else 0]
                turn, shift = turn @ own, turn @ (joint - own @ joint) + shift
            motions[bone] = turn, shift
        return motions[bone]

    distances = cone_distances(points, body)
    weights = np.exp(-(distances - distances.min(axis=1)[:, None]) / SMOOTHNESS)
    weights /= weights.sum(axis=1)[:, None]
    moved = [points @ turn.T + shift for turn, shift in map(motion, range(len(PARENTS)))]
    return np.einsum("ib,bik->ik", weights, np.array(moved))


def crouched(points, share=1.0):
    """An animal that leans forward and down, while its feet rest: the lowest 15 percent of its height."""
    low, high = points[:, 2].min(), points[:, 2].max()
    above = np.clip(((points[:, 2] - low) / (high - low) - 0.15) / 0.85, 0, 1)
    rise = (above * above * (3 - 2 * above))[:, None]
    return points + share * (high - low) * rise * (0.2 * X - 0.15 * Z)


def feet(points):
    """Which points are feet: the lowest 10 percent of the height."""
    low, high = points[:, 2].min(), points[:, 2].max()
    return points[:, 2] <= low + 0.1 * (high - low)


def bump(points, center, radius):
    """Smooth weight: 1 at a center, 0 from about two radii on."""
    return np.exp(-np.sum((points - center)**2, axis=1) / radius**2)


# Angle of the jaw, lifts of the left and right brow, and inflation of the cheeks.
EXPRESSIONS = {"surprise": (0.3, 0.06, 0.06, 0.0), "doubt": (0.0, 0.07, -0.03, 0.0), "puff": (0.0, 0.0, 0.0, 0.07),
               "smirk": (0.12, 0.03, -0.02, 0.03)}


def expressed(points, body, expression, share=1.0):
    """Points of a head with an expression, of which all motions are multiplied by a share."""
    jaw, left, right, cheeks = share * np.array(expression)
    chin, brows, cheek = body.rays[0][0], (body.rays[2][0], body.rays[5][0]), (body.rays[3][0], body.rays[6][0])
    hinge = np.array([0.0, 0.0, -0.05])
    below = 1 / (1 + np.exp((points[:, 2] - 0.5 * (chin[2] + hinge[2])) / 0.03))
    front = 1 / (1 + np.exp(-(points[:, 0] - 0.02) / 0.03))
    opened = (points - hinge) @ rotation(Y, jaw).T + hinge
    moved = points + (below * front)[:, None] * (opened - points)
    for center, lift in zip(brows, (left, right)):
        moved += bump(points, center, 0.1)[:, None] * lift * (Z + 0.2 * X)
    for center, side in zip(cheek, (1, -1)):
        moved += bump(points, center + 0.06 * X, 0.09)[:, None] * cheeks * (0.7 * X + side * Y)
    return moved
