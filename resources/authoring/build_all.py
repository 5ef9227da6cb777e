#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Rebuilds all built-in content: templates, stage, scene and the skinning reference."""
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
IN_BLENDER = ("build_people.py", "build_theatre.py", "make_skinning_reference.py")
PLAIN = ("build_creatures.py", "build_stages.py", "make_theatre_scene.py", "make_scenes.py",
         "check_skinning.py", "check_templates.py --step 1")


def main():
    environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1", PYTHONHASHSEED="0")
    for script in IN_BLENDER:
        subprocess.run(["blender", "--background", "--threads", "1", "--factory-startup",
                        "--python-use-system-env", "--python-exit-code", "1", "--python",
                        os.path.join(HERE, script)], env=environment, check=True)
    for line in PLAIN:
        script, *arguments = line.split()
        subprocess.run([sys.executable, os.path.join(HERE, script), *arguments], env=environment,
                       check=True)


if __name__ == "__main__":
    main()
