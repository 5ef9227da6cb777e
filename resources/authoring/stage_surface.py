# SPDX-License-Identifier: MIT
"""Collects the faces of a stage: boxes, swept arcs, turned shapes. Metres, Z up."""
import math

import numpy as np

MATERIALS = {  # 0..255 sRGB; weathered limestone and earth
    "stone": (206, 192, 164), "stone_dark": (176, 161, 134), "marble": (222, 216, 202),
    "roof": (182, 108, 78), "earth": (178, 164, 122), "leaf": (66, 96, 62),
    "trunk": (98, 78, 60), "sand": (206, 188, 150), "pine": (92, 118, 70),
    "hill": (124, 138, 96), "hill_far": (142, 158, 156), "banner": (164, 48, 44),
    "banner_light": (222, 178, 86)}
ROUNDED = ("leaf", "trunk", "pine", "hill", "hill_far")

TIP = .02  # metres; a thinner end of a lathe shape is a point


def polar(radius, angle, z):
    """Angle 0 is the middle of the audience (+Y), growing towards +X."""
    return (radius * math.sin(angle), radius * math.cos(angle), z)


class StageSurface:
    def __init__(self, seed, materials=MATERIALS):
        self.palette = materials
        self.vertices, self.faces, self.materials, self.tones = [], [], [], []
        self._random = np.random.default_rng(seed)

    def point(self, x, y, z):
        self.vertices.append((x, y, z))
        return len(self.vertices) - 1

    def points(self, places):
        return [self.point(*place) for place in places]

    def tone(self, spread=.05):
        """Brightness of one block of stone."""
        return round(1 - spread + 2 * spread * float(self._random.random()), 3)

    def face(self, ids, material, tone=None):
        self.faces.append(tuple(ids))
        self.materials.append(list(self.palette).index(material))
        self.tones.append(self.tone() if tone is None else tone)

    def arc(self, profile, start, end, segments, materials):
        """Sweeps (radius, z) points, listed from the inside outwards and up, around the centre.
        Earth and sand stay even, blocks of stone vary."""
        steps = [start + (end - start) * i / segments for i in range(segments + 1)]
        rows = [self.points(polar(r, a, z) for a in steps) for r, z in profile]
        for k, material in enumerate(materials):
            for i in range(segments):
                self.face((rows[k][i], rows[k][i + 1], rows[k + 1][i + 1], rows[k + 1][i]),
                          material, 1.0 if material in ("earth", "sand") else None)

    def box(self, low, high, material, bottom=False, without=None):
        """without: a side that nobody sees; 0 looks along -Y, 1 +X, 2 +Y, 3 -X."""
        (x0, y0, z0), (x1, y1, z1) = low, high
        p = self.points((x, y, z) for z in (z0, z1)
                        for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1)))
        sides = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7)]
        tone = self.tone()
        for k, side in enumerate(sides + ([(3, 2, 1, 0)] if bottom else [])):
            if k != without:
                self.face([p[i] for i in side], material, tone)

    def turned(self, x, y, profile, sides, material):
        """A lathe shape around a vertical axis from (radius, z) points, bottom first. Where it ends
        in the axis, a triangle a side does."""
        turns = [2 * math.pi * i / sides for i in range(sides)]
        radii = [0 if radius <= TIP else radius for radius, _ in profile]
        rows = [self.points((x + r * math.cos(a), y + r * math.sin(a), z) for a in turns)
                for r, (_, z) in zip(radii, profile)]
        tone = self.tone()
        for below, above, radius in zip(rows[:-1], rows[1:], radii[1:]):
            for i in range(sides):
                j = (i + 1) % sides
                corners = (below[i], below[j], above[j], above[i])
                self.face(corners if radius else corners[:3], material, tone)

    def prism(self, outline, other, sides_material, cap_material, flip):
        """Two equal outlines joined by quads, both ends closed by fans."""
        a, b = self.points(outline), self.points(other)
        turn = (lambda ids: ids) if not flip else (lambda ids: tuple(reversed(ids)))
        for k in range(1, len(a) - 1):
            self.face(turn((a[0], a[k + 1], a[k])), cap_material, 1.0)
            self.face(turn((b[0], b[k], b[k + 1])), cap_material, 1.0)
        for k in range(len(a) - 1):
            self.face(turn((a[k], a[k + 1], b[k + 1], b[k])), sides_material)

    def triangle_count(self):
        return sum(len(face) - 2 for face in self.faces)
