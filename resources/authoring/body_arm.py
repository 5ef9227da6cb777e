# SPDX-License-Identifier: MIT
"""Sleeve, bare arm, hand and thumb, lofted along the arm (distance from the shoulder joint)."""
import math

import numpy as np

from body_detail import chart_u, chart_v
from geometry import lerp, smoothstep, unit, vec

RING_TURN = {8: 0, 6: 30, 5: 18, 4: 45, 3: 90}  # degrees, so that rings meet the arm hole
RING_GROWTH = {8: 1, 6: 1.03, 5: 1.05, 4: 1.1, 3: 1.2}
EASE = .007  # of the sleeve over the arm


class Arm:
    def __init__(self, surface, body, detail, trunk):
        self.surface, self.body, self.detail, self.rim = surface, body, detail, trunk.arm_hole
        angle = math.radians(body.arm_angle)
        self.along, self.forward = vec(math.cos(angle), 0, -math.sin(angle)), vec(0, -1, 0)
        self.up = vec(math.sin(angle), 0, math.cos(angle))
        self.elbow, self.wrist = body.upper_arm, body.upper_arm + body.forearm
        self.s = s = body.size
        self.profile = ((0, .056, .066), (.06 * s, .056, .062), (.16 * s, .047, .050),
                        (self.elbow - .03 * s, .039, .040), (self.elbow, .038, .039),
                        (self.elbow + .06 * s, .041, .040), (self.elbow + .12 * s, .037, .035),
                        (self.wrist - .02 * s, .027, .023), (self.wrist, .026, .021))

    def add(self):
        if self.detail.level == 3:
            self._add_prism()
            return
        self._add_sleeve()
        self._add_bare_arm()
        if self.detail.level <= 1:
            self._add_thumb()

    def centre(self, t):
        point = self.body.shoulder + self.along * t
        if t > self.elbow:
            point = point + self.forward * (t - self.elbow) * math.sin(math.radians(8))
        return point

    def weights(self, t, point):
        s = self.s
        elbow = smoothstep(t, self.elbow - .045 * s, self.elbow + .045 * s)
        wrist = smoothstep(t, self.wrist - .022 * s, self.wrist + .022 * s)
        root = 1 - smoothstep(t, -.02 * s, .085 * s)
        if t < .10 * s:  # the armpit side stays with the chest
            low = min(1, max(0, .5 - .5 * np.dot(point - self.centre(t), self.up) / (.05 * s)))
            low *= 1 - t / (.10 * s)
            arm = 1 - root * (.45 + .30 * low)
            return {"upperarm_L": arm, "shoulder_L": (1 - arm) * (.75 - .5 * low),
                    "chest": (1 - arm) * (.25 + .5 * low)}
        return {"upperarm_L": (1 - elbow) * (1 - root * .6),
                "shoulder_L": (1 - elbow) * root * .45, "chest": (1 - elbow) * root * .15,
                "forearm_L": elbow * (1 - wrist), "hand_L": elbow * wrist}

    def radii(self, t):
        """(forward, up) of the bare arm."""
        girth = self.body.arm_girth
        for (t0, f0, u0), (t1, f1, u1) in zip(self.profile[:-1], self.profile[1:]):
            if t <= t1:
                s = (t - t0) / (t1 - t0)
                return lerp(f0, f1, s) * girth, lerp(u0, u1, s) * girth
        return self.profile[-1][1] * girth, self.profile[-1][2] * girth

    def ring(self, t, forward, up, sides, drop=0.0):
        centre = self.centre(t) - self.up * drop
        # The armpit side of the first rings.
        flatten = lerp(.45, 1, smoothstep(t, .03 * self.s, .16 * self.s))
        ids = []
        for i in range(sides):
            turn = 2 * math.pi * i / sides + math.radians(self._turn(sides))
            lift = math.sin(turn) * (flatten if math.sin(turn) < 0 else 1)
            point = centre + (self.forward * forward * math.cos(turn) + self.up * up * lift) \
                * RING_GROWTH[sides]
            ids.append(self.surface.add(point, self.weights(t, point)))
        return ids

    def _turn(self, sides):
        if self.rim and sides == 6 and len(self.rim) != 6:
            return 0
        return RING_TURN[sides]

    def _loft(self, rings, places, slot, chart):
        s = self.s
        sides = len(rings[0])
        u = [chart_u(chart, i / sides) for i in range(sides + 1)]
        v = [chart_v(chart, 1 - max(0, t) / (self.wrist + .2 * s)) for t in places]
        for k in range(len(rings) - 1):
            self.surface.band(rings[k], rings[k + 1], slot, u, v[k:k + 2], closed=True,
                              inside_out=True)

    def _add_sleeve(self):
        end, sides, level = self.body.sleeve, len(self.rim), self.detail.level
        s = self.s
        places = [.055 * s] if level < 2 else []
        if end > .13 * s and level == 0:
            places.append(.12 * s)
        if end > self.elbow:
            places += [self.elbow - .035 * s, self.elbow + .015 * s] if level == 0 else [self.elbow]
        places.append(end)
        rings = [self.rim]
        for t in places:
            ease = EASE * s * (1.4 if t == end else 1) + self._flare(t)
            rings.append(self.ring(t, *(r + ease for r in self.radii(t)), sides))
        self._loft(rings, [places[0] - .06 * s] + places, "top", "sleeve")
        if level == 0:
            # The inner side of a wide sleeve reaches as far as one can look into it.
            deep = .13 if self.body.wide_sleeve else .012
            lining = self.ring(end - deep * s, *(r * .9 for r in self.radii(end)), sides)
            u = [chart_u("sleeve", i / sides) for i in range(sides + 1)]
            self.surface.band(rings[-1], lining, "top", u, (0, 0), closed=True, inside_out=True)

    def _flare(self, t):
        """Of a wide sleeve, growing towards its end."""
        return self.body.wide_sleeve * smoothstep(t / self.body.sleeve, .25, 1.05)

    def _bare_places(self):
        s = self.s
        start, level = max(0, self.body.sleeve - .02 * s), self.detail.level
        places = [start]
        if start < self.elbow - .04 * s:
            places += ([self.elbow - .035 * s, self.elbow + .015 * s, self.elbow + .075 * s],
                       [self.elbow - .015 * s, self.elbow + .05 * s], [self.elbow])[level]
        return places + [self.wrist - .012 * s]

    def _hand_rings(self):
        """(distance, forward, up, drop) from the wrist on."""
        shapes = (((.035, .037, .017, .002), (.100, .040, .0155, .010), (.158, .020, .010, .032)),
                  ((.065, .041, .018, .005), (.150, .026, .011, .026)),
                  ((.070, .038, .018, .008), (.150, .020, .010, .024)))
        size = self.body.hand
        return [(self.wrist + t * size, f * size, u * size, drop * size)
                for t, f, u, drop in shapes[self.detail.level]]

    def _add_bare_arm(self):
        sides, places, rings = self.detail.forearm_sides, [], []
        for t in self._bare_places():
            shrink = .95 if not rings else 1
            rings.append(self.ring(t, *(r * shrink for r in self.radii(t)), sides))
            places.append(t)
        for t, forward, up, drop in self._hand_rings():
            rings.append(self.ring(t, forward, up, sides, drop))
            places.append(t)
        self._loft(rings, places, "skin", "arm")
        uv = (chart_u("arm", .5), chart_v("arm", 0))
        for k in range(1, sides - 1):
            self.surface.face((rings[-1][0], rings[-1][k + 1], rings[-1][k]), "skin", [uv] * 3)

    def _add_thumb(self):
        size, fine = self.body.hand, self.detail.is_finest
        base = self.centre(self.wrist + .030 * size) + self.forward * .024 * size \
            - self.up * .004 * size
        out = unit(self.forward * .62 + self.along * .85 - self.up * .25)
        bent = unit(out + self.along * .6)
        side = unit(np.cross(out, self.up))
        across = np.cross(side, out)
        sides = 4 if fine else 3

        def ring(centre, radius):
            turns = [2 * math.pi * k / sides for k in range(sides)]
            return [self.surface.add(centre + (side * math.cos(a) + across * math.sin(a)) * radius,
                                     {"hand_L": 1}) for a in turns]
        root = ring(base - out * .020, .0150 * size)
        tip = self.surface.add(base + out * .022 * size + bent * .040 * size, {"hand_L": 1})
        middle = ring(base + out * .022 * size + bent * .012 * size, .0125 * size) if fine else None
        uv = (chart_u("arm", .25), chart_v("arm", .1))
        for i in range(sides):
            j = (i + 1) % sides
            if fine:
                self.surface.face((root[j], root[i], middle[i], middle[j]), "skin", [uv] * 4)
            self.surface.face(((middle or root)[j], (middle or root)[i], tip), "skin", [uv] * 3)

    def _add_prism(self):
        """Coarsest level: a three-sided arm from shoulder to hand."""
        girth = self.body.arm_girth
        wide = self._flare(self.body.sleeve) if self.body.sleeve > self.elbow else 0
        rings = [self.ring(t, f * girth, u * girth, 3, drop) for t, f, u, drop in (
            (0, .050, .034, 0), (self.elbow, .042 + .3 * wide, .042 + .3 * wide, 0),
            (self.wrist + .13 * self.body.hand, .030 + .3 * wide, .02 + .3 * wide, .02))]
        long = self.body.sleeve > self.elbow
        for k, (slot, chart) in enumerate((("top", "sleeve"),
                                           ("top", "sleeve") if long else ("skin", "arm"))):
            u = [chart_u(chart, i / 3) for i in range(4)]
            self.surface.band(rings[k], rings[k + 1], slot, u,
                              (chart_v(chart, .6), chart_v(chart, .1)), closed=True,
                              inside_out=True)
