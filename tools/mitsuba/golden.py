"""Make golden films with Mitsuba 3.

Standard output carries one JSON line at the start ({"mitsuba", "variant",
"total"}) and one per finished item ({"name", "files", "exempt", "sensor",
"seconds"}); everything for people goes to standard error. Exit 0, or 2 when a
scene is refused (the others are still made).
"""

import argparse
import json
import multiprocessing
import sys
import time
from importlib.metadata import version
from pathlib import Path


def render_scene(path, folder):
    """One scene's four films."""
    from scene_films import render

    return render(path, folder)


def render_probe(task, group, seed, count, folder):
    """One probe's three films."""
    from probes import render

    return render(task, group, seed, count, folder)


def render_random_scene(seed, index, folder):
    """One random scene and its four films."""
    from random_scenes import render_random

    return render_random(seed, index, folder)


def run(item):
    """Do one item in a worker: (report or None, what to tell people or None).

    `item` is (function, arguments). Mitsuba is imported by the functions, in the
    workers only: its threads would not survive a fork, and `--help` stays quick.
    """
    from scene import SceneError

    work, arguments = item
    start = time.perf_counter()
    try:
        report = work(*arguments)
    except SceneError as error:
        return None, str(error)
    return report | {"seconds": round(time.perf_counter() - start, 3)}, None


def run_all(items, jobs):
    """Do all items in `jobs` processes and print a JSON line for each; exit code."""
    say({"mitsuba": version("mitsuba"), "variant": "scalar_rgb", "total": len(items)})
    refused = 0
    with multiprocessing.get_context("spawn").Pool(jobs) as pool:
        for report, problem in pool.imap_unordered(run, items):
            if problem:
                refused += 1
                print(problem, file=sys.stderr, flush=True)
            else:
                say(report)
    return 2 if refused else 0


def say(line):
    """One line of JSON on standard output, at once."""
    print(json.dumps(line), flush=True)


def probe_items(arguments):
    """One item for each task and group."""
    from probes import PROBES

    folder = arguments.out / "probes"
    folder.mkdir(parents=True, exist_ok=True)
    return [
        (render_probe, (task, group, arguments.seed, arguments.count, folder))
        for task, group in PROBES
    ]


def whole_rows(text):
    """A number of questions that fills the rows of a probe's film."""
    if not (text.isdigit() and int(text) and int(text) % 32 == 0):
        raise argparse.ArgumentTypeError(f"{text} is not a multiple of 32")
    return int(text)


def main():
    """Read the command line, do its items, return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(required=True)
    scenes = commands.add_parser("scenes", help="render scene files")
    scenes.add_argument("scenes", nargs="+", type=Path, metavar="SCENE.toml")
    scenes.set_defaults(items=lambda a: [(render_scene, (s, a.out)) for s in a.scenes])
    probes = commands.add_parser("probes", help="make probe films, one task at a time")
    probes.add_argument(
        "--count", type=whole_rows, default=512, help="questions in each, a multiple of 32"
    )
    probes.set_defaults(items=probe_items)
    random = commands.add_parser("random-scenes", help="draw scenes and render them")
    random.add_argument("--count", type=int, default=3, help="how many scenes")
    random.set_defaults(items=lambda a: [
        (render_random_scene, (a.seed, k, a.out)) for k in range(a.count)
    ])
    for command in (probes, random):
        command.add_argument("--seed", type=int, required=True, metavar="N")
    for command in (scenes, probes, random):
        command.add_argument("--out", type=Path, required=True, metavar="DIR")
        command.add_argument("--jobs", type=int, default=2, metavar="N")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    return run_all(arguments.items(arguments), arguments.jobs)


if __name__ == "__main__":
    sys.exit(main())
