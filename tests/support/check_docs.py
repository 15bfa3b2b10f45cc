#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the documents: relative links lead to files, and every citation key used in code or
documents stands in docs/references.md. Prints what is broken and exits 1 if anything is."""
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)")
KEY = re.compile(r"\[([A-Z][A-Za-z]*(?:[A-Z][a-z]+)*\d{4}[a-z]?)(?:, [^\]]*)?\]|\[(deBerg\d{4})(?:, [^\]]*)?\]")


def documents():
    return sorted(p for p in pathlib.Path(".").rglob("*.md") if not p.parts[0].startswith("build"))


def main():
    broken = []
    for document in documents():
        for target in LINK.findall(document.read_text(encoding="utf-8")):
            if not (document.parent / target).exists():
                broken.append(f"{document}: link to {target}, which is not there")
    known = pathlib.Path("docs/references.md").read_text(encoding="utf-8")
    sources = [p for top in ("include", "src", "tests", "fuzz") for p in pathlib.Path(top).rglob("*.[hc]pp")]
    for path in [*sources, *documents()]:
        for first, second in KEY.findall(path.read_text(encoding="utf-8")):
            key = first or second
            if f"**{key}**" not in known:
                broken.append(f"{path}: [{key}] is not in docs/references.md")
    print("\n".join(broken) if broken else "docs: every link and citation leads somewhere")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
