#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Renders the first camera of every ready-made scene, small, for the editor's welcome page.

usage: make_thumbnails.py CROWDBRUSH     writes scenes/NAME.png"""
import glob
import os
import subprocess
import sys
import tempfile

from PIL import Image

from crowd_scene import RESOURCES

SIZE, FINER = (320, 180), 3
SECONDS = "0.4"


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        for scene in sorted(glob.glob(os.path.join(RESOURCES, "scenes", "*.crowd"))):
            large = os.path.join(folder, "large.png")
            subprocess.run([program, "render", scene, "--output", large, "--time", SECONDS,
                            "--size", f"{SIZE[0] * FINER}x{SIZE[1] * FINER}"], check=True)
            output = os.path.normpath(scene[:-len(".crowd")] + ".png")
            small = Image.open(large).convert("RGB").resize(SIZE, Image.LANCZOS)
            small.save(output, optimize=True)
            print(f"{output}: {os.path.getsize(output)} bytes")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
