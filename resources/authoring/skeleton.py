# SPDX-License-Identifier: MIT
"""Bones of a person, and poses: rotations per bone with feet and hands placed by two-bone IK."""
import math

import numpy as np

from body_skirt import is_gathered
from geometry import frame, rot_x, rot_y, rot_z, unit, vec

SIDES = (("L", 1), ("R", -1))
MAX_REACH = .9985
STOOP = {"spine": .35, "chest": .65, "neck": .15, "head": -.85}
HANG_REFERENCE = 16.0  # arm angles below are given for an A-pose of 42 degrees, bodies rest at 58


class Bone:
    """Rest position of one joint; rest orientation is the identity."""

    def __init__(self, parent, head, tail):
        self.parent, self.head, self.tail = parent, head, tail

    def direction(self):
        return self.tail - self.head


def make_bones(body):
    """name -> Bone, parents first."""
    z, shoulder = body.joint_z, body.shoulder
    angle = math.radians(body.arm_angle)
    along, forward = vec(math.cos(angle), 0, -math.sin(angle)), vec(0, -1, 0)
    elbow = shoulder + along * body.upper_arm
    wrist = elbow + along * body.forearm + forward * body.forearm * math.sin(math.radians(8))
    finger = wrist + (along * .15 + forward * .02) * body.hand
    ball = vec(body.ankle[0] + .003, -.098 * body.foot, .018)
    bones = {
        "root": Bone(None, vec(0, 0, 0), vec(0, 0, .15)),
        "hips": Bone("root", vec(0, .006, z["hips"]), vec(0, .006, z["spine"])),
        "spine": Bone("hips", vec(0, .006, z["spine"]), vec(0, .012, z["chest"])),
        "chest": Bone("spine", vec(0, .012, z["chest"]), vec(0, .020, z["neck"])),
        "neck": Bone("chest", vec(0, .020, z["neck"]), vec(0, .012, z["head"])),
        "head": Bone("neck", vec(0, .012, z["head"]), vec(0, .012, z["top"])),
    }
    clavicle = vec(.03, .010, shoulder[2] + .012) * vec(body.size, body.size, 1)
    for side, sign in SIDES:
        mirror = vec(sign, 1, 1)
        chains = (
            ("shoulder", "chest", clavicle, shoulder),
            ("upperarm", "shoulder_" + side, shoulder, elbow),
            ("forearm", "upperarm_" + side, elbow, wrist),
            ("hand", "forearm_" + side, wrist, finger),
            ("thigh", "hips", body.hip, body.knee),
            ("shin", "thigh_" + side, body.knee, body.ankle),
            ("foot", "shin_" + side, body.ankle, ball),
            ("toe", "foot_" + side, ball, ball + vec(0, -.09, 0)),
        )
        if is_gathered(body):
            chains += (("skirt", "thigh_" + side, body.hip, body.knee),)
        for name, parent, head, tail in chains:
            bones[f"{name}_{side}"] = Bone(parent, head * mirror, tail * mirror)
    return bones


class LegTarget:
    def __init__(self, ankle, foot, toe, knee_towards):
        self.ankle, self.foot, self.toe, self.pole = ankle, foot, toe, unit(knee_towards)


class ArmTarget:
    """Wrist position; fingers and palm directions of the hand; where the elbow points."""

    def __init__(self, wrist, fingers, palm, elbow_towards):
        self.wrist, self.fingers, self.palm = wrist, fingers, palm
        self.pole = unit(elbow_towards)


class Pose:
    """Fill offset, local, legs and arms; solve() gives global rotations and joint positions."""

    def __init__(self, body, bones):
        self.body, self.bones = body, bones
        self.offset = vec(0, 0, 0)  # of the hips from rest
        self.gather = 0.0           # how far a short skirt is drawn around the thighs
        self.local, self.legs, self.arms = {}, {}, {}
        self.rotation, self.position, self.reach = {}, {}, {}

    def solve(self):
        for name, bone in self.bones.items():
            self._place(name, bone)
            side = name[-1]
            if name[:-2] in ("thigh", "shin", "foot", "toe") and side in self.legs:
                self._follow_leg(name[:-2], side)
            if name[:-2] in ("upperarm", "forearm", "hand") and side in self.arms:
                self._follow_arm(name[:-2], side)
        return self

    def _place(self, name, bone):
        if bone.parent is None:
            self.rotation[name], self.position[name] = np.eye(3), bone.head.copy()
            return
        parent = self.rotation[bone.parent]
        arm = bone.head - self.bones[bone.parent].head
        self.position[name] = self.position[bone.parent] + parent @ arm
        if name == "hips":
            self.position[name] = self.position[name] + self.offset
        self.rotation[name] = parent @ self._stooped(name) @ self.local.get(name, np.eye(3))

    def _stooped(self, name):
        return rot_x(self.body.stoop * STOOP[name]) if name in STOOP else np.eye(3)

    def _follow_leg(self, part, side):
        target = self.legs[side]
        if part == "thigh":
            self._solve_chain(("thigh_" + side, "shin_" + side), target.ankle, target.pole,
                              vec(1, 0, 0))
        elif part == "shin":
            self.rotation["shin_" + side] = self._lower
        else:
            self.rotation[f"{part}_{side}"] = target.foot if part == "foot" else target.toe

    def _follow_arm(self, part, side):
        target = self.arms[side]
        if part == "upperarm":
            self._solve_chain(("upperarm_" + side, "forearm_" + side), target.wrist, target.pole,
                              None)
        elif part == "forearm":
            self.rotation["forearm_" + side] = self._lower
        elif target.fingers is not None:
            self.rotation["hand_" + side] = hand_rotation(self.body, side, target.fingers,
                                                          target.palm)

    def _solve_chain(self, names, target, pole, hinge):
        """Law of cosines in the plane of the target and the pole."""
        upper, lower = (self.bones[name].direction() for name in names)
        length1, length2 = np.linalg.norm(upper), np.linalg.norm(lower)
        start = self.position[names[0]]
        distance = np.linalg.norm(target - start)
        self.reach[names[0]] = distance / (length1 + length2)
        distance = min(max(distance, abs(length1 - length2) * 1.02),
                       (length1 + length2) * MAX_REACH)
        line = unit(target - start)
        cosine = (length1 ** 2 + distance ** 2 - length2 ** 2) / (2 * length1 * distance)
        sideways = unit(pole - line * np.dot(pole, line))
        middle = start + line * length1 * cosine \
            + sideways * length1 * math.sqrt(max(0, 1 - cosine ** 2))
        axis = unit(np.cross(sideways, line))
        rest1, rest2 = unit(upper), unit(lower)
        if hinge is None:
            hinge = unit(np.cross(rest1 * np.dot(rest1, rest2) - rest2, rest1))
        self.rotation[names[0]] = frame(unit(middle - start), axis) @ frame(rest1, hinge).T
        self._lower = frame(unit(start + line * distance - middle), axis) @ frame(rest2, hinge).T


def hand_rotation(body, side, fingers, palm):
    sign, angle = (1 if side == "L" else -1), math.radians(body.arm_angle)
    rest_fingers = vec(sign * math.cos(angle), 0, -math.sin(angle))
    rest_palm = vec(-sign * math.sin(angle), 0, -math.cos(angle))
    return frame(fingers, palm) @ frame(rest_fingers, rest_palm).T


def hanging_arm(sign, lower, swing):
    """Upper arm lowered from the A-pose, then swung (positive = backwards)."""
    return rot_x(swing) @ rot_y(sign * (lower - HANG_REFERENCE))


def plant_foot(pose, side, sign, x, y, turn, knee_towards=None, lift=0.0, heel=0.0):
    """A foot on the ground at x, y, turned outwards; heel raises it about the ball."""
    body = pose.body
    turned = rot_z(sign * turn)
    ball = vec(0, -.098 * body.foot - body.ankle[1], -body.ankle[2])
    ankle = vec(sign * x, y + body.ankle[1], body.ankle[2])
    if heel:
        ankle = ankle + turned @ ball - turned @ rot_x(heel) @ ball
    tipped = turned @ rot_x(heel)
    pose.legs[side] = LegTarget(ankle + vec(0, 0, lift), tipped, tipped if lift > 0 else turned,
                                vec(sign * .22, -1, .1) if knee_towards is None else knee_towards)
