# SPDX-License-Identifier: MIT
"""Hair: a shell over the head with a freely placed edge, hanging below it for longer hair."""
import math
from dataclasses import dataclass

import numpy as np

from body_head import BACK, SIDE, TOP, column_u
from geometry import lerp, smoothstep, unit, vec


@dataclass(frozen=True)
class Style:
    edge: tuple       # row of the hairline per column; None hangs
    hang: tuple       # lower end of the hanging columns, in head sizes
    edge_thickness: float
    thickness: float
    top: float
    quiff: float = 0.0
    fullness: float = .030     # of hanging hair, half-way down
    tail: str = ""             # "ponytail", "pigtails" or "bun"
    has_ears: bool = True
    is_bald: bool = False      # a wreath of hair below END_OF_WREATH
    low: dict = None           # weights of the hanging ends


SHORT = (6.02, 5.92, 5.25, 3.75, 3.55, 2.0, 1.75)
SWEPT = (6.10, 6.00, 5.40, 4.30, 3.20, 1.9, 1.60)
STYLES = {
    "short": Style(SHORT, (), .006, .022, .026, .018),
    "crop": Style((6.35, 6.20, 5.55, 4.00, 3.70, 2.2, 1.9), (), .004, .011, .012),
    "curly": Style((6.00, 5.85, 5.15, 3.85, 3.45, 1.9, 1.6), (), .008, .036, .052, .026),
    "bald": Style((0, 0, 5.20, 3.80, 3.40, 2.0, 1.75), (), .005, .016, 0, is_bald=True),
    "bob": Style((5.96, 5.8, 4.7, None, None, None, None),
                 ((.300, -.120, .07), (.345, .120, .00), (.235, .340, -.07), (0, .395, -.09)),
                 .010, .028, .024, .012, has_ears=False),
    "long": Style((6.15, 5.75, 4.6, None, None, None, None),
                  ((.250, -.060, -.36), (.330, .210, -.46), (.240, .440, -.62), (0, .520, -.66)),
                  .010, .028, .026, .012, fullness=.014, has_ears=False,
                  low={"head": .45, "neck": .25, "chest": .30}),
    "ponytail": Style(SWEPT, (), .004, .016, .018, .006, tail="ponytail"),
    "pigtails": Style((5.70, 5.60, 5.00, 4.20, 3.20, 1.9, 1.6), (), .006, .020, .022, .004,
                      tail="pigtails"),
    "gathered": Style(SWEPT, (), .004, .020, .022, .008),
    "bun": Style(SWEPT, (), .004, .020, .022, .008, tail="bun"),
}
SEGMENTS = (4, 3, 2, 1)
HANGING_ROWS = ((3.4, 5.3), (3.6,), (3.6,), ())
SHELL_END = 7.0
END_OF_WREATH = (0, 0, 5.45, 5.60, 5.80, 5.95, 6.0)
TAIL_SIDES = (4, 4, 4, 3)


class HairShell:
    def __init__(self, surface, body, detail, shape):
        self.surface, self.body, self.detail, self.shape = surface, body, detail, shape
        self.style = STYLES[body.hair]
        self.centre = shape.absolute(0, .03, .55)
        self.columns = [c for c in detail.head_columns if not self.style.is_bald or c >= 2]
        self.u = column_u(self.columns)

    def add(self):
        columns = [self._add_column(c) for c in self.columns]
        count = len(columns[0])
        for row in range(count - 1):
            self.surface.band([c[row] for c in columns], [c[row + 1] for c in columns], "hair",
                              self.u, (.15 + .7 * row / count, .15 + .7 * (row + 1) / count),
                              mirrors_uv=True)
        if not self.style.is_bald:
            self._add_crown(columns)
            if self.detail.is_finest:
                self._add_rim([c[0] for c in columns])
        if self.style.tail:
            getattr(self, "_add_" + self.style.tail)()

    def _add_crown(self, columns):
        top = self.surface.add(self.shape.grid(TOP, 0) + vec(0, 0, self.style.top), {"head": 1})
        if self.detail.level < 2:
            self._round_off(columns, top)
        self.surface.band([c[-1] for c in columns], [top] * len(columns), "hair", self.u,
                          (.85, 1), mirrors_uv=True)

    def _round_off(self, columns, top):
        """One more ring between the shell and the crown's middle."""
        peak, ring = self.surface.positions[top], []
        for column in columns:
            point = lerp(self.surface.positions[column[-1]], peak, .52)
            point[2] = lerp(self.surface.positions[column[-1]][2], peak[2], .84)
            ring.append(self.surface.add(point, {"head": 1}))
        self.surface.band([c[-1] for c in columns], ring, "hair", self.u, (.85, .93),
                          mirrors_uv=True)
        for column, i in zip(columns, ring):
            column.append(i)

    def _on_shell(self, column, row, thickness):
        point = self.shape.between(row, column)
        outwards = point - self.centre
        if point[2] < self.centre[2]:
            outwards[2] *= .15
        point = point + outwards / np.linalg.norm(outwards) * thickness
        if column in (0, BACK):
            point[0] = 0
        return point

    def _add_column(self, column):
        hangs = self.style.edge[column] is None
        points = self._hanging(column) if hangs else self._lying(column)
        if not self.style.is_bald:
            crown = self._on_shell(column, SHELL_END, self.style.thickness * 1.05)
            if column <= 1:
                crown = crown + vec(0, -self.style.quiff * .6, self.style.quiff * .6)
            points.append((crown, {"head": 1}))
        return [self.surface.add(p, w) for p, w in points]

    def _lying(self, column):
        style, segments = self.style, SEGMENTS[self.detail.level]
        if style.is_bald:
            return self._wreath(column)
        inner = style.edge_thickness * (1 if self.detail.is_finest else .6)
        points = []
        for k in range(segments):
            t = k / segments
            thickness = lerp(inner, style.thickness, smoothstep(t, 0, .8))
            if column < SIDE and k > 0:
                thickness += style.quiff * (1 - column / 3) * t
            thickness += .008 if self.detail.level == 3 else 0
            points.append((self._on_shell(column, lerp(style.edge[column], SHELL_END, t),
                                          thickness), {"head": 1}))
        return points

    def _wreath(self, column):
        style, end = self.style, END_OF_WREATH[column]
        steps = ((0, 1), (.5, 0), (1, -1)) if self.detail.level < 3 else ((0, 0), (1, -1))
        thickness = {1: style.edge_thickness, 0: style.thickness, -1: -.003}
        return [(self._on_shell(column, lerp(style.edge[column], end, t), thickness[kind]),
                 {"head": 1}) for t, kind in steps]

    def _hanging(self, column):
        end = self.shape.absolute(*self.style.hang[column - SIDE])
        points = [(end, self.style.low or {"head": .9, "neck": .1})]
        rows = HANGING_ROWS[self.detail.level]
        if self.detail.level < 2:
            middle = lerp(end, self._on_shell(column, rows[0], self.style.thickness), .45)
            outwards = (middle - self.centre) * vec(0 if column == BACK else 1, 1, 0)
            weights = {"head": .85, "chest": .15} if self.style.low else {"head": 1}
            points.append((middle + unit(outwards) * self.style.fullness, weights))
        for row in rows:
            points.append((self._on_shell(column, row, self.style.thickness), {"head": 1}))
        return points

    def _add_rim(self, edge):
        """Tucks the edge in, so that the shell looks solid."""
        inner = []
        for i, column in zip(edge, self.columns):
            if self.style.edge[column] is not None:
                point = self._on_shell(column, self.style.edge[column] + .12, -.006)
            else:
                point = self.surface.positions[i]
                point = point - (point - vec(0, self.centre[1] + .01, point[2])) * .30 \
                    + vec(0, 0, .012)
                point[0] = 0 if column == BACK else point[0]
            inner.append(self.surface.add(point, self.surface.weights[i]))
        self.surface.band(inner, edge, "hair", self.u, (0, .12), mirrors_uv=True)
        if self.style.edge[BACK] is None:
            self._add_inner_wall(inner)

    def _add_inner_wall(self, inner):
        hanging = [i for i, c in enumerate(self.columns) if c >= SIDE]
        upper = []
        for i in hanging:
            point = self.shape.grid(1, self.columns[i])
            point = point + (point - vec(0, self.centre[1] + .01, point[2])) * .04
            point[0] = 0 if self.columns[i] == BACK else point[0]
            upper.append(self.surface.add(point, {"head": 1}))
        self.surface.band(upper, [inner[i] for i in hanging], "hair",
                          [self.u[i] for i in hanging], (0, 0), mirrors_uv=True)

    def _add_ponytail(self):
        """Along the middle plane, from the back of the head down."""
        places = ((.440, .70, .050, 1), (.560, .66, .085, 1), (.600, .42, .105, 1),
                  (.560, .10, .080, .8), (.520, -.16, .012, .6))
        self._add_half_tube(places if self.detail.level < 2 else places[::2])

    def _add_bun(self):
        places = ((.400, .80, .085, 1), (.500, .83, .165, 1), (.610, .74, .165, 1),
                  (.660, .66, .060, 1))
        self._add_half_tube(places if self.detail.level < 2 else places[1::2])

    def _add_half_tube(self, places):
        """(y, z, radius, share of the head) in head sizes; closed at the end."""
        rings = []
        for y, z, radius, share in places:
            centre = self.shape.absolute(0, y, z)
            radius *= self.body.head.size
            weights = {"head": share, "neck": (1 - share) * .5, "chest": (1 - share) * .5}
            turns = (0, 60, 120, 180) if self.detail.is_finest else (0, 90, 180)
            down = unit(vec(0, .45, -1)) if self.style.tail == "ponytail" else vec(0, 1, -.35)
            across = unit(np.cross(vec(1, 0, 0), down))
            rings.append([self.surface.add(
                centre + vec(radius * math.sin(math.radians(a)) if 0 < a < 180 else 0, 0, 0)
                - across * radius * math.cos(math.radians(a)), weights) for a in turns])
        u = [i / (len(rings[0]) - 1) for i in range(len(rings[0]))]
        for k, (upper, lower) in enumerate(zip(rings[:-1], rings[1:])):
            self.surface.band(lower, upper, "hair", u, (.9 - .2 * k, 1 - .2 * k),
                              mirrors_uv=True)
        tip = rings[-1]
        for k in range(1, len(tip) - 1):
            self.surface.face((tip[0], tip[k + 1], tip[k]), "hair", [(.5, .1)] * 3, True)

    def _add_pigtails(self):
        """One at each side; it is mirrored."""
        places = ((.300, .20, .60, .050), (.420, .26, .56, .105), (.470, .27, .30, .110),
                  (.450, .24, .02, .070), (.430, .22, -.12, .010))
        if self.detail.level >= 2:
            places = places[::2] if self.detail.level == 2 else (places[1], places[4])
        sides = TAIL_SIDES[self.detail.level] - 1 if self.detail.level < 3 else 3
        rings = []
        for x, y, z, radius in places:
            centre, radius = self.shape.absolute(x, y, z), radius * self.body.head.size
            turns = [2 * math.pi * i / sides for i in range(sides)]
            rings.append([self.surface.add(
                centre + vec(math.cos(t), math.sin(t), 0) * radius, {"head": 1}) for t in turns])
        u = [i / sides for i in range(sides + 1)]
        for k in range(len(rings) - 1):
            self.surface.band(rings[k], rings[k + 1], "hair", u, (1 - .2 * k, .8 - .2 * k),
                              closed=True, inside_out=True)
