# SPDX-License-Identifier: MIT
"""How smooth things are: roughness and metallic by the name of a material or slot. Run by itself it
writes them into the files there are, without building them anew.

usage: python3 gloss.py"""
import glob
import os

from glb import read_glb, write_glb

RESOURCES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
DULL = (.95, .0)
GLOSS = {
    # people and animals
    "skin": (.6, .0), "hair": (.5, .0), "shoes": (.4, .0), "bag": (.55, .0), "hat": (.8, .0),
    "eyes": (.12, .0), "coat": (.6, .0), "mane": (.55, .0), "hoof": (.4, .0),
    "shell": (.22, .0), "thorax": (.3, .0), "leg": (.4, .0),
    # machines
    "paint": (.3, .0), "helicopter trim": (.35, .0), "glass": (.08, .0), "metal": (.35, .9),
    "lamp": (.15, .0), "tyre": (.7, .0),
    # stages
    "water": (.08, .0), "window": (.1, .0), "door": (.45, .0), "sign": (.4, .0),
    "marble": (.3, .0), "seat": (.4, .0), "seat_light": (.4, .0),
    "board": (.35, .0), "board_light": (.35, .0), "leaf": (.7, .0), "leaf_light": (.7, .0),
    "pad": (.5, .0), "banner": (.7, .0), "banner_light": (.7, .0)}
CLOTH = (.85, .0)


def gloss_of(file, slot, otherwise=DULL):
    """Members of pbrMetallicRoughness."""
    roughness, metallic = GLOSS.get(f"{file} {slot}", GLOSS.get(slot, otherwise))
    return {"metallicFactor": metallic, "roughnessFactor": roughness}


def main():
    for path in sorted(glob.glob(os.path.join(RESOURCES, "*", "*.glb"))):
        folder, name = path.split(os.sep)[-2:]
        otherwise = DULL if folder == "stages" else CLOTH
        document, binary = read_glb(path)
        for material in document.get("materials", []):
            slot = material.get("extras", {}).get("slot", material["name"])
            material["pbrMetallicRoughness"].update(gloss_of(name[:-4], slot, otherwise))
        write_glb(path, document, binary)


if __name__ == "__main__":
    main()
