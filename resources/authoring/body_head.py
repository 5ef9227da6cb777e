# SPDX-License-Identifier: MIT
"""Head, neck and ears. HEAD_SHAPE is a grid of points in head sizes: rows from the throat up to
the crown, columns from the front middle over the left side to the back middle."""
import math

from body_detail import chart_v, trunk_angles
from body_trunk import trunk_weights
from geometry import lerp, vec

HEAD_SHAPE = (
    ((0, -.15, .00), (.075, -.14, .00), (.160, -.08, .02), (.215, .06, .06), (.20, .16, .08),
     (.125, .250, .08), (0, .275, .08)),
    ((0, -.422, .040), (.10, -.390, .045), (.205, -.24, .105), (.268, -.02, .215),
     (.255, .14, .20), (.165, .275, .18), (0, .315, .18)),
    ((0, -.447, .190), (.125, -.398, .190), (.248, -.255, .225), (.312, -.02, .31),
     (.305, .17, .30), (.205, .335, .28), (0, .385, .28)),
    ((0, -.502, .340), (.085, -.424, .335), (.268, -.285, .375), (.330, -.02, .44),
     (.325, .20, .41), (.225, .38, .39), (0, .435, .39)),
    ((0, -.418, .500), (.120, -.388, .495), (.275, -.280, .500), (.336, -.02, .54),
     (.332, .21, .53), (.232, .405, .51), (0, .460, .51)),
    ((0, -.432, .610), (.125, -.416, .612), (.280, -.288, .615), (.338, -.01, .64),
     (.336, .215, .64), (.232, .41, .64), (0, .468, .64)),
    ((0, -.395, .780), (.125, -.378, .780), (.265, -.255, .785), (.318, .00, .795),
     (.312, .205, .795), (.212, .38, .785), (0, .435, .785)),
    ((0, -.258, .910), (.094, -.240, .910), (.190, -.155, .910), (.232, .02, .912),
     (.222, .170, .904), (.144, .288, .892), (0, .324, .888)),
    ((0, .03, .988),) * 7,
)
THROAT, JAW, MOUTH, NOSE, BROW, CROWN, TOP = 0, 1, 2, 3, 5, 6, 8
SIDE, BACK = 3, 6
COLUMN_U = (0, .090, .200, .310, .380, .440, .5)  # from the middle of the texture
FORWARD = -.004


def column_u(columns):
    return [.5 + COLUMN_U[c] for c in columns]


class HeadShape:
    """Points on the head of one body, between grid rows too."""

    def __init__(self, body, detail):
        self.head = body.head
        self.widen = {4: 1.06, 3: 1.06}.get(len(detail.head_columns), 1.0)

    def absolute(self, x, y, z):
        head = self.head
        return vec(x * head.size * head.width, y * head.size * head.depth + FORWARD,
                   z * head.size + head.chin_z)

    def grid(self, row, column):
        x, y, z = HEAD_SHAPE[row][column]
        jaw = self.head.jaw
        narrow = jaw if row in (JAW, MOUTH) else (1 + jaw) / 2 if row == NOSE else 1
        if column < SIDE and row in (JAW, MOUTH):
            y *= lerp(1, jaw, .35)
        if row == NOSE and column == 0 and jaw < .95:
            y *= .97
        return self.absolute(x * narrow * self.widen, y, z)

    def between(self, row, column):
        row = max(0, min(TOP - .001, row))
        below = int(row)
        return lerp(self.grid(below, column), self.grid(below + 1, column), row - below)

    def v(self, z):
        return chart_v("head", .08 + .92 * (z - self.head.chin_z) / self.head.size)


def _is_under_hair(hairline, low, high, left, right, is_coarsest):
    """Whether nobody sees this face. hairline: its row per column, None where hair hangs."""
    if high < CROWN or (high == CROWN and left < SIDE):
        return False
    if is_coarsest:
        return left >= SIDE  # at the front the face goes on up to the top
    ends = [hairline[c] for c in (left, right) if hairline[c] is not None]
    return not ends or max(ends) <= low


def add_head(surface, body, detail, trunk, hairline, has_ears):
    """hairline: the lower edge of the hair as Style.edge has it, None for a bald head."""
    shape = HeadShape(body, detail)
    ids = {}

    def vertex(row, column):
        key = (row, 0 if row == TOP else column)
        if key not in ids:
            point = shape.grid(row, column)
            ids[key] = surface.add(point, trunk_weights(body, point) if row == THROAT
                                   else {"head": 1})
        return ids[key]

    rows, columns = detail.head_rows, detail.head_columns
    for low, high in zip(rows[:-1], rows[1:]):
        for left, right in zip(columns[:-1], columns[1:]):
            if hairline and _is_under_hair(hairline, low, high, left, right, detail.level == 3):
                continue
            corners = ((low, left), (low, right), (high, right), (high, left))
            surface.face([vertex(*c) for c in corners], "skin",
                         [(.5 + COLUMN_U[c], shape.v(shape.grid(r, c)[2])) for r, c in corners],
                         True)
    _add_neck(surface, body, detail, trunk, [vertex(rows[0], c) for c in columns])
    if has_ears and detail.level <= 1:
        _add_ear(surface, body, detail, shape)
    return shape


def _add_neck(surface, body, detail, trunk, jaw):
    u = column_u(detail.head_columns)
    v = chart_v("head", 0), chart_v("head", .08)
    collar = trunk.rings["collar"]
    if detail.level == 3:
        surface.band(collar, jaw, "skin", u, v, mirrors_uv=True)
        return
    angles = trunk_angles(detail)
    radius = body.neck * detail.inflation
    points = []
    for i, column in enumerate(detail.head_columns):
        angle = angles[i] if len(angles) == len(jaw) else math.pi * column / 6
        x = 0 if column in (0, BACK) else radius * math.sin(angle)
        points.append(vec(x, .018 - radius * math.cos(angle),
                          body.trunk["collar"].z - .016 * math.cos(angle) - .006))
    neck = surface.add_ring(points, lambda p: trunk_weights(body, p))
    surface.band(neck, jaw, "skin", u, v, mirrors_uv=True)
    top = trunk.v(body.trunk["collar"].z)
    surface.band(collar, neck, "top" if detail.is_finest else "skin", trunk.u, (top, top),
                 mirrors_uv=True)


def _add_ear(surface, body, detail, shape):
    top, low = shape.between(4.30, SIDE) + vec(-.004, 0, 0), \
        shape.between(2.85, SIDE) + vec(-.004, .004, 0)
    size = body.head.size / .24
    places = (top, low, top + vec(.024, .040, .010) * size, low + vec(.014, .026, .004) * size,
              top + vec(-.002, .044, .004) * size, low + vec(-.004, .032, 0) * size)
    e = [surface.add(p, {"head": 1}) for p in places]
    high, bottom = ((.5 + COLUMN_U[SIDE], shape.v(p[2])) for p in (top, low))
    surface.face((e[0], e[1], e[3], e[2]), "skin", (high, bottom, bottom, high), True)
    if detail.is_finest:
        surface.face((e[2], e[3], e[5], e[4]), "skin", (high, bottom, bottom, high), True)
        surface.face((e[0], e[2], e[4]), "skin", (high,) * 3, True)
        surface.face((e[1], e[5], e[3]), "skin", (bottom,) * 3, True)
