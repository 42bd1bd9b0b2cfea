"""Fingerprints of the scripts that make golden films.

Prints one JSON object: for each scene file, and for each task of an assignment and its
ties, a SHA-256 of all that decides the pixels of its films but the scene and the seed: every
script that is imported on the way, and the versions of the packages. Docstrings,
comments and layout count for nothing, so only a change that could change a film
changes its fingerprint. Needs Python's standard library alone.
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


def of_task(assignment, task):
    """The fingerprint of the films of a task's questions."""
    return fingerprint([SHARED, assignment], ["question_films", f"questions.{task}"])


def of_ties(assignment):
    """The fingerprint of an assignment's tie films."""
    return fingerprint([SHARED, assignment], ["tie_films", "questions.ties"])


def main():
    """Read the command line, print the fingerprints."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", type=Path, metavar="SCENE.toml")
    parser.add_argument("--questions", type=Path, metavar="ASSIGNMENT", help="of its tasks, too")
    arguments = parser.parse_args()
    found = {path.stem: of_scene(path) for path in arguments.scenes}
    if arguments.questions:
        table = tomllib.loads((arguments.questions / "assignment.toml").read_text("utf-8"))
        for task in table["task"]:
            found[f"probes/{task['name']}"] = of_task(arguments.questions, task["name"])
        if (arguments.questions / "questions" / "ties.py").is_file():
            found["ties"] = of_ties(arguments.questions)
    print(json.dumps(found))


if __name__ == "__main__":
    main()
