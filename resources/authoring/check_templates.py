#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Reads every built-in template and measures what an artist would notice (plain NumPy, no Blender).

usage: check_templates.py [--step N] [NAME ...]

Every Nth keyframe (8) is searched for hands in the body and legs out of the garment; where the
worst of these comes near a limit, every keyframe of that clip is. Everything else is measured at
all keyframes. Prints a line of figures per template and a line per fault, and exits with 1 when
there is a fault; that the glTF validator is not there to run is one."""
import argparse
import glob
import json
import os
import subprocess
import sys

import numpy as np

import silhouettes
from baked import BakedTemplate
from glb import read_glb
from motion import balls, foot_slide, jerk, knee_acceleration, seam
from penetration import Surfaces

HERE = os.path.dirname(os.path.abspath(__file__))
RESOURCES = os.path.normpath(os.path.join(HERE, ".."))
PEOPLE_CLIPS = ("idle idle_2 walk walk_2 run sit sit_2 sit_clap sit_cheer clap cheer wave sad "
                "sit_sad bored sit_bored angry talk look_around dance dance_2 sit_down stand_up "
                "sit_talk sit_look_around sit_angry sit_wave").split()
CLIPS = {"person": PEOPLE_CLIPS, "animal": ["idle", "walk", "run"], "machine": ["idle"],
         "helicopter": ["idle", "hover", "fly"], "forklift": ["idle", "drive", "lift"]}
ONCE = ("sit_down", "stand_up")
NO_REST = ("sit_clap", "sit_cheer", "sit_sad", "sit_bored", "sit_angry", "sit_wave")
GAITS = ("walk", "walk_2", "run", "drive", "fly")
FEWEST_CAMERAS = 3
PEOPLE_SLOTS = {"skin", "hair", "top", "shoes"}  # a dress has no lower half of its own
LEVELS = ((1000, 1200), (560, 690), (290, 350), (85, 130))
MOST = {"seam": .0005, "jerk": .05, "slide": .002, "hand": .020, "hand in garment": .020,
        "leg": .010,
        "knee": 600.0}  # rad/s2; a straight knee that snaps has several thousand
PENETRATIONS = ("hand", "hand in garment", "leg")
FEWEST_SKIN_TONES, FEWEST_LOOKS = 4, 2
MOST_OVERLAP = .85
ANY = (0, 30000)
STAGE_TRIANGLES = {"theatre": (13000, 14500), "city": (15000, 16500)}
SEATS = {"theatre": (660, 740), "stadium": (2000, 4000)}
MOST_BYTES = 40 * 1024 * 1024
HEIGHT_METRES, REACH_METRES = (.02, 6.0), 8.0
COMMON_HEIGHT = 1.75
MOST_LINES = 20  # of what the validator says
VALIDATOR = os.path.normpath(os.path.join(RESOURCES, "..", "build", "gltf-validator",
                                          "node_modules"))
VALIDATOR_MISSING = ("the glTF validator did not run: node finds no module gltf-validator. Run "
                     "./dev setup, which puts it into build/gltf-validator, or set NODE_PATH to "
                     "the folder that has it")


def kind_of(template):
    if "thigh_L" in template.index:
        return "person"
    return "animal" if template.is_skinned() else "machine"


class Report:
    def __init__(self, name):
        self.name, self.faults, self.figures = name, [], {}

    def demand(self, is_right, text):
        if not is_right:
            self.faults.append(f"{self.name}: {text}")

    def largest(self, figure, value, clip):
        if value > self.figures.get(figure, (-1, ""))[0]:
            self.figures[figure] = value, clip
        self.demand(value <= MOST[figure],
                    f"{figure} {value:.4f} in {clip}, at most {MOST[figure]}")


def penetration(surfaces, world, count, step):
    """Every keyframe where the chosen ones come within half of a limit."""
    found = surfaces.penetration(world, np.arange(0, count, step))
    if step > 1 and any(found[name] > .5 * MOST[name] for name in PENETRATIONS):
        found = surfaces.penetration(world, np.arange(count))
    return found


def check_clips(template, report, step):
    kind = kind_of(template)
    surfaces = Surfaces(template) if kind == "person" else None
    for clip, animation in template.clips.items():
        extras, world = animation["extras"], template.globals(clip)
        if extras["loop"]:
            report.largest("seam", seam(world), clip)
            report.largest("jerk", jerk(world), clip)
        check_bounds(template, report, clip, world)
        if extras["speed"] > 0 and balls(template):
            report.largest("slide", foot_slide(template, world, extras["speed"]), clip)
        if kind == "person":
            check_promises(report, clip, extras)
            report.largest("knee", knee_acceleration(template, world, extras["loop"]), clip)
            for name, metres in penetration(surfaces, world, template.keyframes(clip),
                                            step).items():
                report.largest(name, metres, clip)


def check_promises(report, clip, extras):
    """What a clip says of itself has to go with its name."""
    report.demand(extras["loop"] == (clip not in ONCE), f"{clip} loops: {extras['loop']}")
    report.demand((extras["speed"] > 0) == (clip in GAITS),
                  f"{clip} has the speed {extras['speed']}")
    report.demand(("seatHeight" in extras) == (clip.startswith("sit") or clip in ONCE),
                  f"{clip} has the wrong seat height")
    report.demand(extras.get("role") == ("other" if clip in NO_REST else None),
                  f"{clip} has the role {extras.get('role')}")


def check_bounds(template, report, clip, world):
    frames = np.arange(0, template.keyframes(clip), 16)
    points = np.concatenate([template.deformed(p, world, frames).reshape(-1, 3)
                             for p in template.primitives])
    low, high = points[:, 1].min(), points[:, 1].max()
    report.demand(HEIGHT_METRES[0] < high < HEIGHT_METRES[1], f"{clip} is {high:.2f} m high")
    report.demand(low > -.03, f"{clip} reaches {-low:.3f} m into the ground")
    reach = np.abs(points[:, [0, 2]]).max()
    report.demand(reach < REACH_METRES, f"{clip} reaches {reach:.2f} m from the origin")


def check_materials(template, report):
    """Looks to choose from in every slot that an artist dresses, tints where they belong."""
    looks = template.looks()
    for slot, is_tintable in template.tintable().items():
        report.demand(is_tintable == (slot not in ("skin", "eyes", "glass")),
                      f"slot {slot} tintable: {is_tintable}")
    if kind_of(template) == "person":
        report.demand(PEOPLE_SLOTS <= set(looks), f"slots {sorted(looks)}")
        report.demand(looks.get("skin", 0) >= FEWEST_SKIN_TONES, "too few skin tones")
        few = [slot for slot, count in looks.items() if count < FEWEST_LOOKS and slot != "bottom"]
        report.demand(not few, f"slots {few} have no choice of looks")
    report.demand(any(count > 1 for count in looks.values()), "no slot has a choice of looks")


def check(template, name, step):
    report, kind, counts = Report(name), kind_of(template), template.triangles_per_level()
    for level, (count, (low, high)) in enumerate(zip(counts, LEVELS)):
        report.demand(low <= count <= high,
                      f"level {level} has {count} triangles, not {low} to {high}")
    check_materials(template, report)
    missing = [c for c in CLIPS.get(name, CLIPS[kind]) if c not in template.clips]
    report.demand(not missing, f"clips {missing} are missing")
    check_clips(template, report, step)
    figures = ", ".join(f"{k} {v:.4f} ({c})" for k, (v, c) in report.figures.items())
    print(f"{name}: triangles {counts}, {len(template.clips)} clips; {figures}", flush=True)
    return report.faults


def check_silhouettes(templates):
    """Two people must differ both as they stand and when they are made equally tall."""
    pictures = {name: silhouettes.silhouette(t) for name, t in templates.items()
                if kind_of(t) == "person"}
    tall = {name: silhouettes.silhouette(templates[name], COMMON_HEIGHT / silhouettes.height(p))
            for name, p in pictures.items()}
    faults = []
    for how, own in (("as they stand", pictures), ("equally tall", tall)):
        table = silhouettes.overlaps(own)
        print(f"front silhouettes {how}, the most alike of {len(table)} pairs: " + ", ".join(
            f"{a} and {b} {share:.3f}" for share, a, b in table[:6]), flush=True)
        faults += [f"{a} and {b} overlap by {share:.3f} {how}, less than {MOST_OVERLAP} is asked"
                   for share, a, b in table if share >= MOST_OVERLAP]
    return faults


def check_stages():
    """Triangles near what was asked for, and enough seats."""
    faults = []
    for path in sorted(glob.glob(os.path.join(RESOURCES, "stages", "*.glb"))):
        name, (document, _) = os.path.basename(path)[:-4], read_glb(path)
        count = sum(document["accessors"][p["indices"]]["count"] // 3
                    for mesh in document["meshes"] for p in mesh["primitives"])
        seats = len(document["scenes"][0]["extras"]["seats"])
        for what, value, (low, high) in (("triangles", count, STAGE_TRIANGLES.get(name, ANY)),
                                         ("seats", seats, SEATS.get(name, ANY))):
            if not low <= value <= high:
                faults.append(f"stage {name} has {value} {what}, not {low} to {high}")
        print(f"stage {name}: {count} triangles, {seats} seats")
    return faults


def check_scenes():
    """Nobody moves on the spot; several cameras; a picture for the welcome page."""
    faults = []
    for path in sorted(glob.glob(os.path.join(RESOURCES, "scenes", "*.crowd"))):
        with open(path, encoding="utf-8") as file:
            scene = json.load(file)
        name, table = os.path.basename(path), scene["individuals"]
        template, clip = (table["columns"].index(column) for column in ("template", "clip"))
        clips = {entry["id"]: entry["clips"] for entry in scene["templates"]}
        played = [clips[row[template]][row[clip]] for row in table["rows"]]
        faults += [f"{name}: {played.count(gait)} play {gait} on the spot"
                   for gait in GAITS if gait in played]
        if len(scene["cameras"]) < FEWEST_CAMERAS:
            faults.append(f"{name}: has {len(scene['cameras'])} cameras")
        if not os.path.exists(path[:-len(".crowd")] + ".png"):
            faults.append(f"{name}: has no picture (make_thumbnails.py)")
        print(f"{name}: {len(played)} individuals, {len(scene['cameras'])} cameras")
    return faults


def check_size():
    total = sum(os.path.getsize(os.path.join(folder, file))
                for folder, _, files in os.walk(RESOURCES) for file in files)
    print(f"resources: {total / 1e6:.1f} MB")
    return [] if total < MOST_BYTES else [f"resources have {total} bytes, at most {MOST_BYTES}"]


def validate(paths):
    """The Khronos validator over the files."""
    folders = [os.environ["NODE_PATH"]] if os.environ.get("NODE_PATH") else []
    environment = dict(os.environ, NODE_PATH=os.pathsep.join(folders + [VALIDATOR]))
    try:
        subprocess.run(["node", "-e", "require('gltf-validator')"], env=environment,
                       capture_output=True, check=True)
    except (FileNotFoundError, subprocess.CalledProcessError):
        return [VALIDATOR_MISSING]
    told = subprocess.run(["node", os.path.join(HERE, "validate.js"), *paths], env=environment,
                          capture_output=True, text=True, check=False)
    lines = told.stdout.splitlines()
    clean = sum(line.endswith(": 0 errors, 0 warnings") for line in lines)
    print(f"the glTF validator ran: {clean} of {len(paths)} files without errors and warnings")
    worst = [line for line in lines if not line.endswith(": 0 errors, 0 warnings")]
    return [] if told.returncode == 0 else worst[:MOST_LINES] + told.stderr.splitlines()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--step", type=int, default=8)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    paths = {os.path.basename(p)[:-4]: p
             for p in sorted(glob.glob(os.path.join(RESOURCES, "templates", "*.glb")))}
    paths = {n: p for n, p in paths.items() if not options.names or n in options.names}
    templates = {name: BakedTemplate(path) for name, path in paths.items()}
    faults = []
    for name, template in templates.items():
        faults += check(template, name, options.step)
    faults += check_silhouettes(templates) + check_stages() + check_scenes() + check_size()
    stages = [] if options.names else sorted(glob.glob(os.path.join(RESOURCES, "stages", "*.glb")))
    faults += validate(list(paths.values()) + stages)
    print("\n".join(faults))
    return 1 if faults or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
