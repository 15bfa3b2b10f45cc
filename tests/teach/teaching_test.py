#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs what docs/teaching.md shows, and checks what it says about the code and about the lessons.

Usage: teaching_test.py --convexact PROGRAM

- A block ```console has commands after '$ ', and below each its output. They are run in order, in one folder
  that has the files of docs/lessons. In an output a line '...' stands for any lines, and '...' within a line for
  any text. An output of which another digit would pass unnoticed is an error, too.
- A table row with `Name` and [file](file) is about a function that the file must define.
- NAME.html#step is a step that the lesson has, as `dev lessons` makes it.
- What is said about the needle in doubles is computed here, by the definition.
"""
import argparse
import difflib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
EXERCISE = re.compile(r"^### (Exercise .*?)$(.*?)(?=^##|\Z)", re.MULTILINE | re.DOTALL)
POINTER = re.compile(r"^\|.*?\| ((?:`[\w:]+`(?:, )?)+) \| \[[^\]]*\]\(([^)]+)\) \|$", re.MULTILINE)


def commands(text):
    """(line of the document, command, its output as the document has it) of every block."""
    found = []
    for block in BLOCK.finditer(text):
        line = text.count("\n", 0, block.start(1))
        for line, content in enumerate(block.group(1).splitlines(keepends=True), line + 1):
            if content.startswith("$ "):
                found.append((line, content[2:].rstrip("\n"), []))
            elif found:
                found[-1][2].append(content)
    return [(line, command, "".join(output)) for line, command, output in found]


def is_shown_as(output, shown):
    pattern = "".join("(?:.*\n)*?" if line == "...\n" else ".*".join(map(re.escape, line.split("...")))
                      for line in shown.splitlines(keepends=True))
    return re.fullmatch(pattern, output) is not None


def wrong_versions(shown):
    """The output with one of its lines changed: each digit of it, or else a letter more."""
    lines = shown.splitlines(keepends=True)
    for k, line in enumerate(lines):
        for digit in re.finditer(r"\d", line):
            other = str((int(digit.group()) + 1) % 10)
            yield "".join([*lines[:k], line[:digit.start()] + other + line[digit.end():], *lines[k + 1:]])
        if line != "...\n":
            yield "".join([*lines[:k], "x" + line, *lines[k + 1:]])


def run_all(text, program, lessons):
    """Sentences about what went wrong."""
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder, "work")
        shutil.copytree(lessons, work)
        pathlib.Path(folder, "bin").mkdir()
        pathlib.Path(folder, "bin", "convexact").symlink_to(program)
        environment = {**os.environ, "PATH": f"{folder}/bin:{os.environ['PATH']}"}
        for line, command, shown in commands(text):
            run = subprocess.run(["bash", "-c", command], cwd=work, env=environment, text=True, timeout=600,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            if run.returncode not in (0, 1):  # 1 is the oracle's no
                wrong.append(f"line {line}: exit code {run.returncode}: {command}\n{run.stdout}")
            elif not is_shown_as(run.stdout, shown):
                difference = difflib.ndiff(shown.splitlines(keepends=True), run.stdout.splitlines(keepends=True))
                wrong.append(f"line {line}: another output: {command}\n" + "".join(difference))
            elif any(is_shown_as(run.stdout, other) for other in wrong_versions(shown)):
                wrong.append(f"line {line}: another number or word in this output would pass: {command}")
    return wrong


def missing_functions(text, document):
    """Definitions begin in column 1, of members in the class in column 3."""
    wrong = []
    for names, target in POINTER.findall(text):
        source = (document.parent / target).read_text(encoding="utf-8")
        for name in re.findall(r"`([\w:]+)`", names):
            owner, _, member = name.rpartition("::")
            is_defined = re.search(rf"^(?! |//)[^;\n]*\b{name}\(", source, re.MULTILINE)
            if owner and re.search(rf"^class {owner}\b", source, re.MULTILINE):
                is_defined = is_defined or re.search(rf"^  (?! |//)[^;\n]* {member}\(", source, re.MULTILINE)
            if not is_defined:
                wrong.append(f"{target} does not define {name}")
    return wrong


def make_lessons(program, folder):
    """The records of the lessons, by name, made as `dev` makes them; of those in the plane, which have none, nothing."""
    made = {}
    for call in re.findall(r"^  \$program (.*)$", (ROOT / "dev").read_text(encoding="utf-8"), re.MULTILINE):
        call = call.replace("$folder", str(folder))
        if "--plane" not in call:
            call = call.replace(".html", ".json")
        subprocess.run([program, *call.split()], cwd=ROOT, check=True, timeout=600, stdout=subprocess.DEVNULL)
    made.update((path.stem, None) for path in folder.glob("*.html"))
    for path in sorted(folder.glob("*.json")):
        made[path.stem] = json.loads(path.read_text(encoding="utf-8"))
    return made


def missing_steps(text, lessons):
    pages = "".join(p.read_text(encoding="utf-8") for p in sorted((ROOT / "src/teach/page").glob("*.js")))
    wrong = []
    for name, step in re.findall(r"`(\w+)\.html#([\w-]+)`", text):
        lesson = lessons[name]
        numbered = re.fullmatch(r"(hull|removal|verification)-(\d+)(?:-ring|-cap)?", step)
        if numbered is None:
            exists = f'"{step}"' in pages
        elif numbered.group(1) == "hull":
            exists = "hull" in lesson and int(numbered.group(2)) <= len(lesson["hull"]["insertions"])
        else:
            exists = any(removal["step"] == int(numbered.group(2)) for removal in lesson["removals"])
        if not exists:
            wrong.append(f"{name}.html has no step {step}")
    return wrong


def gap(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]))


def height(a, b, c, d):
    return -a[3] * gap(b, c, d) + b[3] * gap(a, c, d) - c[3] * gap(a, b, d) + d[3] * gap(a, b, c)


def in_doubles(lesson):
    """How many determinants the checks have, how many of them have another sign in doubles, computed term by term as
    the page does, and how many checks would fail with these signs."""
    def sign(planes, check):
        rows = [planes[i] for i in check["triangle"]]
        value = gap(*rows) if check["plane"] is None else height(*rows, planes[check["plane"]])
        return (value > 0) - (value < 0)

    exact = [[int(x) for x in entry["plane"]] for entry in lesson["halfspaces"]]
    near = [[float(x) for x in plane] for plane in exact]
    checks = [c for removal in lesson["removals"] for c in removal["checks"] if c["triangle"] and c["value"]]
    allowed = {">0": [1], ">=0": [0, 1], "<=0": [-1, 0], "=0": [0]}
    return (len(checks), sum(sign(exact, c) != sign(near, c) for c in checks),
            sum(sign(near, c) not in allowed[c["wants"]] for c in checks))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--convexact", required=True, type=pathlib.Path)
    program = parser.parse_args().convexact.resolve()
    document = ROOT / "docs" / "teaching.md"
    text = document.read_text(encoding="utf-8")
    exercises, pointers = EXERCISE.findall(text), POINTER.findall(text)
    wrong = run_all(text, program, document.parent / "lessons")
    wrong += [f"{title}: the program does not check it" for title, body in exercises if not BLOCK.search(body)]
    wrong += missing_functions(text, document)
    with tempfile.TemporaryDirectory() as folder:
        lessons = make_lessons(program, pathlib.Path(folder))
    wrong += [f"no lesson {name}" for name in re.findall(r"^\| `(\w+)\.html`", text, re.MULTILINE) if name not in lessons]
    wrong += missing_steps(text, lessons)
    total, others, failures = in_doubles(lessons["needle"])
    for sentence in [f"{others} of its {total} determinants have another sign", f"{failures} of the checks would fail"]:
        if sentence not in " ".join(text.split()):
            wrong.append(f"of the needle in doubles: {sentence}")
    if len(exercises) < 5 or len(pointers) < 10 or len(lessons) < 5:
        wrong.append("exercises, pointers or lessons are not where they are looked for")
    print("\n".join(wrong) or f"{len(commands(text))} commands of {len(exercises)} exercises answer as shown; "
          f"{len(pointers)} rows lead into the code; {len(lessons)} lessons have the steps")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
