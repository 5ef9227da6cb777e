# SPDX-License-Identifier: MIT
"""A skirt, or the lower part of a dress or coat: one tube around both legs, which follows the
thighs, and below the knees the shins. A short one is gathered around the thighs of who sits, by
joints of its own."""
import math
from dataclasses import dataclass

from body_detail import DETAILS, trunk_angles
from body_leg import LEG_TUBES, Leg
from geometry import lerp, smoothstep, vec

SHARES = ((0, .28, .62, 1), (0, .30, .65, 1), (0, .45, 1), (0, 1))
BELOW_KNEE = ((0, .28, .52, .76, 1),) + SHARES[1:]
LINING, LONG_LINING = .28, .72  # where the cloth's inner side ends
GATHERED_EASE = vec(.018, .013, .014)  # of the hem of who sits: to the side, in front, behind
LONG_SHARES = ((0, .15, .33, .52, .72, 1), (0, .25, .52, .76, 1), (0, .30, .60, 1), (0, .5, 1))


@dataclass(frozen=True)
class SkirtCut:
    slot: str       # "bottom" for a skirt, "top" for a dress or a coat
    bottom_z: float
    side: float     # how far the lower edge is wider than the hem, to the side
    front: float
    back: float
    follow: float = .9  # share of the shins in what hangs below the knees


class Skirt:
    def __init__(self, surface, body, detail, trunk):
        self.surface, self.body, self.detail, self.trunk = surface, body, detail, trunk
        self.cut, self.hem = body.skirt, body.trunk["hem"]

    def add(self):
        cut, upper_z = self.cut, self.hem.z
        is_long = cut.bottom_z < self.body.knee[2] - .20
        is_below_knee = cut.bottom_z < self.body.knee[2] - .05
        shares = (LONG_SHARES if is_long else BELOW_KNEE if is_below_knee else SHARES)[
            self.detail.level]
        rings = [self._first_ring()]
        for t in shares[1:]:
            rings.append(self._ring(t))
        for k in range(len(rings) - 1):
            v = .40 - .38 * shares[k + 1], .40 - .38 * shares[k]
            self.surface.band(rings[k + 1], rings[k], cut.slot, self.trunk.u, v, mirrors_uv=True)
        if self.detail.is_finest:
            # Deep enough that nobody who sits looks hollow from the front.
            lining = self._ring(LONG_LINING if is_long else LINING, -.012)
            self.surface.band(lining, rings[-1], cut.slot, self.trunk.u, (0, .02),
                              mirrors_uv=True)
        if upper_z <= cut.bottom_z:
            raise ValueError("the skirt ends above the hem")

    def _first_ring(self):
        if self.cut.slot == "top":
            return self.trunk.rings["hem"]
        return self._ring(0, -.004, .012)

    def _ring(self, t, thicker=0.0, higher=0.0):
        cut, hem, growth = self.cut, self.hem, self.detail.inflation
        z = lerp(hem.z, cut.bottom_z, t) + higher
        spread = t ** .8
        width = (hem.half_width + cut.side * spread + thicker) * growth
        points = []
        for angle in self._angles(t, width):
            sine, cosine = math.sin(angle), math.cos(angle)
            deep = hem.front + cut.front * spread if cosine > 0 else hem.back + cut.back * spread
            on_middle = angle < 1e-6 or abs(angle - math.pi) < 1e-6
            belly = self.body.belly * .72 * max(0, 1 - t * 1.6) * max(0, cosine)
            points.append(vec(0 if on_middle else width * sine ** .92,
                              hem.centre_y - (deep + thicker) * growth * cosine - belly, z))
        return self.surface.add_ring(points, self.weights)

    def _angles(self, t, width):
        """As on the trunk above; further down the columns next to the middle stand at the inner
        side of the legs, so that the cloth before each follows that leg alone."""
        angles = trunk_angles(self.detail)
        count = len(angles) - 1
        if count % 2:
            return angles
        leg = math.asin(min(.95, self._leg_x() / width))
        step = (math.pi / 2 - leg) / max(1, count / 2 - 1)
        moved = [leg + step * (i - 1) for i in range(1, count // 2)]
        moved = [0] + moved + [math.pi / 2] + [math.pi - a for a in moved[::-1]] + [math.pi]
        return [lerp(a, b, smoothstep(t, 0, .35)) for a, b in zip(angles, moved)]

    def _leg_x(self):
        return self.body.hip[0] * .42

    def weights(self, point):
        s, z, hip, knee = self.body.size, point[2], self.body.hip[2], self.body.knee[2]
        thigh = 1 - smoothstep(z, hip - .12 * s, hip + .05 * s)
        shin = (1 - smoothstep(z, knee - .13 * s, knee + .03 * s)) * self.cut.follow
        left = .5 + .5 * smoothstep(abs(point[0]), 0, self._leg_x() * .98)
        # At most four bones for a point: all is gathered where the shins hold the cloth too, and
        # between the legs nothing where the hips do.
        low, high = max(self.cut.bottom_z, knee + .03 * s), hip - (.02 if left == 1 else .12) * s
        own = 1 - smoothstep(z, low, high) if is_gathered(self.body) else 0
        shares = {"hips": 1 - thigh}
        for name, share in (("thigh", (1 - shin) * (1 - own)), ("skirt", (1 - shin) * own),
                            ("shin", shin)):
            shares[name + "_L"] = thigh * share * left
            shares[name + "_R"] = thigh * share * (1 - left)
        return {name: share for name, share in shares.items() if share > 0}


def is_gathered(body):
    """Whether the cloth has joints of its own; long robes hang over the knees by themselves."""
    return bool(body.skirt) and body.skirt.bottom_z > body.knee[2] - .05


def gathered(body):
    """(offset, scale) of the joint skirt_L of who sits: the hem lies close around the thigh."""
    cut, hem, z = body.skirt, body.trunk["hem"], body.skirt.bottom_z
    leg = Leg(None, body, DETAILS[0], None)
    centre, cloth = leg.centre(max(z, body.knee[2])), LEG_TUBES[body.legs][0][3]
    side, front, back = (r + max(0, 2 * cloth) + ease
                         for r, ease in zip(leg.radii(z), GATHERED_EASE))
    front += .015 if z < body.knee[2] else 0  # which bends
    wide = hem.half_width + cut.side
    first, last = hem.centre_y - hem.front - cut.front, hem.centre_y + hem.back + cut.back
    scale = vec(side / (wide - centre[0]), (front + back) / (last - first), 1)
    # What is at the side and behind comes to lie next to the thigh; the joint is in the hip.
    offset = vec(centre[0] - body.hip[0] - scale[0] * (centre[0] - body.hip[0]),
                 centre[1] + back - body.hip[1] - scale[1] * (last - body.hip[1]), 0)
    return offset, scale
