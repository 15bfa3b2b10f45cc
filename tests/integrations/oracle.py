# SPDX-License-Identifier: MIT
"""Asks `convexact verify --stdio` from Python: one process for a whole test run."""
import json
import os
import subprocess


class Oracle:
    def __init__(self, program=os.environ.get("CONVEXACT", "convexact")):
        self.process = subprocess.Popen([program, "verify", "--stdio"], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def verify(self, points, candidate, **questions):
        """The verdict as a dictionary. float.hex() keeps every coordinate to the last bit."""
        request = {"points": as_text(points),
                   "candidate": {key: rows if key == "faces" else as_text(rows)
                                 for key, rows in candidate.items()}, **questions}
        self.process.stdin.write(json.dumps(request) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            raise ValueError(answer["error"]["message"])
        return answer

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        return self.process.wait()


def as_text(rows):
    return [[float(x).hex() for x in row] for row in rows]
