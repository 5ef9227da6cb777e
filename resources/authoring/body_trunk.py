# SPDX-License-Identifier: MIT
"""The trunk: top and the upper end of the trousers, with a hole for each arm."""
import math

from body_detail import chart_u, chart_v, trunk_angles
from geometry import smoothstep, vec
from surface import blend


WITH_PELVIS = ("trousers", "shorts")
# How much each ring takes part in a belly.
BELLY = {"hem": .72, "waist": 1.0, "ribs": .62, "armpit": .22, "pelvis": .4}


def trunk_weights(body, point):
    """Spine bones by height, the shoulder girdle and the thighs at the ends."""
    z, joint, s = point[2], body.joint_z, body.size
    spine = smoothstep(z, joint["spine"] - .07 * s, joint["spine"] + .07 * s)
    chest = smoothstep(z, joint["chest"] - .08 * s, joint["chest"] + .08 * s)
    neck = smoothstep(z, joint["neck"] - .012, joint["neck"] + .03)
    head = smoothstep(z, joint["head"] - .03 * s, joint["head"] + .022 * s)
    weights = {"hips": 1 - spine, "spine": spine * (1 - chest), "chest": chest * (1 - neck),
               "neck": neck * (1 - head), "head": head}
    shoulder = body.shoulder
    girdle = smoothstep(abs(point[0]), shoulder[0] * .42, shoulder[0] * .98) \
        * smoothstep(z, shoulder[2] - .10 * s, shoulder[2] - .01 * s) * (1 - neck) * .75
    if girdle > 0:
        weights = blend(weights, "shoulder_L", girdle)
    hip_z = body.hip[2]
    thigh = (1 - smoothstep(z, hip_z - .075 * s, hip_z + .065 * s)) * .62 \
        * smoothstep(abs(point[0]), 0, .10 * s) * (.9 if point[1] > 0 else 1)
    return blend(weights, "thigh_L", thigh) if thigh > 0 else weights


def ring_points(body, detail, name, thicker=0.0, higher=0.0):
    ring = body.trunk[name]
    return [_ring_point(body, detail, name, ring, angle, thicker, higher)
            for angle in trunk_angles(detail)]


def _ring_point(body, detail, name, ring, angle, thicker, higher):
    sine, cosine = math.sin(angle), math.cos(angle)
    power = 2.0 / ring.squareness
    depth = ring.front if cosine > 0 else ring.back
    x = (ring.half_width + thicker) * detail.inflation * abs(sine) ** power
    y = ring.centre_y - (depth + thicker) * detail.inflation \
        * math.copysign(abs(cosine) ** power, cosine)
    z = ring.z + higher
    if name == "armpit":
        y -= body.bust * math.exp(-((angle - math.radians(33)) / math.radians(26)) ** 2)
    elif name in ("ribs", "chest"):
        y -= body.bust * (.57 if name == "ribs" else .33) * math.exp(-((angle - .55) / .5) ** 2)
    elif name == "shoulder":
        z += (.005 * (math.cos(angle * 2) - 1) + .010) * body.size
    elif name == "collar":
        z -= .016 * cosine * body.size  # lower in front
    elif name == "crotch":
        z -= .058 * cosine ** 4 * body.size
    if cosine > 0 and body.belly:
        y -= body.belly * BELLY.get(name, 0) * cosine ** .7
    on_middle = angle < 1e-6 or abs(angle - math.pi) < 1e-6
    return vec(0 if on_middle else x, y, z)


class Trunk:
    """Rings of vertex ids by name; arm_hole is the rim that the sleeve starts from."""

    def __init__(self, surface, body, detail):
        self.surface, self.body, self.detail = surface, body, detail
        self.u = [chart_u("trunk", .5 + a / (2 * math.pi)) for a in trunk_angles(detail)]
        self.rings = {}
        self._add_pelvis() if body.legs in WITH_PELVIS else self._add_hem()
        self._add_top()
        self.arm_hole = self._arm_hole_rim()

    def v(self, z):
        low, high = self.body.trunk["hem"].z, self.body.trunk["collar"].z
        return chart_v("trunk", (z - low) / (high - low))

    def _ring(self, name, **how):
        return self.surface.add_ring(ring_points(self.body, self.detail, name, **how),
                                     lambda p: trunk_weights(self.body, p))

    def _add_hem(self):
        """Under a skirt there is no pelvis to see."""
        self.rings["hem"] = self._ring("hem", thicker=.004)

    def _add_pelvis(self):
        rings = self.rings
        rings["crotch"] = self._ring("crotch")
        inner = self._ring("pelvis") if self.detail.level < 3 else None
        rings["hem"] = self._ring("hem", thicker=.004)
        self.surface.band(rings["crotch"], inner or rings["hem"], "bottom", self.u, (.8, 1),
                          mirrors_uv=True)
        if self.detail.is_finest:
            self._add_hem_lining()

    def _add_hem_lining(self):
        """The thickness of the cloth."""
        lining = self._ring("hem", thicker=-.010, higher=.004)
        low = self.v(self.body.trunk["hem"].z)
        self.surface.band(lining, self.rings["hem"], "top", self.u, (low - .01, low),
                          mirrors_uv=True)

    def _add_top(self):
        names = self.detail.trunk_rows
        for name in names[1:]:
            ease = .018 if self.detail.level == 3 else .003
            self.rings[name] = self._ring(name, thicker=0 if name == "collar" else ease)
        for below, above in zip(names[:-1], names[1:]):
            v = self.v(self.body.trunk[below].z), self.v(self.body.trunk[above].z)
            for i in range(self.detail.columns):
                if not self._is_in_hole(below, i):
                    columns = slice(i, i + 2)
                    self.surface.band(self.rings[below][columns], self.rings[above][columns],
                                      "top", self.u[columns], v, mirrors_uv=True)

    def _is_in_hole(self, below, column):
        hole = self.detail.arm_hole
        return hole and below in ("armpit", "chest") and hole[0] <= column < hole[1]

    def _arm_hole_rim(self):
        if self.detail.arm_hole is None:
            return None
        first, last = self.detail.arm_hole
        low, high = self.rings["armpit"], self.rings["shoulder"]
        rim = high[first:last + 1] + low[first:last + 1][::-1]
        if "chest" in self.rings:
            middle = self.rings["chest"]
            rim = [middle[first]] + high[first:last + 1] + [middle[last]] \
                + low[first:last + 1][::-1]
        for i in rim:
            self._follow_arm(i)
        return rim

    def _follow_arm(self, i):
        z, shoulder = self.surface.positions[i][2], self.body.shoulder[2]
        size = self.body.size
        share = .42 if z > shoulder + .012 * size else .30 if z > shoulder - .06 * size else .16
        self.surface.weights[i] = blend(self.surface.weights[i], "upperarm_L", share)
