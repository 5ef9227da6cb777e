# SPDX-License-Identifier: MIT
"""Small vector and curve helpers. Authoring frame: metres, Z up, people face -Y, left is +X."""
import math

import numpy as np

FULL_TURN = 2 * math.pi


def vec(x, y, z):
    return np.array((x, y, z), float)


def unit(v):
    return v / np.linalg.norm(v)


def lerp(a, b, t):
    return a + (b - a) * t


def smoothstep(x, low, high):
    """0 below low, 1 above high, an S curve between."""
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def rot_x(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def rot_y(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def rot_z(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def frame(first, second):
    """Orthonormal columns: first, second made perpendicular to it, and their cross product."""
    first = unit(first)
    second = unit(second - first * np.dot(first, second))
    return np.stack([first, second, np.cross(first, second)], 1)


def hermite(p0, m0, p1, m1, u):
    """Cubic from p0 to p1 with the slopes m0 and m1, u in 0..1."""
    u2, u3 = u * u, u * u * u
    return ((2 * u3 - 3 * u2 + 1) * p0 + (u3 - 2 * u2 + u) * m0
            + (-2 * u3 + 3 * u2) * p1 + (u3 - u2) * m1)


def periodic_curve(phase, keys):
    """Catmull-Rom through (phase, value) keys that repeat with period 1."""
    keys = sorted(keys)
    around = [(p + turn, value) for turn in (-1, 0, 1) for p, value in keys]
    for i in range(1, len(around) - 2):
        (t0, a), (t1, b), (t2, c), (t3, d) = around[i - 1:i + 3]
        if t1 <= phase < t2:
            span = t2 - t1
            return hermite(b, (c - a) / (t2 - t0) * span, c, (d - b) / (t3 - t1) * span,
                           (phase - t1) / span)
    raise ValueError(f"phase {phase} is not in 0..1")


def to_gltf(points):
    """Authoring frame (Z up, facing -Y) to glTF's (Y up, facing +Z)."""
    points = np.asarray(points, float)
    return np.stack([points[..., 0], points[..., 2], -points[..., 1]], -1)


def srgb_to_linear(rgb):
    """0..255 sRGB to linear 0..1."""
    return [((c / 255 + .055) / 1.055) ** 2.4 if c > 10.3 else c / 255 / 12.92 for c in rgb]
