#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the documents: relative links lead to files and to headings in them, every citation key
used in code or documents stands in docs/references.md, every claim and note that the schemas
name has a heading in docs/verdicts.md, and no line is left of a merge. Prints what is broken and exits 1 if anything is."""
import json
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)#:\s]*)(?:#([^)\s]*))?\)")
KEY = re.compile(r"\[([A-Z][A-Za-z]*(?:[A-Z][a-z]+)*\d{4}[a-z]?)(?:, [^\]]*)?\]|\[(deBerg\d{4})(?:, [^\]]*)?\]")
LEFT_OF_MERGE = re.compile(r"^(<{7}|>{7}) ", re.MULTILINE)
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)


def documents():
    return sorted(p for p in pathlib.Path(".").rglob("*.md") if not p.parts[0].startswith("build"))


def anchors(document):
    """The anchors that GitHub gives to the headings of a document."""
    text = FENCE.sub("", document.read_text(encoding="utf-8"))
    found, counts = set(), {}
    for heading in re.findall(r"^#+ +(.*?) *$", text, re.MULTILINE):
        name = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", name).replace(" ", "-")
        found.add(f"{name}-{counts[name]}" if name in counts else name)
        counts[name] = counts.get(name, 0) + 1
    return found


def codes_of(schema):
    """Every value that a property called "code" may have, anywhere in a schema."""
    if isinstance(schema, list):
        return [code for entry in schema for code in codes_of(entry)]
    if not isinstance(schema, dict):
        return []
    code = schema.get("properties", {}).get("code", {})
    return code.get("enum", []) + [c for entry in schema.values() for c in codes_of(entry)]


def main():
    broken = []
    for document in documents():
        whole = document.read_text(encoding="utf-8")
        text = FENCE.sub("", whole)
        if LEFT_OF_MERGE.search(whole):
            broken.append(f"{document}: both sides of a merge")
        for target, anchor in LINK.findall(text):
            path = document.parent / target if target else document
            if not path.exists():
                broken.append(f"{document}: link to {target}, which is not there")
            elif anchor and path.suffix == ".md" and anchor not in anchors(path):
                broken.append(f"{document}: link to {target}#{anchor}, a heading that is not there")
    known = pathlib.Path("docs/references.md").read_text(encoding="utf-8")
    sources = [p for top in ("include", "src", "tests", "fuzz") for p in pathlib.Path(top).rglob("*.[hc]pp")]
    for path in [*sources, *documents()]:
        for first, second in KEY.findall(path.read_text(encoding="utf-8")):
            key = first or second
            if f"**{key}**" not in known:
                broken.append(f"{path}: [{key}] is not in docs/references.md")
    sections = anchors(pathlib.Path("docs/verdicts.md"))
    for name in ("verdict", "trace_verdict"):
        schema = json.loads(pathlib.Path(f"docs/schema/{name}.schema.json").read_text(encoding="utf-8"))
        broken += [f"docs/verdicts.md: no heading {code}" for code in codes_of(schema) if code not in sections]
    print("\n".join(broken) if broken else "docs: every link, heading and citation leads somewhere")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
