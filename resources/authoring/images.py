# SPDX-License-Identifier: MIT
"""The small textures, painted with formulas, as PNG bytes. Rows run from the bottom up while
painting (v grows upwards, as in Blender); glTF's v runs down, the mesh writer turns it."""
import struct
import zlib
from dataclasses import dataclass

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


@dataclass(frozen=True)
class Face:
    is_woman: bool
    is_child: bool = False
    is_old: bool = False


def skin(tone, face, eye_rgb=(.22, .14, .09)):
    """Face, hands and neck in one skin tone (0..255 sRGB)."""
    is_woman = face.is_woman
    chart = FaceChart()
    image = np.ones((SIZE, SIZE, 3)) * np.array(tone) / 255
    _shade_face(image, chart)
    if face.is_old:
        _shade_wrinkles(image, chart)
    _paint_eyes(image, chart, face, eye_rgb)
    dark = np.array((.66, .64, .62)) if face.is_old else np.array(tone) / 255 * .30
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


def _shade_wrinkles(image, chart):
    fold = .36 - .55 * (chart.side - .09)
    shade(image, chart.stroke(fold, .006, .085, .19) * .35, (.72, .60, .56))
    for z in (.69, .735):
        shade(image, chart.stroke(z, .004, -1, .17) * .25, (.76, .66, .62))
    shade(image, chart.blur(.150, .435, .075, .018) * .5, (.80, .68, .64))
    shade(image, chart.blur(.250, .50, .03, .03) * .4, (.82, .72, .68))


def _paint_eyes(image, chart, face, eye_rgb):
    x, z = .150, .495
    is_woman = face.is_woman
    rx, rz = (.066, .038) if is_woman else (.060, .033)
    if face.is_child:
        rx, rz = rx * 1.16, rz * 1.30
    white = chart.ellipse(x, z, rx, rz)
    paint(image, white, (.93, .92, .90))
    grow = 1.2 if face.is_child else 1
    paint(image, chart.ellipse(x - .006, z + .002, .034 * grow, .040 * grow) * white, eye_rgb)
    paint(image, chart.ellipse(x - .006, z + .002, .017 * grow, .021 * grow) * white,
          (.04, .04, .04))
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


def coat_cloth():
    """A seam down the front, with buttons and lapels."""
    image = np.repeat(np.repeat(weave(6, .008), 4, 0), 4, 1)
    u, v = grid(256)
    soft = lambda distance, half: np.clip(.5 + (half - distance) * 256, 0, 1)
    shade(image, soft(np.abs(u - .495), .003) * .55, (.45, .44, .44))
    for height in (.50, .60, .70, .80):
        spot = np.sqrt(((u - .512) / .9) ** 2 + (v - height) ** 2)
        shade(image, soft(spot, .007) * .75, (.34, .30, .28))
    lapel = np.abs(np.abs(u - .495) - (v - .84) * .42)
    shade(image, soft(lapel, .004) * (v > .84) * .55, (.45, .44, .44))
    return png(image)


def belted_cloth():
    image = weave(7, .008)
    _, v = grid(64)
    shade(image, ((v > .555) & (v < .605)) * .8, (.50, .40, .36))
    return png(image)


def girdled_cloth():
    """A cord at the waist and the folds that it draws."""
    image = weave(8, .010)
    u, v = grid(64)
    folds = .5 + .5 * np.sin(u * 2 * np.pi * 11 + 2 * np.sin(v * 9))
    shade(image, folds * np.exp(-((v - .50) / .22) ** 2) * .45, (.72, .70, .68))
    shade(image, (np.abs(v - .56) < .014) * .9, (.42, .32, .24))
    return png(image)


def bordered_cloth():
    """A wide purple border along the lower edge; deep folds."""
    image = weave(9, .008)
    u, v = grid(64)
    folds = .5 + .5 * np.sin(u * 2 * np.pi * 9 + 3 * np.sin(v * 7))
    shade(image, folds * .22, (.72, .70, .70))
    shade(image, (v < .075) * 1.0, (.50, .18, .34))
    return png(image)


def cloth_with_clavi():
    """Two upright stripes, in front and behind."""
    image = weave(10, .008)
    u, v = grid(128)
    image = np.repeat(np.repeat(image, 2, 0), 2, 1)
    side = np.minimum(np.abs(u - .5), 1 - np.abs(u - .5))
    shade(image, (np.abs(side - .065) < .013) * .95, (.55, .24, .26))
    shade(image, (np.abs(v - .56) < .012) * .9, (.42, .32, .24))
    return png(image)


def checked_cloth():
    image = weave(4, .006)
    u, v = grid(64)
    across, along = (u * 16) % 1 < .30, (v * 14) % 1 < .30
    shade(image, across * .45, (.60, .62, .66))
    shade(image, along * .45, (.60, .62, .66))
    return png(image)


def dotted_cloth():
    image = weave(5, .006)
    u, v = grid(128)
    image = np.repeat(np.repeat(image, 2, 0), 2, 1)
    row = np.floor(v * 20)
    x, y = (u * 16 + .5 * (row % 2)) % 1 - .5, (v * 20) % 1 - .5
    paint(image, np.clip(6 * (.30 - np.sqrt(x * x + y * y)), 0, 1), (.48, .46, .52))
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
