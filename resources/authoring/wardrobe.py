# SPDX-License-Identifier: MIT
"""Materials of a person: slots, their default look and the variants of each slot.

Colours are 0..255 sRGB and multiply a nearly white texture. The defaults are light and plain, so
that a tint, which multiplies once more, gives a clean colour."""
from dataclasses import dataclass

import accessories
import images

SLOTS = ("skin", "hair", "top", "bottom", "shoes")
EXTRA_SLOTS = ("bag", "scarf", "hat", "cloak")


@dataclass(frozen=True)
class Look:
    variant: str  # "" is the default
    image: str
    rgb: tuple


SKIN_TONES = (("", (230, 184, 154)), ("Skin fair", (242, 208, 182)),
              ("Skin olive", (208, 162, 124)), ("Skin brown", (162, 112, 82)),
              ("Skin deep", (112, 76, 58)))
WHITE = (255, 255, 255)
HAIR = (Look("Hair black", "hair", (44, 38, 36)), Look("Hair blond", "hair", (206, 172, 116)),
        Look("Hair auburn", "hair", (140, 78, 48)), Look("Hair grey", "hair", (172, 168, 162)),
        Look("Hair pale", "hair", (240, 236, 228)))
TROUSERS = (Look("Bottom jeans", "denim", (74, 92, 124)),
            Look("Bottom dark", "cloth", (62, 64, 70)))
SHOES = (Look("Shoes dark", "shoe", (64, 58, 54)),)
BAG = (Look("", "cloth", (190, 176, 152)), Look("Bag leather", "cloth", (124, 84, 56)))
SCARF = (Look("", "cloth", (222, 208, 196)), Look("Scarf striped", "stripes", (226, 214, 206)))

CLOAK = (Look("", "cloth", (232, 224, 208)), Look("Cloak purple", "cloth", (112, 52, 88)),
         Look("Cloak saffron", "cloth", (214, 158, 72)), Look("Cloak dark", "cloth", (84, 74, 70)))
NO_BOTTOM = (196, 186, 168)

# Per person: default colours of hair, top, bottom and shoes, then the variants of top and bottom.
OUTFITS = {
    "man": ((92, 68, 50), (214, 214, 208), (168, 160, 146), (176, 164, 150),
            (Look("Top striped", "stripes", (236, 234, 228)),
             Look("Top checked", "checks", (232, 226, 220))), TROUSERS),
    "woman": ((112, 80, 56), (226, 222, 212), (176, 168, 154), (196, 186, 172),
              (Look("Top striped", "stripes", (236, 234, 228)),
               Look("Top dotted", "dots", (228, 214, 218))), TROUSERS),
    "man_2": ((64, 50, 42), (186, 172, 150), (138, 134, 130), (132, 110, 92),
              (Look("Coat navy", "coat", (58, 66, 88)),
               Look("Coat herringbone", "checks", (168, 158, 146))), TROUSERS),
    "woman_2": ((146, 98, 62), (226, 204, 196), (214, 206, 198), (206, 184, 164),
                (Look("Dress dotted", "dots", (226, 216, 220)),
                 Look("Dress striped", "stripes", (232, 230, 226)),
                 Look("Dress dark", "belted", (74, 68, 88))), ()),
    "girl": ((168, 118, 72), (236, 222, 216), (196, 172, 190), (222, 190, 196),
             (Look("Top striped", "stripes", (240, 234, 230)),
              Look("Top dotted", "dots", (236, 226, 228))),
             (Look("Skirt checked", "checks", (198, 178, 186)),
              Look("Skirt denim", "denim", (84, 102, 136)))),
    "boy": ((104, 74, 50), (220, 226, 220), (172, 164, 142), (200, 196, 190),
            (Look("Top striped", "stripes", (236, 236, 232)),
             Look("Top checked", "checks", (220, 228, 232))),
            (Look("Shorts denim", "denim", (78, 98, 132)),
             Look("Shorts dark", "cloth", (66, 68, 76)))),
    "old_woman": ((204, 200, 194), (210, 196, 204), (164, 158, 164), (120, 108, 102),
                  (Look("Cardigan flowers", "dots", (214, 198, 202)),
                   Look("Cardigan dark", "coat", (84, 72, 88))),
                  (Look("Skirt checked", "checks", (170, 160, 154)),
                   Look("Skirt dark", "cloth", (70, 68, 78)))),
    "old_man": ((196, 192, 186), (196, 184, 160), (150, 142, 130), (116, 94, 78),
                (Look("Cardigan checked", "checks", (206, 194, 172)),
                 Look("Cardigan green", "coat", (96, 108, 84))), TROUSERS),
    "patrician": ((96, 82, 70), (240, 234, 222), NO_BOTTOM, (128, 82, 58),
                  (Look("Toga with purple border", "bordered", (240, 234, 222)),
                   Look("Toga dark", "cloth", (104, 94, 88))), ()),
    "matron": ((84, 58, 42), (224, 204, 176), NO_BOTTOM, (170, 130, 96),
               (Look("Stola bordered", "bordered", (226, 214, 196)),
                Look("Stola belted", "girdled", (206, 184, 186))), ()),
    "citizen": ((66, 50, 40), (222, 206, 176), NO_BOTTOM, (132, 92, 64),
                (Look("Tunic striped", "clavi", (234, 226, 208)),
                 Look("Tunic dyed", "girdled", (178, 128, 92))), ()),
    "labourer": ((58, 44, 36), (196, 168, 130), NO_BOTTOM, (110, 82, 60),
                 (Look("Tunic patched", "checks", (184, 160, 128)),
                  Look("Tunic brown", "girdled", (138, 104, 78))), ()),
    "priest": ((196, 192, 186), (246, 242, 232), NO_BOTTOM, (196, 170, 136),
               (Look("Robe bordered", "bordered", (246, 240, 228)),
                Look("Robe red", "girdled", (168, 70, 58))), ()),
}


PLAIN_TOP = {"citizen": "girdled", "labourer": "girdled", "matron": "girdled", "man_2": "coat",
             "woman_2": "belted", "old_man": "coat", "old_woman": "coat"}


def slots(body):
    worn = [_slot_of(name) for name in body.accessories]
    return SLOTS + tuple(slot for slot in EXTRA_SLOTS if slot in worn)


def _slot_of(accessory):
    return accessories.SLOT_OF[accessory]


def is_tintable(slot):
    return slot != "skin"


def looks(body):
    """slot -> looks, the default first."""
    hair, top, bottom, shoes, tops, bottoms = OUTFITS[body.wardrobe]
    every = {
        "skin": tuple(Look(name, "skin" + name[4:], WHITE) for name, _ in SKIN_TONES),
        "hair": (Look("", "hair", hair),) + HAIR,
        "top": (Look("", PLAIN_TOP.get(body.wardrobe, "cloth"), top),) + tops,
        "bottom": (Look("", "cloth", bottom),) + bottoms,
        "shoes": (Look("", "shoe", shoes),) + SHOES,
        "bag": BAG, "scarf": SCARF, "cloak": CLOAK,
        "hat": (Look("", "cloth", (206, 192, 160)), Look("Hat dark", "cloth", (76, 72, 74)))}
    return {slot: every[slot] for slot in slots(body)}


def textures(body):
    """name -> PNG bytes, those that some look uses."""
    face = images.Face(is_woman=body.is_woman, is_child=body.size < .8, is_old=body.stoop > 0)
    painted = {"skin" + name[4:]: images.skin(tone, face) for name, tone in SKIN_TONES}
    painted.update(hair=images.hair(), cloth=images.plain_cloth(), stripes=images.striped_cloth(),
                   checks=images.checked_cloth(), coat=images.coat_cloth(),
                   girdled=images.girdled_cloth(), clavi=images.cloth_with_clavi(),
                   bordered=images.bordered_cloth(), belted=images.belted_cloth(),
                   dots=images.dotted_cloth(),
                   denim=images.denim(), shoe=images.shoe())
    used = {look.image for own in looks(body).values() for look in own}
    return {name: data for name, data in painted.items() if name in used}
