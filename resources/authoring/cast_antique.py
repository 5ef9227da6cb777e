# SPDX-License-Identifier: MIT
"""The antique audience: measures, hair, cut of the clothes, and what they wear over them."""
from dataclasses import replace

from body import Head, Proportions, man, reshaped, woman
from body_skirt import SkirtCut


def antique():
    return _patrician(), _matron(), _citizen(), _labourer(), _priest()


def _dressed(body, bottom_z, side, front, back, sleeve):
    return replace(body, sleeve=sleeve, skirt=SkirtCut("top", bottom_z, side, front, back))


def _patrician():
    """A heavy man in a toga down to the calves."""
    body = reshaped(man(), "patrician", Proportions(width=1.10, depth=1.12, arm_girth=1.12,
                                                   leg=.97, hip_width=1.10),
                    Head(0, .242, 1.04, 1.0, 1.04), hair="crop", legs="bare",
                    wardrobe="patrician", belly=.045,  accessories=("toga_fold",))
    return _dressed(body, body.ankle[2] + .11, .100, .080, .130, .30)


def _matron():
    body = reshaped(woman(), "matron", Proportions(leg=1.0, width=1.05, depth=1.06, arm_girth=1.06,
                                                  hip_width=1.05),
                    Head(0, .228, 1.0, .99, .90), hair="gathered", legs="bare", wardrobe="matron",
                    accessories=("shawl", "veil"))
    body = _dressed(body, body.ankle[2] + .07, .120, .060, .150, .20)
    return replace(body, skirt=replace(body.skirt, follow=.8))


def _citizen():
    body = reshaped(man(), "citizen", Proportions(leg=.98, trunk=.99, arm=.99),
                    Head(0, .240, 1.0, 1.0, .98), hair="curly", legs="bare", wardrobe="citizen",
                    stance=.92,
                    accessories=("toga_fold",))
    return _dressed(body, body.knee[2] + .03, .075, .045, .070, .22)


def _labourer():
    """Broad and short, in a tunic above the knees and a felt cap."""
    body = reshaped(man(), "labourer", Proportions(leg=.93, trunk=.97, width=1.08, depth=1.05,
                                                  arm_girth=1.16, leg_girth=1.08, hip_width=1.05),
                    Head(0, .240, 1.05, 1.0, 1.08), hair="crop", legs="bare",
                    wardrobe="labourer", accessories=("felt_cap",))
    return _dressed(body, body.knee[2] + .10, .060, .045, .060, .12)


def _priest():
    """Tall and thin, old, the robe drawn over the head."""
    body = reshaped(man(), "priest", Proportions(leg=1.02, trunk=1.0, width=.95, depth=.96,
                                                arm_girth=.92, leg_girth=.94, hip_width=.97),
                    Head(0, .242, .98, 1.0, .94), hair="bald", legs="bare", wardrobe="priest",
                    accessories=("veil",), stoop=7.0, energy=.78, wide_sleeve=.080,
                    arms_off=5.0)
    return _dressed(body, body.ankle[2] + .05, .100, .055, .090, .44)
