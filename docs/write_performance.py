# SPDX-License-Identifier: MIT
"""Measures what the program promises of its speed and writes docs/performance.md anew: each figure
with its command line. For a quiet machine; ./dev bench runs it.

usage: write_performance.py CROWDBRUSH [--runs N] [--only TEXT]"""
import argparse
import dataclasses
import json
import os
import platform
import statistics
import subprocess
from collections.abc import Callable

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "performance.md")
RENDER = "bench render --samples 0 --clock cpu"
THEATRE = f"{RENDER} --frames 25 --scene resources/scenes/theatre.crowd --detail levels"


@dataclasses.dataclass(frozen=True)
class Figure:
    """`number` takes it from a report; `least` or `most` is what it is to reach, `limit` what is
    known to stand in the way: said where it is missed."""
    what: str
    command: str
    number: Callable[[dict], float]
    unit: str = ""
    least: float | None = None
    most: float | None = None
    limit: str = ""

    def is_reached(self, value):
        return ((self.least is None or value >= self.least) and
                (self.most is None or value <= self.most))

    def goal(self):
        if self.least is not None:
            return f"≥ {self.least:g}{self.unit}"
        return f"≤ {self.most:g}{self.unit}" if self.most is not None else "–"


def of(key, scale=1.0):
    return lambda report: report[key] * scale


def ratio(what, arguments, least, limit=""):
    return Figure(what, f"{RENDER} --look plain {arguments}", of("ratio"), " ×", least=least,
                  limit=limit)


def on_top(what, arguments, most):
    return Figure(what, f"{THEATRE} {arguments}", lambda report: report["to_plain"] - 1, " ×",
                  most=most)


def workload(what, arguments, least):
    return Figure(what, f"bench simulate {arguments}", of("agent_steps_per_second", 1e-6), " M/s",
                  least=least)


# Tried, measured, and not worth their price; figures are of the same bench.
TRIANGLES = ("Both methods hand all triangles to the same rasteriser, which takes 70 to 80 ns for each "
             "small one whatever its size. Here each vertex is blended of two keyframes, which the "
             "method of 2004 does not: one instead of two would be 1.12 times as fast, and jerk.")
LOSS = ("Coarser levels are drawn as far as they lose less than 0.6 dB, and little is left to lose (0.53 "
        "of 10 000): cards for those below 20 pixels instead of 18 lose 0.04 dB more and gain nothing, "
        "since the time goes to the larger ones.")
CARDS = ("Who is smaller than 18 pixels is drawn as a card. Were all of them cards, it would be 20 times "
         "as fast; without any 4.3. What bounds it is what cards lose: 0.50 dB with those below 18 "
         "pixels, 0.58 below 20, 0.69 below 22, of the 0.6 that may be lost.")
LINES = ("The lines of the ground, which the method of 2004 does not draw, are a fifth of an empty "
         "picture: without them it is 1.2 times as fast. About half of that are derivatives and "
         "divisions, which keep far lines from flickering. Leaving the colour uncleared, or reckoning the two "
         "distances of lines with fewer operations, gained nothing on llvmpipe.")
PEOPLE = ("Nearly all who are seen sit near enough to need full detail.")

SECTIONS = {
    "Drawing": ("How many times as fast as the method of 2004 (a display list for each keyframe and "
                "material, fixed-function light) in the same process, frame by frame in turn, "
                "in plain colours; 1280 × 720, one sample a pixel.", [
        ratio("1000 people, full detail", "--count 1000 --frames 25", 1.15, TRIANGLES),
        ratio("1000 people, levels of detail", "--count 1000 --detail levels --frames 25", 1.8, LOSS),
        ratio("10 000 people, full detail", "--count 10000 --frames 10", 1.0, TRIANGLES),
        ratio("10 000 people, levels", "--count 10000 --detail levels --frames 15", 4.2, LOSS),
        ratio("10 000 people, levels, all of them far away",
              "--count 10000 --detail levels --field far --frames 15", 9.0, CARDS),
        ratio("the theatre", "--scene resources/scenes/theatre.crowd --detail levels --frames 25", 1.25, PEOPLE),
        ratio("the city", "--scene resources/scenes/city.crowd --detail levels --frames 25", None),
        ratio("the stadium", "--scene resources/scenes/stadium.crowd --detail levels --frames 25", None),
        ratio("an empty picture", "--count 0 --frames 40", 1.1, LINES)]),
    "What levels of detail lose": ("Beside full detail, both against a picture with four samples "
                                   "each way.", [
        Figure("1000 people, signal to noise",
               f"{RENDER} --count 1000 --detail levels --quality --frames 5", of("lost_psnr"), " dB",
               most=0.6),
        Figure("1000 people, structure",
               f"{RENDER} --count 1000 --detail levels --quality --frames 5", of("lost_ssim"), "",
               most=0.010)]),
    "Light": ("What a look costs on top of the plain theatre, in the same process.", [
        on_top("lit, with the sun's shadows and occlusion", "--look lit", 0.9),
        on_top("cartoon", "--look cartoon", None)]),
    "Walking": ("Steps of one person, millions a second.", [
        workload("10 000 in a square, one thread",
                 "--workload square --count 10000 --steps 600 --threads 1", 6.5),
        workload("10 000 on paths, one thread",
                 "--workload paths --count 10000 --steps 600 --threads 1", 5.2),
        workload("2000 in a corridor, two directions",
                 "--workload corridor --count 2000 --steps 600 --threads 1", 2.4),
        Figure("100 000 in a square, two threads: a step",
               "bench simulate --workload square --count 100000 --steps 120 --threads 2",
               of("median_step_ms"), " ms", most=10.0)]),
    "Painting": ("On 100 000 people.", [
        Figure("a dab on some 500", "bench paint --count 100000", of("dab_ms_p50"), " ms", most=4.0),
        Figure("the slowest of a hundred", "bench paint --count 100000", of("dab_ms_p99"), " ms",
               most=8.0),
        Figure("undo", "bench paint --count 100000", of("undo_ms"), " ms", most=8.0)]),
    "Files": ("Of 100 000 people; the JSON library's own time is the floor.", [
        Figure("open", "bench io --count 100000", of("load_ms"), " ms", most=600),
        Figure("open, against the floor", "bench io --count 100000",
               lambda report: report["load_ms"] / report["parse_floor_ms"], " ×", most=1.5),
        Figure("save", "bench io --count 100000", of("save_ms"), " ms", most=300)]),
    "Time": ("10 000 people, 1000 steps kept as they are played.", [
        Figure("a person and step", "bench motion --count 10000 --frames 1000",
               of("bytes_per_person_step"), " bytes", most=24),
        Figure("keeping, share of a step", "bench motion --count 10000 --frames 1000",
               of("write_percent"), " %", most=15),
        Figure("any moment shown, slowest of a hundred",
               "bench motion --count 10000 --frames 1000", of("seek_ms_p99"), " ms", most=33),
        Figure("1000 of them taken again for ten seconds",
               "bench motion --count 10000 --frames 1000", of("retake_seconds"), " s", most=2)]),
}


class Reports:
    """Runs each command once, however many figures are of it."""

    def __init__(self, program, runs):
        self.program, self.runs, self.known = program, runs, {}

    def values(self, figure):
        if figure.command not in self.known:
            self.known[figure.command] = [self._run(figure.command) for _ in range(self.runs)]
        return [figure.number(report) for report in self.known[figure.command]]

    def _run(self, command):
        print(f"crowdbrush {command}", flush=True)
        done = subprocess.run([self.program, *command.split(), "--json"], capture_output=True,
                              text=True, check=False)
        lines = done.stdout.strip().splitlines()
        if not lines:
            raise SystemExit(f"{command}: {done.stderr.strip()}")
        return json.loads(lines[-1])


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as facts:
        names = [line.split(":")[1].strip() for line in facts if line.startswith("model name")]
    return f"{len(os.sched_getaffinity(0))} × {names[0] if names else platform.machine()}"


def section(title, note, figures, reports):
    lines = [f"## {title}", "", note, "", "| | measured | goal | `crowdbrush …` |",
             "|---|---|---|---|"]
    limits = {}
    for figure in figures:
        value = statistics.median(reports.values(figure))
        if not figure.is_reached(value) and figure.limit:
            limits.setdefault(figure.limit, []).append(figure.what)
        mark = "" if figure.is_reached(value) else " (missed)"
        lines.append(f"| {figure.what} | {value:.3g}{figure.unit} | {figure.goal()}{mark} | "
                     f"`{figure.command}` |")
    for limit, missed in limits.items():
        lines += ["", f"*{'; '.join(missed)}*: {limit}"]
    return lines + [""]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--runs", type=int, default=3, help="of each command")
    parser.add_argument("--only", default="", help="sections whose title has this in it; printed")
    given = parser.parse_args()
    reports = Reports(given.program, given.runs)
    times = "runs" if given.runs > 1 else "run"
    page = ["# Performance", "",
            f"Written by `./dev bench` on {processor()}, software rendering; each figure is the "
            f"median of {given.runs} {times}. Ratios hold from machine to machine better than "
            "milliseconds.", ""]
    for title, (note, figures) in SECTIONS.items():
        if given.only in title:
            page += section(title, note, figures, reports)
    text = "\n".join(page)
    if given.only:
        print(text)
    else:
        with open(PAGE, "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
