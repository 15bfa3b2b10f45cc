# SPDX-License-Identifier: MIT
"""What a run of ./dev field remembers, so that the next one resumes where it stopped and says before how long it will take."""
import hashlib
import json
import os
from pathlib import Path

HERE = Path(__file__).parent
# The judges and all that they stand on: an answer of other sources counts no more.
JUDGES = ("compare.py", "judge.py", "judge_parts.py", "mutate.py", "planar.py", "reading.py", "solid.py", "surface.py")


def digest_of(*pieces):
    digest = hashlib.sha256()
    for piece in pieces:
        data = piece if isinstance(piece, bytes) else repr(piece).encode()
        digest.update(len(data).to_bytes(8, "big") + data)
    return digest.hexdigest()


def judges_digest(*settings):
    """Of the independent judges, and of all else that a verdict depends on: settings, or the bytes of convexact."""
    return digest_of(*((HERE / name).read_bytes() for name in JUDGES), *settings)


def bytes_of(path):
    return path.read_bytes() if path.exists() else b""


def write_whole(path, text):
    """At once, so that a run that is stopped leaves the old text or the new one."""
    beside = path.with_name(f"{path.name}.{os.getpid()}")
    beside.write_text(text)
    beside.replace(path)


class Memory:
    """Of one input: what was found of each program, as long as nothing that it depends on has changed.

    The entry `input` is the input itself, written.
    """

    def __init__(self, path, fresh=False):
        self.path = path
        self.entries = {} if fresh else self.stored()

    def stored(self):
        return json.loads(self.path.read_text()) if self.path.exists() else {}

    def recall(self, name, digest):
        entry = self.entries.get(name)
        return entry["found"] if entry and entry["digest"] == digest else None

    def keep(self, name, digest, found, seconds):
        """Beside what others have kept in the file since this one read it."""
        self.entries[name] = {"digest": digest, "found": found, "seconds": round(seconds, 3)}
        write_whole(self.path, json.dumps({**self.stored(), name: self.entries[name]}))

    def seconds(self, name):
        """That this took, or if it was never run, the median of what others took; None without any."""
        if name in self.entries:
            return self.entries[name]["seconds"]
        known = sorted(entry["seconds"] for other, entry in self.entries.items() if other != "input")
        return known[len(known) // 2] if known else None


def expectation(known, unknown, jobs):
    """A line for the start of a run: `known` are measured seconds, `unknown` are guessed ones."""
    total = (sum(known) + sum(unknown)) / max(jobs, 1)
    words = f"{total:.0f} s" if total < 90 else f"{total / 60:.0f} min"
    share = f", {len(unknown)} of {len(known) + len(unknown)} guessed" if unknown else ""
    return f"expected: {words}{share}"
