# SPDX-License-Identifier: MIT
"""A brush of its own: a wave of raised arms that runs through the rows.

Run in the editor's console it joins the palette; run alone it paints one stroke over the theatre:
    crowdbrush script wave_brush.py OUT.png"""
import sys
from typing import Annotated, Literal

import numpy as np

import crowdbrush


@crowdbrush.register_brush
class WaveBrush:
    """A wave of raised arms that runs through the rows."""

    selection = crowdbrush.Selection.ALL_IN_CIRCLE
    radius = 60

    length: Annotated[float, crowdbrush.Range(1, 40)] = 12.0
    clip: Literal["sit_cheer", "sit_clap", "sit"] = "sit_cheer"
    colours: bool = True
    colour: tuple[int, int, int] = (240, 170, 40)

    def apply(self, selection: crowdbrush.Selected) -> None:
        """People of a dab: the further along X, the later they rise."""
        phase = (selection.column("position")[:, 0] / self.length) % 1.0
        selection.change(clip=self.clip, phase=phase.astype(np.float32))
        if self.colours:
            top = np.empty((len(selection), 4), np.uint8)
            top[:, :3] = self.colour
            top[:, 3] = 255 * np.sin(np.pi * phase)
            slot = selection.scene.templates[0].slots.index("top")
            selection.change(**{f"tint{slot}": top})


def main() -> None:
    scene = crowdbrush.open("builtin:scenes/theatre.crowd")
    way = [(100 + 10 * i, 360 + 60 * np.sin(i / 9), 1.0, i / 60) for i in range(110)]
    outcome = scene.stroke(WaveBrush(), way, size=(1280, 720))
    print(f"{outcome.affected} people are part of the wave")
    if len(sys.argv) > 1:
        scene.render(1280, 720, time=0.4).save_png(sys.argv[1])


if __name__ == "__main__" and "scene" not in globals():
    main()
