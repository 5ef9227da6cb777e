# SPDX-License-Identifier: MIT
"""Trouser legs and shoes."""
import math

import numpy as np

from body_detail import chart_u, chart_v
from geometry import lerp, smoothstep, vec

# Kind of legs -> tubes: slot, from, to, ease over the skin, flare below the knee.
LEG_TUBES = {
    "trousers": (("bottom", "crotch", "hem", .010, .014),),
    "shorts": (("bottom", "crotch", "above knee", .016, 0),
               ("skin", "under shorts", "shoe", -.002, 0)),
    "under coat": (("bottom", "under skirt", "hem", .010, .014),),
    "bare": (("skin", "under skirt", "shoe", -.002, 0),),
    "leggings": (("bottom", "under skirt", "shoe", .002, 0),)}
LEG_GROWTH = {8: 1, 6: 1.03, 5: 1.07, 4: 1.15}
SHOE_GROWTH = {8: 1, 6: 1.04, 5: 1.08}
# Outlines of the shoe by angle, (x, y) in shoe sizes: the sole and the opening at the ankle.
SOLE = {-42: (-.031, -.168), 5: (.002, -.196), 47: (.041, -.150), 90: (.043, -.062),
        133: (.031, .048), 175: (.002, .074), 222: (-.027, .052), 270: (-.034, -.062)}
OPENING = {-42: (-.027, -.048), 5: (.001, -.066), 47: (.031, -.044), 90: (.041, -.004),
           133: (.030, .050), 175: (.001, .068), 222: (-.027, .052), 270: (-.035, -.004)}
SOLE_FACES = {8: ((0, 2, 1), (0, 7, 3, 2), (7, 6, 4, 3), (6, 5, 4)),
              6: ((0, 2, 1), (0, 5, 2), (5, 3, 2), (5, 4, 3)), 5: ((0, 2, 1), (0, 4, 2), (4, 3, 2))}


class Leg:
    def __init__(self, surface, body, detail, trunk):
        self.surface, self.body, self.detail, self.trunk = surface, body, detail, trunk
        self.angles = detail.leg_angles
        self.u = [i / len(self.angles) for i in range(len(self.angles) + 1)]
        self.s = s = body.size
        hip, knee, ankle = body.hip[2], body.knee[2], body.ankle[2]
        self.profile = (  # height, radius to the side, front, back
            (hip - .03 * s, .074, .086, .098), (hip - .14 * s, .069, .082, .097),
            (hip - .26 * s, .061, .070, .074), (knee + .06 * s, .056, .060, .054),
            (knee, .052, .056, .050), (knee - .06 * s, .049, .047, .058),
            (knee - .14 * s, .050, .044, .064), (knee - .24 * s, .040, .037, .044),
            (ankle + .03 * s, .033, .034, .036))
        self.places = {"crotch": body.trunk["crotch"].z, "above knee": knee + .050 * s,
                       "under shorts": knee + .095 * s, "under skirt": hip - .170 * s,
                       "hem": (.060, .055, .055, .030)[detail.level],
                       "shoe": ankle + .012}
        if detail.level == 3:
            self.places.update({"above knee": knee, "under shorts": knee})
        if body.skirt and detail.level > 0:  # legs would show through so few triangles of cloth
            top = body.skirt.bottom_z + (0, .15, .10, .06)[detail.level] * s
            if detail.level == 1:
                top = max(top, knee + .10 * s)  # robes are seen to bend at the knees
            self.places["under skirt"] = min(self.places["under skirt"], top)
        bare = (knee + .050 * s, knee - .025 * s, knee - .13 * s)
        self.bends = (bare if body.legs in ("bare", "leggings", "shorts", "under coat") else
                      (hip - .150 * s, knee + .060 * s, knee - .005 * s, knee - .06 * s,
                       knee - .17 * s),
                      (hip - .13 * s, hip - .25 * s, knee + .045 * s, knee - .045 * s,
                       knee - .17 * s), (hip - .15 * s, knee), (knee,))[detail.level]

    def add(self):
        for tube in LEG_TUBES[self.body.legs]:
            self._add_tube(*tube)
        self._add_shoe()

    def centre(self, z):
        hip, knee, ankle = self.body.hip, self.body.knee, self.body.ankle
        if z >= knee[2]:
            return lerp(knee, hip, (z - knee[2]) / (hip[2] - knee[2]))
        return lerp(ankle, knee, (z - ankle[2]) / (knee[2] - ankle[2]))

    def weights(self, point):
        z, hip, knee, ankle = point[2], self.body.hip[2], self.body.knee[2], self.body.ankle[2]
        s = self.s
        shin = 1 - smoothstep(z, knee - .055 * s, knee + .055 * s)
        hips = smoothstep(z, hip - .16 * s, hip - .02 * s) * .5
        foot = 1 - smoothstep(z, ankle - .03 * s, ankle + .03 * s)
        return {"hips": hips, "thigh_L": (1 - hips) * (1 - shin), "shin_L": shin * (1 - foot),
                "foot_L": shin * foot}

    def radii(self, z):
        girth = self.body.leg_girth
        for above, below in zip(self.profile[:-1], self.profile[1:]):
            if z >= below[0]:
                s = max(0, min(1, (z - below[0]) / (above[0] - below[0])))
                return [lerp(below[i], above[i], s) * girth for i in (1, 2, 3)]
        return [r * girth for r in self.profile[-1][1:]]

    def ring(self, z, ease):
        centre, growth = self.centre(z), LEG_GROWTH[len(self.angles)]
        side, front, back = (r + ease for r in self.radii(z))
        inner = min(1, (centre[0] - .004) / (side * growth))  # keep off the other leg
        points = []
        for degrees in self.angles:
            sine, cosine = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
            depth = front if cosine > 0 else back
            points.append(centre + vec(side * growth * sine * (1 if sine > 0 else inner),
                                       -depth * growth * cosine, 0))
        return self.surface.add_ring(points, self.weights)

    def _add_tube(self, slot, start, end, ease, flare):
        s, knee = self.s, self.body.knee[2]
        top, low = self.places[start], self.places[end]
        margin = .03 * s
        heights = [top] + [z for z in self.bends if low + margin < z < top - margin] + [low]
        rings = []
        for z in heights:
            loose = ease + flare * max(0, knee - z) / knee
            rings.append(self._crotch_ring(top) if start == "crotch" and not rings else
                         self.ring(z, loose * s + (.006 if self.detail.level == 3 else 0)))
        if start == "crotch":
            first = rings[0]
            self.surface.sharp += [(first[0], rings[1][0]), (first[-2], rings[1][-2]),
                                   (first[0], first[-1]), (first[-2], first[-1])]
        is_bare = slot == "skin"
        u = [chart_u("arm", x) for x in self.u] if is_bare else self.u
        total = self.places["crotch"]
        for k in range(len(rings) - 1):
            v = .78 * heights[k + 1] / total, .78 * heights[k] / total
            v = tuple(chart_v("arm", x) for x in v) if is_bare else v
            self.surface.band(rings[k + 1], rings[k], slot, u, v, closed=True)
        if self.detail.is_finest and end != "shoe":
            lining = self.ring(heights[-1] + .008, (ease - .012) * s)
            self.surface.band(lining, rings[-1], slot, self.u, (0, 0), closed=True)

    def _crotch_ring(self, top):
        crotch = self.surface.add(vec(0, .014, top - .070 * self.s), {"hips": .7, "thigh_L": .3})
        return self.trunk.rings["crotch"] + [crotch]

    def _shoe_weights(self, point):
        size = self.body.foot
        toe = smoothstep(-point[1], .055 * size, .125 * size)
        return {"foot_L": 1 - toe, "toe_L": toe}

    def _outline(self, outline, scale, height_at):
        """height_at: of y in shoe sizes."""
        size, growth = self.body.foot, SHOE_GROWTH[len(self.angles)]
        points = []
        for degrees in self.angles:
            x, y = _on_outline(outline, degrees)
            points.append(vec(self.body.ankle[0] + .002 + x * scale * size * growth,
                              y * scale * size, height_at(y * scale) * size))
        return points

    def _shoe_rows(self):
        """Rings of ids, the ankle first, the sole last."""
        level, add = self.detail.level, self.surface.add_ring
        rows = []
        if level == 0:
            rows.append(add(self._ankle_points(), lambda p: {"shin_L": .6, "foot_L": .4}))
        rows.append(add(self._outline(OPENING, 1.0 if level < 2 else .9, lambda y: .092),
                        lambda p: {"foot_L": 1}))
        if level <= 1:
            rows.append(add(self._outline(
                SOLE, 1.0, lambda y: .050 - .012 * min(1, max(0, (-.1 - y) / .09))),
                self._shoe_weights))
        rows.append(add(self._outline(SOLE, .985, lambda y: 0 if y > -.15 else .004),
                        self._shoe_weights))
        return rows

    def _ankle_points(self):
        ankle, girth = self.body.ankle, self.body.leg_girth
        turns = [math.radians(a) for a in self.angles]
        return [vec(ankle[0] + .041 * girth * math.sin(t), ankle[1] - .043 * girth * math.cos(t)
                    - .002, ankle[2] + .042) for t in turns]

    def _add_wedge(self):
        """Coarsest shoe: a heel and a toe."""
        size, x = self.body.foot, self.body.ankle[0] + .002
        places = (vec(x, -.02 * size, .10), vec(x + .050 * size, .02 * size, 0),
                  vec(x - .045 * size, .02 * size, 0), vec(x, -.19 * size, 0))
        top, left, right, toe = self.surface.add_ring(places, self._shoe_weights)
        for ids in ((top, toe, left), (top, right, toe), (top, left, right)):
            self.surface.face(ids, "shoes", [(.5, .6), (.5, .1), (.5, .1)])

    def _add_shoe(self):
        if self.detail.level == 3:
            self._add_wedge()
            return
        rows = self._shoe_rows()
        height = [min(1, float(np.mean([self.surface.positions[i][2] for i in row]))
                      / (.13 * self.body.foot)) for row in rows]
        for k in range(len(rows) - 1):
            self.surface.band(rows[k + 1], rows[k], "shoes", self.u, (height[k + 1], height[k]),
                              closed=True)
        for face in SOLE_FACES[len(self.angles)]:
            self.surface.face([rows[-1][i] for i in face], "shoes", [(.5, .02)] * len(face))


def _on_outline(outline, degrees):
    """Linear between the given angles, which wrap round."""
    angles = sorted(outline)
    degrees = degrees if degrees >= angles[0] else degrees + 360
    for a, b in zip(angles, angles[1:] + [angles[0] + 360]):
        if a <= degrees <= b:
            t = (degrees - a) / (b - a)
            p, q = outline[a], outline[b if b in outline else b - 360]
            return lerp(p[0], q[0], t), lerp(p[1], q[1], t)
    raise ValueError(f"{degrees} degrees lie outside the outline")
