"""Fingerprints of the scripts that make golden films.

Prints one JSON object with a SHA-256 for each scene file, for each task of an assignment,
and for its ties (or, with fresh questions, for its random scenes). The hash covers
everything that decides the pixels of the films except the scene and the seed: every
imported script, and the versions of the packages. It ignores docstrings, comments and
layout, so only a change that could change a film changes its fingerprint. Needs only
Python's standard library.
"""

import argparse
import ast
import hashlib
import json
import tomllib
from pathlib import Path

SHARED = Path(__file__).parent


def scripts(folders, modules):
    """The files of these modules and of all they import, as far as they lie in
    `folders`: {module: file}."""
    found, waiting = {}, list(modules)
    while waiting:
        module = waiting.pop()
        file = _file(folders, module)
        if module in found or file is None:
            continue
        found[module] = file
        waiting += _imports(ast.parse(file.read_text(encoding="utf-8")))
    return found


def _file(folders, module):
    for folder in folders:
        path = folder.joinpath(*module.split("."))
        for file in (path.with_suffix(".py"), path / "__init__.py"):
            if file.is_file():
                return file
    return None


def _imports(tree):
    """Every name that may be an imported module, with the packages around it."""
    for node in ast.walk(tree):
        names = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        for name in names:
            parts = name.split(".")
            yield from (".".join(parts[: k + 1]) for k in range(len(parts)))


def meaning(node):
    """A syntax tree without docstrings, as lists and strings.

    Unlike the text of `ast.dump`, it is the same for all versions of Python: a field
    that is empty is left out, as older versions do not have it.
    """
    if isinstance(node, list):
        return [meaning(item) for item in node if not _is_docstring(item)]
    if not isinstance(node, ast.AST):
        return repr(node)
    fields = ((name, value) for name, value in ast.iter_fields(node) if value not in (None, []))
    return [type(node).__name__, *([name, meaning(value)] for name, value in fields)]


def _is_docstring(node):
    """Whether a statement is a string and nothing else."""
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )


def fingerprint(folders, modules):
    """The fingerprint of films that these modules make."""
    parts = {
        module: meaning(ast.parse(file.read_text(encoding="utf-8")))
        for module, file in scripts(folders, modules).items()
    }
    requirements = (SHARED / "requirements.txt").read_text(encoding="utf-8")
    lines = (line.split("#")[0].strip() for line in requirements.splitlines())
    parts["requirements"] = sorted(filter(None, lines))
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def of_scene(path):
    """The fingerprint of a scene's films."""
    table = tomllib.loads(path.read_text(encoding="utf-8"))
    shapes = {f"shapes.{thing['type']}" for thing in table.get("object", [])}
    return fingerprint([SHARED], ["scene_films", *shapes])


def of_task(assignment, task, films="question_films"):
    """The fingerprint of the films of a task's questions, made by the module `films`."""
    return fingerprint([SHARED, assignment], [films, f"questions.{task}"])


def of_random_scenes(assignment):
    """The fingerprint of what is drawn for random scenes."""
    return fingerprint([SHARED, assignment], ["random_scenes", "questions.random_scene"])


def of_ties(assignment):
    """The fingerprint of an assignment's tie films."""
    return fingerprint([SHARED, assignment], ["tie_films", "questions.ties"])


def tasks(assignment):
    """The names of an assignment's tasks."""
    table = tomllib.loads((assignment / "assignment.toml").read_text("utf-8"))
    return [task["name"] for task in table["task"]]


def main():
    """Read the command line, print the fingerprints."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", type=Path, metavar="SCENE.toml")
    questions = parser.add_mutually_exclusive_group()
    questions.add_argument(
        "--questions", type=Path, metavar="ASSIGNMENT", help="also fingerprint its questions"
    )
    questions.add_argument(
        "--fresh", type=Path, metavar="ASSIGNMENT",
        help="also fingerprint its fresh questions and random scenes",
    )
    arguments = parser.parse_args()
    found = {path.stem: of_scene(path) for path in arguments.scenes}
    if arguments.questions:
        for task in tasks(arguments.questions):
            found[f"probes/{task}"] = of_task(arguments.questions, task)
        if (arguments.questions / "questions" / "ties.py").is_file():
            found["ties"] = of_ties(arguments.questions)
    if arguments.fresh:
        for task in tasks(arguments.fresh):
            found[f"probes/{task}"] = of_task(arguments.fresh, task, "fresh_questions")
        found["random_scenes"] = of_random_scenes(arguments.fresh)
    print(json.dumps(found))


if __name__ == "__main__":
    main()
