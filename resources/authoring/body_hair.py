# SPDX-License-Identifier: MIT
"""Hair: a shell over the head with a freely placed edge, hanging below it for the bob."""
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
    quiff: float


STYLES = {
    "short": Style((6.02, 5.92, 5.25, 3.75, 3.55, 2.0, 1.75), (), .006, .022, .026, .018),
    "bob": Style((5.96, 5.8, 4.7, None, None, None, None),
                 ((.300, -.120, .07), (.345, .120, .00), (.235, .340, -.07), (0, .395, -.09)),
                 .010, .028, .024, .012),
}
SEGMENTS = (4, 3, 2, 1)
HANGING_ROWS = ((3.4, 5.3), (3.6,), (3.6,), ())
FULLNESS = .030  # of the hanging hair, half-way down
SHELL_END = 7.0


class HairShell:
    def __init__(self, surface, body, detail, shape):
        self.surface, self.body, self.detail, self.shape = surface, body, detail, shape
        self.style = STYLES[body.hair]
        self.centre = shape.absolute(0, .03, .55)
        self.columns = detail.head_columns
        self.u = column_u(self.columns)

    def add(self):
        columns = [self._add_column(c) for c in self.columns]
        count = len(columns[0])
        for row in range(count - 1):
            self.surface.band([c[row] for c in columns], [c[row + 1] for c in columns], "hair",
                              self.u, (.15 + .7 * row / count, .15 + .7 * (row + 1) / count),
                              mirrors_uv=True)
        top = self.surface.add(self.shape.grid(TOP, 0) + vec(0, 0, self.style.top), {"head": 1})
        if self.detail.level < 2:
            self._round_off(columns, top)
        self.surface.band([c[-1] for c in columns], [top] * len(columns), "hair", self.u,
                          (.85, 1), mirrors_uv=True)
        if self.detail.is_finest:
            self._add_rim([c[0] for c in columns])

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
        crown = self._on_shell(column, SHELL_END, self.style.thickness * 1.05)
        if column <= 1:
            crown = crown + vec(0, -self.style.quiff * .6, self.style.quiff * .6)
        return [self.surface.add(p, w) for p, w in points + [(crown, {"head": 1})]]

    def _lying(self, column):
        style, segments = self.style, SEGMENTS[self.detail.level]
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

    def _hanging(self, column):
        end = self.shape.absolute(*self.style.hang[column - SIDE])
        points = [(end, {"head": .9, "neck": .1})]
        rows = HANGING_ROWS[self.detail.level]
        if self.detail.level < 2:
            middle = lerp(end, self._on_shell(column, rows[0], self.style.thickness), .45)
            outwards = (middle - self.centre) * vec(0 if column == BACK else 1, 1, 0)
            points.append((middle + unit(outwards) * FULLNESS, {"head": 1}))
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
