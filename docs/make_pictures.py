# SPDX-License-Identifier: MIT
"""Makes pictures of this folder anew: what light, looks and lenses do to the ready-made scenes.

usage: crowdbrush script docs/make_pictures.py [NAME...]"""
import os
import sys

import numpy as np

import crowdbrush
from crowdbrush import Light, Lighting, Look

HERE = os.path.dirname(os.path.abspath(__file__))
SIZE = (960, 540)


def scene_of(name, light=None, **changed):
    scene = crowdbrush.open(f"builtin:scenes/{name}.crowd")
    lighting = Lighting.ready(light) if light else scene.lighting
    for key, value in changed.items():
        setattr(lighting, key, value)
    scene.set_lighting(lighting)
    return scene


def highlights():
    """What is smooth mirrors sun and sky; the sun stands behind it."""
    scene = scene_of("meadow", "afternoon", sun_azimuth=2.35, sun_elevation=.45)
    return scene.render(*SIZE, camera="Machines")


def cartoon():
    """Ink, and light in three steps."""
    return scene_of("city", "afternoon").render(*SIZE, look="cartoon")


def focus():
    """Depth of field: one of the crowd is sharp."""
    scene = scene_of("theatre", "afternoon")
    return scene.render(*SIZE, camera="Close", focus=4.0, f_stop=.15)


def mist():
    """Mist lies over a square at dusk."""
    return scene_of("city", "dusk", haze=.97, haze_height=2.5).render(*SIZE)


def lamps():
    """A lamp and a spotlight at night; who stands in their light throws shadows, in the air, too."""
    scene = crowdbrush.open("builtin:scenes/city.crowd")
    scene.set_lighting(Lighting.of_day(22, .3))
    scene.lights = [
        Light(id=1, name="Spot", kind="spot", position=(-15, 3.6, 4), target=(-1, 1.3, 2), color="#ffd9a0",
              strength=5, cone=.4, softness=.4, beam=1.0, shadows=True),
        Light(id=2, name="Lamp", kind="point", position=(5.5, 2.6, 10.5), color="#ff7a48", strength=.3,
              shadows=True)]
    return scene.render(*SIZE, camera="Square")


def streetlamps():
    """The ready-made city, whose lamps go on after dark."""
    return scene_of("city", "night", haze=.15).render(*SIZE, camera="Square")


def density():
    """How densely people stand."""
    return scene_of("city").render(*SIZE, by="density")


def looks():
    """One moment in six looks of the scene."""
    scene = scene_of("theatre", "afternoon")
    scene.lights = [Light(id=i + 1, name=color, kind="spot", position=(x, 14, 4), target=(x / 2, 1, -9), color=color,
                          strength=5, cone=.5, softness=.5)
                    for i, (x, color) in enumerate([(-9, "#ff6a4a"), (0, "#fff0d0"), (9, "#4a7aff")])]
    scene.looks = [Look(id=1, name="Studio", light="studio", lamps=False),
                   Look(id=2, name="Evening", light="dusk", lamps=False),
                   Look(id=3, name="Spotlights", light="night"),
                   Look(id=4, name="Comic", style="cartoon", light="noon", lamps=False),
                   Look(id=5, name="Clay", style="clay", light="afternoon", lamps=False),
                   Look(id=6, name="Silhouettes", style="silhouettes", own_background=True, background="#ffffff")]
    width, height = SIZE[0] // 3, SIZE[1] // 3
    pictures = [scene.render(width, height, camera="Audience", look=each.name) for each in scene.looks]
    rows = [np.concatenate(pictures[row:row + 3], axis=1) for row in (0, 3)]
    return crowdbrush.Picture(np.concatenate(rows, axis=0))


def figures():
    """The paper's figures 9, 10 and 11: coloured spotlights, specular highlights, cartoon."""
    size = (SIZE[0] // 2, SIZE[0] // 3)
    night = scene_of("theatre", "night")
    night.lights = [Light(id=i + 1, name=color, kind="spot", position=(place, 13, 4), target=(at, 2, far), color=color,
                          strength=9, cone=.5, softness=.35, beam=.12)
                    for i, (place, at, far, color) in enumerate([(-10, -7, -10, "#ff5030"), (8, 8, -8, "#4060ff")])]
    low_sun = scene_of("theatre", "afternoon", highlights=2, sun_azimuth=1, sun_elevation=.35, ambient_strength=.35)
    noon = scene_of("theatre", "noon")
    return crowdbrush.Picture(np.concatenate([
        night.render(*size, camera="From the stage", time=2),
        low_sun.render(*size, camera="Close", time=2),
        noon.render(*size, camera="Close", time=2, look="cartoon")], axis=1))


def passes():
    """Passes of one picture: its colours, depth, normals, and each template in a colour of its own."""
    size = (SIZE[0] // 2, SIZE[1] // 2)
    shown = scene_of("theatre", "afternoon").render_passes(
        *size, ["depth", "normal", "template"], camera="Close", time=2)
    colours = scene_of("theatre", "afternoon").render(*size, camera="Close", time=2)[:, :, :3] / 255
    near = np.clip(1 - (shown["depth"] - 2) / 18, 0, 1)[:, :, None].repeat(3, axis=2)
    hues = np.array([[0, 0, 0], [.9, .3, .2], [.95, .75, .2], [.3, .7, .4], [.25, .5, .9], [.7, .4, .8]])
    kinds = hues[shown["template"] % len(hues)]
    rows = [np.concatenate(pair, axis=1) for pair in ((colours, near), (shown["normal"] / 2 + .5, kinds))]
    picture = np.concatenate(rows, axis=0)
    opaque = np.ones(picture.shape[:2] + (1,))
    return crowdbrush.Picture((np.concatenate([picture, opaque], axis=2) * 255).round().astype(np.uint8))


PICTURES = {each.__name__: each for each in
            (highlights, cartoon, focus, mist, lamps, streetlamps, density, looks, figures, passes)}


def main():
    for name in sys.argv[1:] or PICTURES:
        if name not in PICTURES:
            raise SystemExit(f"There is no picture {name}; there are: {', '.join(PICTURES)}.")
        PICTURES[name]().save_png(os.path.join(HERE, name + ".png"))


main()
