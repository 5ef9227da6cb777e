# SPDX-License-Identifier: MIT
"""Measures of the two bodies. Left half; metres, Z up, facing -Y."""
from dataclasses import dataclass, replace

import numpy as np

from geometry import vec


@dataclass(frozen=True)
class Ring:
    """A horizontal slice of the trunk: an oval with its own depth in front and behind."""
    z: float
    half_width: float
    front: float
    back: float
    centre_y: float
    squareness: float  # 2 is an ellipse, more is boxier


@dataclass(frozen=True)
class Head:
    chin_z: float
    size: float
    width: float
    depth: float
    jaw: float


@dataclass(frozen=True)
class Body:
    name: str
    is_woman: bool
    trunk: dict
    neck: float
    bust: float
    head: Head
    shoulder: np.ndarray
    upper_arm: float
    forearm: float
    arm_girth: float
    hand: float
    hip: np.ndarray
    knee: np.ndarray
    ankle: np.ndarray
    leg_girth: float
    foot: float
    joint_z: dict
    hair: str
    sleeve: float  # length along the arm
    arm_angle: float = 58
    size: float = 1.0      # of the details that do not follow from the measures above
    belly: float = 0.0     # how far the front of the waist comes out
    stoop: float = 0.0     # degrees
    skirt: object = None   # a SkirtCut
    legs: str = "trousers"
    accessories: tuple = ()
    energy: float = 1.0    # of the movements
    arms_off: float = 0.0  # degrees that hanging arms stand further off than others'
    stance: float = 1.0    # how far apart the feet stand, of what others do
    wide_sleeve: float = 0.0  # metres that the end of the sleeve is wider than the arm
    wardrobe: str = ""


def man():
    return Body(
        name="man", is_woman=False,
        trunk={
            "crotch": Ring(.865, .163, .092, .108, .012, 2.2),
            "pelvis": Ring(.928, .157, .096, .110, .010, 2.3),
            "hem": Ring(.915, .168, .104, .122, .010, 2.3),
            "waist": Ring(1.09, .146, .100, .088, .006, 2.3),
            "ribs": Ring(1.22, .160, .114, .096, .006, 2.3),
            "armpit": Ring(1.315, .172, .118, .108, .010, 2.4),
            "chest": Ring(1.385, .178, .106, .108, .012, 2.4),
            "shoulder": Ring(1.452, .176, .070, .082, .018, 2.2),
            "collar": Ring(1.492, .092, .066, .066, .020, 2.0)},
        neck=.060, bust=0.0, head=Head(1.532, .242, 1.02, 1.0, 1.0),
        shoulder=vec(.174, .008, 1.424), upper_arm=.285, forearm=.262, arm_girth=1.0, hand=1.0,
        hip=vec(.093, .004, .905), knee=vec(.100, -.006, .490), ankle=vec(.104, .020, .088),
        leg_girth=1.0, foot=1.06,
        joint_z=dict(hips=.955, spine=1.06, chest=1.21, neck=1.478, head=1.553, top=1.79),
        hair="short", sleeve=.175)


def woman():
    return Body(
        name="woman", is_woman=True,
        trunk={
            "crotch": Ring(.815, .166, .090, .111, .012, 2.1),
            "pelvis": Ring(.914, .155, .090, .108, .010, 2.1),
            "hem": Ring(.880, .170, .100, .122, .010, 2.1),
            "waist": Ring(1.035, .118, .084, .076, .004, 2.1),
            "ribs": Ring(1.150, .130, .096, .082, .004, 2.1),
            "armpit": Ring(1.235, .144, .110, .090, .006, 2.1),
            "chest": Ring(1.295, .150, .096, .090, .010, 2.2),
            "shoulder": Ring(1.357, .150, .058, .070, .016, 2.1),
            "collar": Ring(1.396, .080, .060, .056, .018, 2.0)},
        neck=.048, bust=.021, head=Head(1.432, .230, .98, .98, .88),
        shoulder=vec(.146, .008, 1.332), upper_arm=.262, forearm=.240, arm_girth=.82, hand=.88,
        hip=vec(.090, .004, .855), knee=vec(.088, -.006, .462), ankle=vec(.090, .018, .084),
        leg_girth=.94, foot=.93,
        joint_z=dict(hips=.905, spine=.995, chest=1.135, neck=1.384, head=1.455, top=1.68),
        hair="bob", sleeve=.44)


class Proportions:
    """Factors from an adult to somebody else. The joints, rings and girths follow."""

    def __init__(self, leg=1.0, trunk=1.0, width=1.0, depth=1.0, arm=1.0, arm_girth=1.0,
                 leg_girth=1.0, hip_width=1.0):
        self.leg, self.trunk, self.width, self.depth = leg, trunk, width, depth
        self.arm, self.arm_girth, self.leg_girth = arm, arm_girth, leg_girth
        self.hip_width = hip_width


def reshaped(body, name, p, head, **changes):
    """body with other proportions and another head (chin_z counted from body's own trunk)."""
    hip_z = body.hip[2]

    def level(z):
        return z * p.leg if z <= hip_z else hip_z * p.leg + (z - hip_z) * p.trunk

    size = (p.leg + p.trunk) / 2

    def ring(name, r):
        width = p.hip_width if name in ("crotch", "pelvis", "hem") else p.width
        return Ring(level(r.z), r.half_width * width, r.front * p.depth, r.back * p.depth,
                    r.centre_y * size, r.squareness)

    chin = level(body.head.chin_z) + head.chin_z
    joint_z = {key: level(z) for key, z in body.joint_z.items()}
    joint_z.update(neck=level(body.trunk["collar"].z) - .012, head=chin + head.size * .09,
                   top=chin + head.size * 1.07)
    place = lambda v, across: v * vec(across, size, 1) + vec(0, 0, level(v[2]) - v[2])
    return replace(
        body, name=name, trunk={key: ring(key, r) for key, r in body.trunk.items()},
        neck=body.neck * (p.width + head.size / body.head.size) / 2, bust=body.bust * p.depth,
        head=replace(head, chin_z=chin), shoulder=place(body.shoulder, p.width),
        upper_arm=body.upper_arm * p.arm, forearm=body.forearm * p.arm,
        arm_girth=body.arm_girth * p.arm_girth, hand=body.hand * p.arm,
        hip=place(body.hip, p.hip_width), knee=place(body.knee, p.hip_width),
        ankle=place(body.ankle, p.hip_width), leg_girth=body.leg_girth * p.leg_girth,
        foot=body.foot * p.leg, joint_z=joint_z, sleeve=body.sleeve * p.arm, size=size,
        **changes)
