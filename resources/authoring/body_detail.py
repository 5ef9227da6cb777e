# SPDX-License-Identifier: MIT
"""What each level of detail keeps, and where the parts lie in their textures."""
import math
from dataclasses import dataclass

from geometry import lerp


@dataclass(frozen=True)
class Detail:
    level: int
    trunk_rows: tuple
    columns: int          # of the half trunk
    arm_hole: tuple       # first and last trunk column of the hole for the arm
    head_columns: tuple   # of 0 (front) .. 6 (back)
    head_rows: tuple
    forearm_sides: int
    leg_angles: tuple     # degrees from the front, growing outwards
    inflation: float      # coarser rings grow to keep the silhouette

    @property
    def is_finest(self):
        return self.level == 0


DETAILS = (
    Detail(0, ("hem", "waist", "ribs", "armpit", "chest", "shoulder", "collar"), 6, (2, 4),
           (0, 1, 2, 3, 4, 5, 6), (0, 1, 2, 3, 4, 5, 6, 7, 8), 6,
           (-42, 5, 47, 90, 133, 175, 222, 270), 1.0),
    Detail(1, ("hem", "waist", "ribs", "armpit", "shoulder", "collar"), 4, (1, 3),
           (0, 2, 3, 5, 6), (0, 1, 3, 5, 6, 7, 8), 5, (-42, 25, 90, 155, 222, 270), 1.02),
    Detail(2, ("hem", "waist", "armpit", "shoulder", "collar"), 3, (1, 2),
           (0, 2, 4, 6), (0, 1, 3, 6, 8), 4, (-42, 45, 135, 222, 270), 1.05),
    Detail(3, ("hem", "shoulder", "collar"), 2, None,
           (0, 3, 6), (1, 4, 8), 3, (0, 90, 180, 270), 1.12),
)

CHARTS = {"head": (0, 1, .5, 1), "arm": (0, .5, 0, .5), "trunk": (0, 1, .4, 1),
          "sleeve": (0, 1, 0, .4)}


def chart_u(chart, t):
    return lerp(CHARTS[chart][0], CHARTS[chart][1], t)


def chart_v(chart, t):
    return lerp(CHARTS[chart][2], CHARTS[chart][3], t)


def trunk_angles(detail):
    """From the front (0) over the left side to the back (pi)."""
    return [math.pi * i / detail.columns for i in range(detail.columns + 1)]
