"""Make golden films with Mitsuba 3.

Standard output carries one JSON line at the start ({"mitsuba", "variant",
"total"}) and one per finished item ({"name", "files"}); everything for people goes
to standard error. Exit 0, or 2 when a scene is refused (the others are still made).
"""

import argparse
import faulthandler
import json
import multiprocessing
import os
import sys
import tomllib
from importlib import import_module
from importlib.metadata import version
from pathlib import Path

SEED = "PINHOLE_SEED"


def render_scene(path, folder):
    """One scene's four films."""
    from scene_films import render

    return render(path, folder)


def render_questions(assignment, task, group, seed, count, folder):
    """The three films of a group of questions."""
    from question_films import render

    return render(assignment, task, group, seed, count, folder)


def render_fresh_questions(assignment, task, group, seed, count, folder):
    """The three films of a group of fresh questions."""
    from fresh_questions import render

    return render(assignment, task, group, seed, count, folder)


def render_own_questions(path, shape, name, folder):
    """The three films of the questions in a file of examples."""
    from own_questions import render

    limit_time()
    return render(path, shape, name, folder)


def limit_time():
    """End this process if it runs for another minute. A student may have written the file."""
    faulthandler.dump_traceback_later(60, exit=True)


def render_ties(assignment, task, seed, folder):
    """The tie film of a task."""
    from tie_films import render

    return render(assignment, task, seed, folder)


def render_random_scene(assignment, seed, index, folder):
    """One random scene and its four films."""
    from random_scenes import render_random

    return render_random(assignment, seed, index, folder)


def run(item):
    """Do one item in a worker: (report or None, message for people or None).

    `item` is (function, arguments). Mitsuba is imported by the functions, in the
    workers only: its threads would not survive a fork, and `--help` stays quick.
    """
    from scene import SceneError

    work, arguments = item
    try:
        return work(*arguments), None
    except SceneError as error:
        return None, str(error)


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


def question_items(arguments):
    """One item for each group of the committed questions; a kind may set its own number
    of questions."""
    from question_films import QUESTIONS

    def count_of(task):
        return getattr(import_module(f"kinds.{task['kind']}"), "QUESTIONS", QUESTIONS)

    return group_items(arguments, render_questions, count_of)


def fresh_question_items(arguments):
    """One item for each group of fresh questions."""
    from fresh_questions import count_of

    return group_items(arguments, render_fresh_questions, lambda task: count_of(task["kind"]))


def group_items(arguments, render, count_of):
    """One item for each group of each task of the assignment."""
    from question_films import questions_of

    folder, assignment = arguments.out / "probes", arguments.assignment
    folder.mkdir(parents=True, exist_ok=True)
    with (assignment / "assignment.toml").open("rb") as file:
        tasks = tomllib.load(file)["task"]
    return [
        (render, (assignment, task["name"], group, arguments.seed, count, folder))
        for task in tasks
        for count in [arguments.count or count_of(task)]
        for group in questions_of(assignment, task["name"]).GROUPS
    ]


def own_question_items(arguments):
    """The one item for a file of examples."""
    limit_time()
    folder = arguments.out / "probes"
    return [(render_own_questions, (arguments.file, arguments.shape, arguments.name, folder))]


def tie_items(arguments):
    """One item for each task of the assignment that has ties."""
    from tie_films import tasks

    folder, assignment = arguments.out / "ties", arguments.assignment
    items = [
        (render_ties, (assignment, task, arguments.seed, folder)) for task in tasks(assignment)
    ]
    if items:
        folder.mkdir(parents=True, exist_ok=True)
    return items


def whole_rows(text):
    """A number of questions that fills the rows of a question film."""
    if not (text.isdigit() and int(text) and int(text) % 32 == 0):
        raise argparse.ArgumentTypeError(f"{text} is not a multiple of 32")
    return int(text)


def absolute(path):
    """A path that stays the same in another current folder."""
    return Path(path).absolute()


def main():
    """Read the command line, do its items, return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(required=True)
    scenes = commands.add_parser("scenes", help="render scene files")
    scenes.add_argument("scenes", nargs="+", type=absolute, metavar="SCENE.toml")
    scenes.set_defaults(items=lambda a: [(render_scene, (s, a.out)) for s in a.scenes])
    questions = commands.add_parser("questions", help="ask an assignment's questions")
    questions.set_defaults(items=question_items)
    fresh = commands.add_parser("fresh-questions", help="ask questions that nobody has seen")
    fresh.set_defaults(items=fresh_question_items)
    for command in (questions, fresh):
        command.add_argument(
            "--count", type=whole_rows, help="questions in each group, a multiple of 32"
        )
    own = commands.add_parser("own-questions", help="answer the questions of a file of examples")
    own.add_argument("file", type=absolute, metavar="FILE.toml")
    own.add_argument("--shape", required=True, help="what all of them are about")
    own.add_argument("--name", required=True, help="what to call the films")
    own.set_defaults(items=own_question_items)
    ties = commands.add_parser("ties", help="draw questions of which many are exact ties")
    ties.set_defaults(items=tie_items)
    random = commands.add_parser("random-scenes", help="draw scenes and render them")
    random.add_argument("--count", type=int, default=3, help="how many scenes")
    random.set_defaults(items=lambda a: [
        (render_random_scene, (a.assignment, a.seed, k, a.out)) for k in range(a.count)
    ])
    for command in (questions, fresh, ties, random):
        command.add_argument(
            "assignment", type=absolute, metavar="ASSIGNMENT",
            help="the assignment's folder, with assignment.toml and questions",
        )
        # Other users can read the arguments of a program, but not its environment.
        command.add_argument(
            "--seed", type=int, required=SEED not in os.environ, default=os.environ.get(SEED),
            metavar="N", help=f"by default, the environment variable {SEED}",
        )
    for command in (scenes, questions, fresh, own, ties, random):
        command.add_argument("--out", type=absolute, required=True, metavar="DIR")
        command.add_argument("--jobs", type=int, default=2, metavar="N")
    arguments = parser.parse_args()
    # Python and Mitsuba load modules and plugins from the current folder, which may be a student's.
    os.chdir(Path(__file__).parent)
    arguments.out.mkdir(parents=True, exist_ok=True)
    return run_all(arguments.items(arguments), arguments.jobs)


if __name__ == "__main__":
    sys.exit(main())
