# SPDX-License-Identifier: MIT
"""Puts the surface of one level of detail together."""
from body_arm import Arm
from body_detail import DETAILS
from body_hair import STYLES, HairShell
from body_head import add_head
from body_leg import Leg
from body_skirt import Skirt
from body_trunk import Trunk
from surface import Surface


def build_body(body, level):
    surface, detail = Surface(), DETAILS[level]
    trunk = Trunk(surface, body, detail)
    style = STYLES[body.hair]
    shape = add_head(surface, body, detail, trunk, None if style.is_bald else style.edge,
                     style.has_ears)
    HairShell(surface, body, detail, shape).add()
    Arm(surface, body, detail, trunk).add()
    Leg(surface, body, detail, trunk).add()
    if body.skirt:
        Skirt(surface, body, detail, trunk).add()
    surface.mirror()
    return surface
