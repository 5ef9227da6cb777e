# SPDX-License-Identifier: MIT
"""The small textures, painted with formulas, as PNG bytes. Rows run from the bottom up while
painting (v grows upwards, as in Blender); glTF's v runs down, the mesh writer turns it."""
import struct
import zlib

import numpy as np

SIZE = 256
HEAD_U_SCALE, HEAD_V_START, HEAD_V_SPAN = .74, .08, .92  # layout of the head chart, see body_head


def png(pixels):
    """Deterministic PNG of an H x W x 3 array of 0..1, bottom row first."""
    data = np.round(np.clip(pixels[::-1], 0, 1) * 255).astype(np.uint8)
    height, width, _ = data.shape
    up = data.copy()
    up[1:] -= data[:-1]
    rows = np.concatenate([np.full((height, 1), 2, np.uint8), up.reshape(height, -1)], 1)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body \
            + struct.pack(">I", zlib.crc32(kind + body))
    return b"\x89PNG\r\n\x1a\n" \
        + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) \
        + chunk(b"IDAT", zlib.compress(rows.tobytes(), 9)) + chunk(b"IEND", b"")


def grid(size):
    y, x = np.mgrid[0:size, 0:size]
    return (x + .5) / size, (y + .5) / size


def paint(image, mask, rgb):
    image[:] = image * (1 - mask[..., None]) + np.array(rgb) * mask[..., None]


def shade(image, mask, rgb):
    image *= 1 - mask[..., None] * (1 - np.array(rgb))


class FaceChart:
    """Coordinates of the face on the upper half of the skin texture, in head sizes."""
    softness = .014

    def __init__(self):
        u, v = grid(SIZE)
        self.x = (u - .5) / HEAD_U_SCALE
        self.side = np.abs(self.x)
        self.z = ((v - .5) / .5 - HEAD_V_START) / HEAD_V_SPAN
        self.on_head = v >= .5

    def ellipse(self, cx, cz, rx, rz, x=None):
        x = self.side if x is None else x
        distance = np.sqrt(((x - cx) / rx) ** 2 + ((self.z - cz) / rz) ** 2) - 1
        return np.clip(.5 - distance * min(rx, rz) / self.softness, 0, 1) * self.on_head

    def blur(self, cx, cz, rx, rz):
        return np.exp(-((self.side - cx) / rx) ** 2 - ((self.z - cz) / rz) ** 2) * self.on_head

    def stroke(self, z, thickness, low, high):
        line = np.clip(.5 - (np.abs(self.z - z) - thickness) / self.softness, 0, 1)
        return line * (self.side > low) * (self.side < high) * self.on_head


def skin(tone, is_woman, eye_rgb=(.22, .14, .09)):
    """Face, hands and neck in one skin tone (0..255 sRGB)."""
    chart = FaceChart()
    image = np.ones((SIZE, SIZE, 3)) * np.array(tone) / 255
    _shade_face(image, chart)
    _paint_eyes(image, chart, is_woman, eye_rgb)
    dark = np.array(tone) / 255 * .30
    arch = np.clip((chart.side - .07) / .17, 0, 1)
    brow = .600 + .030 * np.sin(arch * 2.2) - .010 * arch
    thick = (.011 if is_woman else .018) * (1 - .55 * arch)
    paint(image, chart.stroke(brow, thick, .068, .245) * .85, dark)
    lips = chart.ellipse(0, .182, .085, .034 if is_woman else .024, chart.x)
    lip_rgb = np.array(tone) / 255 * ((.86, .60, .60) if is_woman else (.88, .72, .70))
    paint(image, lips * .8, lip_rgb)
    mouth = .202 - .020 * (1 - (chart.x / .095) ** 2)
    paint(image, chart.stroke(mouth, .005, -1, .092) * .8, np.array(tone) / 255 * .45)
    return png(image)


def _shade_face(image, chart):
    shade(image, chart.blur(.30, .33, .10, .09) * .5, (1.0, .82, .78))
    shade(image, chart.blur(0, .285, .07, .030) * .55, (.78, .66, .62))
    shade(image, chart.blur(.135, .53, .12, .07) * .45, (.80, .70, .68))
    shade(image, chart.blur(0, .10, .11, .025) * .35, (.80, .70, .68))
    shade(image, np.clip((.06 - chart.z) / .10, 0, 1) * chart.on_head * .35, (.76, .66, .64))


def _paint_eyes(image, chart, is_woman, eye_rgb):
    x, z = .150, .495
    rx, rz = (.066, .038) if is_woman else (.060, .033)
    white = chart.ellipse(x, z, rx, rz)
    paint(image, white, (.93, .92, .90))
    paint(image, chart.ellipse(x - .006, z + .002, .034, .040) * white, eye_rgb)
    paint(image, chart.ellipse(x - .006, z + .002, .017, .021) * white, (.04, .04, .04))
    outer = chart.ellipse(x, z, rx + .012, rz + .016)
    lid = np.clip(outer - chart.ellipse(x, z - .012, rx + .004, rz + .008), 0, 1)
    paint(image, lid * (chart.z > z - .01) * (1 if is_woman else .8), (.12, .08, .07))


def weave(seed, contrast):
    """Neutral cloth: faint blotches, so that it can be tinted cleanly."""
    noise = np.random.default_rng(seed).normal(0, contrast, (16, 16))
    return np.repeat(np.clip(.97 + np.kron(noise, np.ones((4, 4))), 0, 1)[..., None], 3, 2)


def plain_cloth():
    return png(weave(1, .008))


def striped_cloth():
    image = weave(2, .006)
    _, v = grid(64)
    paint(image, ((v * 14) % 1 < .42).astype(float), (.52, .54, .58))
    return png(image)


def denim():
    image = weave(3, .012)
    u, v = grid(64)
    image *= (1 + .06 * np.exp(-((u - .5) / .12) ** 2) - .05)[..., None]
    image *= (1 - .14 * (np.abs(u - .44) < .012))[..., None]
    image *= (1 - .14 * (v > .965))[..., None]
    return png(image)


def shoe():
    """Upper with a light sole (the lowest part of the chart)."""
    image = np.full((32, 32, 3), .80)
    _, v = grid(32)
    paint(image, (v < .40).astype(float), (1.0, .99, .96))
    return png(image)


def hair():
    u, v = grid(64)
    strands = sum(a * np.sin(2 * np.pi * n * u + n) for n, a in ((7, .05), (13, .05), (23, .04)))
    value = np.clip((1 + strands - .06) * (.78 + .22 * np.clip(v * 1.6, 0, 1)), 0, 1)
    return png(np.repeat(value[..., None], 3, 2))
