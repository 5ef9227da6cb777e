# SPDX-License-Identifier: MIT
"""Things that a person wears and may leave at home: separate meshes that hang on one joint.

Built around that joint, in the authoring frame; at most two shapes, fine and coarse."""
import math
from dataclasses import dataclass

from geometry import vec

SLOT_OF = {"backpack": "bag", "scarf": "scarf", "sun_hat": "hat", "cap": "hat", "hat": "hat",
           "felt_cap": "hat", "toga_fold": "cloak", "veil": "cloak", "shawl": "scarf"}
JOINT_OF = {"backpack": "chest", "scarf": "neck", "sun_hat": "head", "cap": "head", "hat": "head",
            "felt_cap": "head", "toga_fold": "chest", "veil": "head", "shawl": "chest"}
SHOWN = {"backpack": False, "scarf": False, "sun_hat": False, "cap": True, "hat": True,
         "felt_cap": True, "toga_fold": True, "veil": True, "shawl": True}


@dataclass
class Shape:
    vertices: list
    faces: list


def build(name, body, joint, level):
    """The shape of one accessory at one level, relative to its joint."""
    shape = globals()["_" + name](body, level >= 2)
    return Shape([v - joint for v in shape.vertices], shape.faces)


def _lathe(rings, sides, closed_top=True):
    """Ovals (centre, x radius, y radius), from the bottom up; faces look outwards."""
    shape = Shape([], [])
    turns = [2 * math.pi * i / sides for i in range(sides)]
    for centre, rx, ry in rings:
        shape.vertices += [centre + vec(rx * math.cos(t), ry * math.sin(t), 0) for t in turns]
    for k in range(len(rings) - 1):
        for i in range(sides):
            j = (i + 1) % sides
            low, high = k * sides, (k + 1) * sides
            shape.faces.append((low + i, low + j, high + j, high + i))
    if closed_top:
        top = (len(rings) - 1) * sides
        shape.faces.append(tuple(range(top, top + sides)))
    return shape


def _head_oval(body, z, ease):
    """(centre, x radius, y radius) around the head at a height in head sizes."""
    head = body.head
    return (vec(0, .025 * head.size - .004, head.chin_z + z * head.size),
            .335 * head.size * head.width + ease, .435 * head.size * head.depth + ease)


def _scaled(oval, factor):
    return oval[0], oval[1] * factor, oval[2] * factor


def _hat(body, is_coarse):
    """A felt hat with a brim."""
    ease = .016
    base, top = _head_oval(body, .70, ease), _head_oval(body, 1.10, ease)
    brim = (base[0] + vec(0, 0, -.004), base[1] + .055, base[2] + .060)
    upper = (base[0] + vec(0, 0, .010), base[1], base[2])
    rings = [base, brim, upper, _scaled(top, .86)] if is_coarse else \
        [base, brim, upper, _scaled(_head_oval(body, .95, ease), .97), _scaled(top, .86),
         _scaled(_head_oval(body, 1.13, ease), .62)]
    return _lathe(rings, 6 if is_coarse else 10)


def _sun_hat(body, is_coarse):
    """Straw, with a wide brim that bends down; roomy enough for thick hair."""
    ease = .034
    base, top = _head_oval(body, .76, ease), _head_oval(body, 1.16, ease)
    brim = (base[0] + vec(0, 0, -.035), base[1] + .125, base[2] + .115)
    upper = (base[0] + vec(0, 0, .012), base[1], base[2])
    rings = [base, brim, upper, _scaled(top, .66)] if is_coarse else \
        [base, brim, upper, _scaled(_head_oval(body, 1.02, ease), .94), _scaled(top, .66)]
    return _lathe(rings, 6 if is_coarse else 12)


def _cap(body, is_coarse):
    """A dome with a visor."""
    ease = .027
    base = _head_oval(body, .66, ease)
    rings = [base, _scaled(_head_oval(body, .92, ease), .90),
             _scaled(_head_oval(body, 1.10, ease), .45)]
    if not is_coarse:
        rings.insert(1, _scaled(_head_oval(body, .80, ease), 1.0))
    sides = 6 if is_coarse else 10
    shape = _lathe(rings, sides)
    centre, rx, ry = base
    first, count = len(shape.vertices), 3 if is_coarse else 5
    for i in range(count):
        t = math.radians(-90 + (i / (count - 1) - .5) * 120)
        inner = centre + vec(rx * math.cos(t), ry * math.sin(t), .004)
        reach = .062 * math.sin(math.pi * i / (count - 1)) ** .6 + .004
        shape.vertices += [inner, inner + vec(.35 * reach * math.cos(t), -reach, -.020)]
    for i in range(count - 1):
        a = first + 2 * i
        quad = (a, a + 1, a + 3, a + 2)
        shape.faces += [quad, quad[::-1]]
    return shape


def _felt_cap(body, is_coarse):
    """The close conical cap of working men."""
    base, ease = _head_oval(body, .66, .030), .030
    rings = [base, _scaled(_head_oval(body, .90, ease), .88),
             _scaled(_head_oval(body, 1.14, ease), .34)]
    if not is_coarse:
        rings.insert(1, _scaled(_head_oval(body, .74, ease), 1.03))
    return _lathe(rings, 6 if is_coarse else 10)


# Height in head sizes -> width of the veil, how far beyond the ears it reaches in degrees.
VEIL = {1.155: (.30, 91), 1.12: (.58, 91), 1.04: (.86, 91), .97: (.96, 60), .84: (1.02, 50),
        .50: (1.07, 44), .18: (1.05, 38), -.05: (1.10, 34), -.27: (1.42, 22)}
COARSE_VEIL = (1.12, .97, .18, -.27)


def _veil(body, is_coarse):
    """A fold of the cloak drawn over the head, open at the face, down to the shoulders."""
    heights, columns = (COARSE_VEIL, 6) if is_coarse else (tuple(VEIL), 10)
    shape = Shape([], [])
    for z in heights:
        width, reach = VEIL[z]
        centre, rx, ry = _head_oval(body, z, .046 if is_coarse else .032)
        centre = centre + vec(0, .10 * body.head.size * max(0, .3 - z), 0)
        turns = [math.radians(-reach + (180 + 2 * reach) * i / (columns - 1))
                 for i in range(columns)]
        ends = [] if is_coarse else [0, -1]  # the border is turned in
        points = [centre + vec(rx * math.cos(t), ry * math.sin(t), 0) * width for t in turns]
        for i, k in zip(ends, (0, len(points) + 1)):
            points.insert(k, points[i] + (centre - points[i]) * .16 + vec(0, .014, 0))
        shape.vertices += points
    _add_both_sides(shape, len(heights), columns if is_coarse else columns + 2,
                    [tuple(range(columns if is_coarse else columns + 2))[::-1]])
    return shape


def _add_both_sides(shape, rows, columns, others=(), is_ring=False):
    """Faces between rows of vertices, and others; copies of all for the side that faces inwards:
    smooth normals need vertices of their own there."""
    steps = [(i, (i + 1) % columns) for i in range(columns if is_ring else columns - 1)]
    faces = [(k + i, k + j, k + columns + j, k + columns + i)
             for k in range(0, (rows - 1) * columns, columns) for i, j in steps] + list(others)
    count = len(shape.vertices)
    shape.vertices += [v.copy() for v in shape.vertices]
    shape.faces += faces + [tuple(count + i for i in face[::-1]) for face in faces]


def _around_trunk(body, degrees, z, ease):
    """A point outside the trunk; 0 degrees is the front, 90 the left."""
    rings = [body.trunk[n] for n in ("hem", "waist", "ribs", "armpit", "chest", "shoulder",
                                     "collar")]
    z = min(max(z, rings[0].z), rings[-1].z)
    low = max((r for r in rings if r.z <= z), key=lambda r: r.z)
    high = min((r for r in rings if r.z >= z), key=lambda r: r.z)
    share = (z - low.z) / (high.z - low.z) if high.z > low.z else 0
    mix = lambda name: getattr(low, name) * (1 - share) + getattr(high, name) * share
    t = math.radians(degrees)
    depth = mix("front") if math.cos(t) > 0 else mix("back")
    belly = body.belly * max(0, math.cos(t)) + body.bust * .8 * max(0, math.cos(t))
    return vec((mix("half_width") + ease) * math.sin(t),
               mix("centre_y") - (depth + ease) * math.cos(t) - belly, z)


def _band(body, is_coarse, height_at, wide, ease):
    """A sloping band of cloth around the trunk; height_at gives its middle by degrees."""
    turns, rows = (8, 2) if is_coarse else (14, 3)
    shape = Shape([], [])
    for k in range(rows):
        across = k / (rows - 1) - .5
        bulge = ease + (.016 if rows == 3 and k == 1 else 0)
        for i in range(turns):
            degrees = 360 * i / turns
            point = _around_trunk(body, degrees, height_at(degrees) + across * wide, bulge)
            above = max(0, point[2] - body.trunk["shoulder"].z)
            shape.vertices.append(point + vec(0, 0, .35 * above))
    _add_both_sides(shape, rows, turns, is_ring=True)
    return shape


def _toga_fold(body, is_coarse):
    """Over the left shoulder and under the right arm."""
    high, low = body.trunk["collar"].z - .030, body.trunk["waist"].z + .03
    return _band(body, is_coarse, lambda d: (high + low) / 2
                 + (high - low) / 2 * math.sin(math.radians(d)), .135 * body.size, .022)


def _shawl(body, is_coarse):
    """Around both shoulders, lower in front."""
    high = body.trunk["shoulder"].z
    return _band(body, is_coarse, lambda d: high - .035 - .030 * math.cos(math.radians(d)),
                 .15 * body.size, .022)


def _scarf(body, is_coarse):
    """A ring of cloth around the neck."""
    collar = body.trunk["collar"]
    sides, rows = (6, 3) if is_coarse else (9, 5)
    shape = Shape([], [])
    for i in range(sides):
        t = 2 * math.pi * i / sides
        out = vec(math.cos(t), math.sin(t), 0)
        middle = vec(0, collar.centre_y, collar.z + .014 * body.size + .020 * math.sin(t))
        for k in range(rows):
            a = 2 * math.pi * k / rows + .5
            radius = body.neck + .016 + .030 * math.cos(a) * body.size
            shape.vertices.append(middle + out * radius
                                  + vec(0, 0, .036 * math.sin(a)) * body.size)
    for i in range(sides):
        for k in range(rows):
            j, m = (i + 1) % sides, (k + 1) % rows
            shape.faces.append((i * rows + k, j * rows + k, j * rows + m, i * rows + m))
    return shape


def _backpack(body, is_coarse):
    s, chest, waist = body.size, body.trunk["chest"], body.trunk["waist"]
    back = max(body.trunk[n].back + body.trunk[n].centre_y for n in ("chest", "armpit", "ribs"))
    y0, y1 = back - .012, back + .115 * s
    low, high, half = waist.z + .02 * s, chest.z + .035 * s, .135 * s
    shape = Shape([], [])
    for y, inset in ((y0, 0.0), (y1 - .03 * s, 0.0), (y1, .03 * s)) if not is_coarse else \
            ((y0, 0.0), (y1, .015 * s)):
        for x, z in ((half, low), (half, high), (-half, high), (-half, low)):
            x, z = x - math.copysign(inset, x), z + (inset if z == low else -inset)
            shape.vertices.append(vec(x, y, z))
    rows = len(shape.vertices) // 4
    for k in range(rows - 1):
        for i in range(4):
            a, b = 4 * k + i, 4 * k + (i + 1) % 4
            shape.faces.append((a, b, b + 4, a + 4)[::-1])
    last = 4 * (rows - 1)
    shape.faces.append((last + 3, last + 2, last + 1, last))
    if not is_coarse:
        for sign in (-1, 1):
            _add_strap(shape, body, sign, high - .02 * s, low + .10 * s, y0)
    return shape


def _add_strap(shape, body, sign, high, low, y):
    """Over the shoulder and down the front, back to the pack under the arm."""
    s, chest = body.size, body.trunk["chest"]
    shoulder, armpit = body.trunk["shoulder"], body.trunk["armpit"]
    x = shoulder.half_width * .52
    front = chest.centre_y - chest.front
    places = (vec(x, y, high), vec(x, shoulder.centre_y, shoulder.z + .034 * s),
              vec(x * 1.05, front - .004, chest.z + .012 * s),
              vec(x * 1.25, armpit.centre_y - armpit.front - .006, armpit.z - .03 * s),
              vec(x * 1.75, armpit.centre_y - .01, low + .03 * s), vec(x * 1.3, y, low))
    first, wide = len(shape.vertices), .020 * s
    for place in places:
        shape.vertices += [(place + vec(side * wide, 0, 0)) * vec(sign, 1, 1)
                           for side in (-1, 1)]
    for i in range(len(places) - 1):
        a = first + 2 * i
        quad = (a, a + 1, a + 3, a + 2)
        shape.faces.append(quad if sign > 0 else quad[::-1])
