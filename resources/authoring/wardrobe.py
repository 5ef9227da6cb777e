# SPDX-License-Identifier: MIT
"""Materials of a person: slots, their default look and the variants of each slot.

Colours are 0..255 sRGB and multiply a nearly white texture. The defaults are light and plain, so
that a tint, which multiplies once more, gives a clean colour."""
from dataclasses import dataclass

import images

SLOTS = ("skin", "hair", "top", "bottom", "shoes")
TINTABLE = {"skin": False, "hair": True, "top": True, "bottom": True, "shoes": True}
ROUGHNESS = {"skin": .65, "hair": .6, "top": .9, "bottom": .9, "shoes": .6}


@dataclass(frozen=True)
class Look:
    variant: str  # "" is the default
    image: str
    rgb: tuple


SKIN_TONES = (("", (230, 184, 154)), ("Skin fair", (242, 208, 182)),
              ("Skin olive", (208, 162, 124)), ("Skin brown", (162, 112, 82)),
              ("Skin deep", (112, 76, 58)))
WHITE = (255, 255, 255)


def looks(is_woman):
    """slot -> looks, the default first."""
    return {
        "skin": [Look(name, "skin" + name[4:], WHITE) for name, _ in SKIN_TONES],
        "hair": [Look("", "hair", (112, 80, 56) if is_woman else (92, 68, 50)),
                 Look("Hair black", "hair", (44, 38, 36)),
                 Look("Hair blond", "hair", (206, 172, 116)),
                 Look("Hair auburn", "hair", (140, 78, 48)),
                 Look("Hair grey", "hair", (172, 168, 162)),
                 Look("Hair pale", "hair", (240, 236, 228))],
        "top": [Look("", "cloth", (226, 222, 212) if is_woman else (214, 214, 208)),
                Look("Top striped", "stripes", (236, 234, 228))],
        "bottom": [Look("", "cloth", (176, 168, 154) if is_woman else (168, 160, 146)),
                   Look("Bottom jeans", "denim", (74, 92, 124)),
                   Look("Bottom dark", "cloth", (62, 64, 70))],
        "shoes": [Look("", "shoe", (196, 186, 172) if is_woman else (176, 164, 150)),
                  Look("Shoes dark", "shoe", (64, 58, 54))],
    }


def textures(is_woman):
    """name -> PNG bytes."""
    painted = {"skin" + name[4:]: images.skin(tone, is_woman) for name, tone in SKIN_TONES}
    return dict(painted, hair=images.hair(), cloth=images.plain_cloth(),
                stripes=images.striped_cloth(), denim=images.denim(), shoe=images.shoe())
