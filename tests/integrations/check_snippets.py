#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_snippets.py DOCUMENT - every code block under a comment that names a file holds that file,
but for its licence line. So what the document shows is what the tests run. Exits 1 if one differs."""
import pathlib
import re
import sys

SNIPPET = re.compile(r"<!-- (\S+) -->\n```\w*\n(.*?)```\n", re.DOTALL)


def without_licence(text):
    return "".join(line for line in text.splitlines(keepends=True) if "SPDX-" not in line)


def main(document):
    path = pathlib.Path(document)
    text = path.read_text(encoding="utf-8")
    root = path.resolve().parent.parent
    shown = SNIPPET.findall(text)
    files = {p for p in (root / "tests" / "integrations").iterdir()
             if p.suffix in {".py", ".cpp"} or p.name == "ci_step.sh"} - {pathlib.Path(__file__).resolve()}
    wrong = [name for name, code in shown
             if code != without_licence((root / name).read_text(encoding="utf-8"))]
    missing = {str(p.relative_to(root)) for p in files} - {name for name, _ in shown}
    for name in wrong:
        print(f"{document}: the code under {name} is not that file")
    for name in sorted(missing):
        print(f"{document}: {name} is not shown")
    return 1 if wrong or missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
