#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_snippets.py DOCUMENT [FOLDER] [FILE=PROGRAM...] - every code block under a comment that names
a file holds that file, but for its licence line. So what the document shows is what the tests run.
Every file of FOLDER is shown. The text block behind a FILE is what its PROGRAM prints. Exits 1 if
something differs."""
import pathlib
import re
import subprocess
import sys

SNIPPET = re.compile(r"<!-- (\S+) -->\n```\w*\n(.*?)```\n(?:\n```text\n(.*?)```\n)?", re.DOTALL)


def without_licence(text):
    return "".join(line for line in text.splitlines(keepends=True) if "SPDX-" not in line)


def files_of(folder):
    return {p for p in folder.iterdir() if p.suffix in {".py", ".cpp"} or p.name == "ci_step.sh"}


def main(document, *arguments):
    path = pathlib.Path(document)
    text = path.read_text(encoding="utf-8")
    root = path.resolve().parent.parent
    shown = SNIPPET.findall(text)
    programs = dict(argument.split("=") for argument in arguments if "=" in argument)
    files = set().union(*(files_of(root / name) for name in arguments if "=" not in name))
    files -= {pathlib.Path(__file__).resolve()}
    wrong = [name for name, code, _ in shown
             if code != without_licence((root / name).read_text(encoding="utf-8"))]
    missing = {str(p.relative_to(root)) for p in files} - {name for name, *_ in shown}
    missing |= programs.keys() - {name for name, *_ in shown}
    for name in wrong:
        print(f"{document}: the code under {name} is not that file")
    for name, _, text in shown:
        if name not in programs:
            continue
        printed = subprocess.run([programs[name]], check=True, capture_output=True, text=True).stdout
        if printed != text:
            print(f"{document}: {name} prints\n{printed}and not\n{text}")
            wrong.append(name)
    for name in sorted(missing):
        print(f"{document}: {name} is not shown")
    return 1 if wrong or missing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
