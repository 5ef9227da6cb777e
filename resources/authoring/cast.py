# SPDX-License-Identifier: MIT
"""The eight people of today: measures, hair, cut of the clothes, and what they carry."""
from dataclasses import replace

from body import Head, Proportions, man, reshaped, woman
from body_skirt import SkirtCut


def today():
    return (_man(), _woman(), _man_in_coat(), _woman_in_dress(), _girl(), _boy(), _old_woman(),
            _old_man())


def _man():
    return replace(man(), accessories=("backpack",), wardrobe="man")


def _woman():
    return replace(woman(), accessories=("scarf",), wardrobe="woman", stance=.85)


def _man_in_coat():
    body = reshaped(man(), "man_2", Proportions(leg=1.035, trunk=1.01, width=1.04, depth=1.04,
                                               arm=1.03, arm_girth=1.10, leg_girth=1.02,
                                               hip_width=1.02),
                    Head(.002, .246, 1.0, .99, 1.04), hair="curly", legs="under coat",
                    wardrobe="man_2", accessories=("scarf",), arms_off=8.0, stance=1.35)
    return replace(body, sleeve=.50,
                   skirt=SkirtCut("top", body.knee[2] + .10, .052, .034, .056))


def _woman_in_dress():
    body = reshaped(woman(), "woman_2", Proportions(leg=1.02, trunk=.99, width=.98, depth=.98,
                                                   arm_girth=.96, leg_girth=.96),
                    Head(0, .229, .97, .98, .86), hair="long", legs="bare", wardrobe="woman_2",
                    accessories=("sun_hat",))
    return replace(body, sleeve=.13,
                   skirt=SkirtCut("top", body.knee[2] - .03, .115, .050, .080))


def _girl():
    body = reshaped(woman(), "girl", Proportions(leg=.70, trunk=.735, width=.80, depth=.80,
                                                arm=.70, arm_girth=.82, leg_girth=.78,
                                                hip_width=.74),
                    Head(-.004, .214, 1.04, .98, .90), hair="pigtails", legs="bare",
                    wardrobe="girl", accessories=("backpack",))
    return replace(body, bust=0.0, sleeve=.10,
                   skirt=SkirtCut("bottom", body.knee[2] + .05, .075, .032, .060))


def _boy():
    body = reshaped(man(), "boy", Proportions(leg=.70, trunk=.71, width=.70, depth=.80, arm=.70,
                                             arm_girth=.70, leg_girth=.74, hip_width=.74),
                    Head(-.002, .216, 1.05, .98, .94), hair="crop", legs="shorts",
                    wardrobe="boy", accessories=("cap", "backpack"))
    return replace(body, sleeve=.115)


def _old_woman():
    body = reshaped(woman(), "old_woman", Proportions(leg=.93, trunk=.97, width=1.10, depth=1.16,
                                                     arm=.95, arm_girth=1.16, leg_girth=1.06,
                                                     hip_width=1.12),
                    Head(-.002, .228, 1.02, 1.0, .96), hair="bun", legs="leggings",
                    wardrobe="old_woman", accessories=("scarf",), belly=.030, stoop=14.0,
                    energy=.72)
    return replace(body, sleeve=.42,
                   skirt=SkirtCut("bottom", body.knee[2] - .13, .060, .030, .055))


def _old_man():
    body = reshaped(man(), "old_man", Proportions(leg=.955, trunk=.98, width=1.02, depth=1.08,
                                                 arm=.97, leg_girth=1.02, hip_width=1.03),
                    Head(0, .240, 1.03, 1.0, 1.02), hair="bald", wardrobe="old_man",
                    accessories=("hat",), belly=.070, stoop=10.0, energy=.76)
    return replace(body, sleeve=.48)
