# SPDX-License-Identifier: MIT
"""Measures of the two bodies. Left half; metres, Z up, facing -Y."""
from dataclasses import dataclass, field

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
    arm_angle: float = field(default=58)


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
