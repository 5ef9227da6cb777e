# SPDX-License-Identifier: MIT
"""The audience's side of the theatre: ranks of stone steps in wedges, and where people sit.

A rank at front edge radius R, with its feet level f: the riser stands at R, the seat slab lies
at f + SEAT_HEIGHT from R - NOSE to R + SLAB, and behind it the tread for the feet of the next
rank, DIP lower. A seated person's foot point (the seat's position) is FOOT_IN_FRONT of the edge;
the seated clips put the pelvis .40 m behind the foot point, so .20 m behind the edge."""
import math

from stage_surface import polar

HALF_ANGLE = math.radians(100)
WEDGES, LOWER_RANKS, UPPER_RANKS = 10, 7, 5
RANKS = LOWER_RANKS + UPPER_RANKS
FIRST_RADIUS, DEPTH, WALK = 8.2, .86, 1.7
SEAT_HEIGHT, DIP, NOSE, SLAB = .44, .05, .04, .40
RISE = SEAT_HEIGHT - DIP
FLOOR = .10
FOOT_IN_FRONT, SEAT_WIDTH, AISLE = .20, .63, .75
SEGMENTS = 4
# How far steps reach into the ranks beside them; what is level with a rank lies so far below it and
# reaches so far under it: no gap between the two, and never two surfaces in one place.
OVERLAP, SUNK, UNDER = .01, .01, .10


def edge_radius(rank):
    return FIRST_RADIUS + DEPTH * rank + (WALK if rank >= LOWER_RANKS else 0)


def feet_level(rank):
    return FLOOR + RISE * rank


TOP_LEVEL = feet_level(RANKS)
OUTER_RADIUS = edge_radius(RANKS - 1) + DEPTH + 1.6


def wedge_angles(wedge):
    width = 2 * HALF_ANGLE / WEDGES
    return -HALF_ANGLE + width * wedge, -HALF_ANGLE + width * (wedge + 1)


def add_seating(surface):
    """Adds ranks and stairs; returns the seats in glTF's frame."""
    seats = []
    for wedge in range(WEDGES):
        for rank in range(RANKS):
            start, end = wedge_angles(wedge)
            aisle = AISLE / 2 / edge_radius(rank)
            _add_rank(surface, rank, start + aisle, end - aisle)
            seats += _seats_of(rank, wedge, start + aisle, end - aisle)
    for wedge in range(WEDGES + 1):
        for rank in range(RANKS):
            _add_stairs(surface, rank, -HALF_ANGLE + 2 * HALF_ANGLE * wedge / WEDGES)
    return seats


def _add_rank(surface, rank, start, end):
    radius, feet = edge_radius(rank), feet_level(rank)
    seat = feet + SEAT_HEIGHT
    back = edge_radius(rank + 1) if rank + 1 < RANKS else radius + DEPTH
    profile = [(radius, feet), (radius - NOSE, seat - .07), (radius - NOSE, seat),
               (radius + SLAB, seat), (radius + SLAB, seat - DIP), (back, seat - DIP)]
    surface.arc(profile, start, end, SEGMENTS,
                ["stone_dark", "stone", "stone", "stone_dark", "stone_dark"])
    for angle, is_start in ((start, True), (end, False)):
        ids = surface.points(polar(r, angle, z) for r, z in (
            (radius, feet), (radius - NOSE, seat), (radius + SLAB, seat),
            (radius + SLAB, feet)))
        surface.face(ids if is_start else ids[::-1], "stone_dark")


def _seats_of(rank, wedge, start, end):
    radius = edge_radius(rank)
    count = int((end - start) * radius / SEAT_WIDTH)
    seats = []
    for i in range(count):
        angle = start + (end - start) * (i + .5) / count
        x, y, z = polar(radius - FOOT_IN_FRONT, angle, feet_level(rank))
        seats.append({"position": [round(x, 4), round(z, 4), round(-y, 4)],
                      "headingRadians": round(-angle, 5), "height": SEAT_HEIGHT,
                      "rank": rank, "wedge": wedge})
    return seats


def _add_stairs(surface, rank, angle):
    """Two steps a rank in the aisle, which widens outwards as the ends of the ranks do. The second is
    level with the tread behind the seats and begins where that does."""
    sine, cosine = math.sin(angle), math.cos(angle)
    spread = math.tan(AISLE / 2 / edge_radius(rank))
    for step in range(2):
        inner = edge_radius(rank) + step * SLAB
        outer = inner + (SLAB, DEPTH - SLAB + UNDER)[step]
        if rank == LOWER_RANKS - 1 and step == 1:
            outer += WALK
        z = feet_level(rank) + (step + 1) * RISE / 2 - step * SUNK
        foot = z - RISE / 2 - SUNK
        corners = ((inner, -1, foot), (inner, 1, foot), (inner, 1, z), (inner, -1, z),
                   (outer, 1, z), (outer, -1, z))
        aside = (OVERLAP, UNDER)[step]
        ids = surface.points(_beside(sine, cosine, r, side * (r * spread + aside), h)
                             for r, side, h in corners)
        surface.face((ids[0], ids[1], ids[2], ids[3]), "stone_dark")
        surface.face((ids[3], ids[2], ids[4], ids[5]), "stone")


def _beside(sine, cosine, ahead, aside, height):
    """A point so far out along an aisle, and so far beside its middle."""
    return sine * ahead + cosine * aside, cosine * ahead - sine * aside, height
