#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Adds up what a test run did: the cases of each doctest program, and every other test as one.

Usage: count_tests.py meson-logs/testlog.json
Prints each skipped test with its reason, then 'N passed, N failed, N skipped'.
Exits 1 if anything failed or nothing ran.
"""
import json
import re
import sys

CASES = re.compile(r"^\[doctest\] test cases: +(\d+) \| +(\d+) passed \| +(\d+) failed \| +(\d+) skipped")


def count(test):
    """(passed, failed, skipped) of one line of the log."""
    if test["result"] == "SKIP":
        return 0, 0, 1
    cases = [CASES.match(line) for line in test.get("stdout", "").splitlines()]
    cases = [match for match in cases if match]
    passed = sum(int(match.group(2)) for match in cases)
    failed = sum(int(match.group(3)) for match in cases)
    # A program that is told what to run leaves the rest to runs of their own.
    told = any(argument.startswith(("--test-case=", "--source-file")) for argument in test["command"])
    skipped = 0 if told else sum(int(match.group(4)) for match in cases)
    if told and not passed:
        failed = max(failed, 1)  # the name of a file or case that there is no more
    if test["result"] == "OK":
        return (passed, failed, skipped) if cases else (1, 0, 0)
    return passed, max(failed, 1), skipped  # a crash or a time-out has no line of its own


def main():
    total = [0, 0, 0]
    with open(sys.argv[1], encoding="utf-8") as log:
        for line in log:
            test = json.loads(line)
            counts = count(test)
            total = [a + b for a, b in zip(total, counts)]
            if test["result"] == "SKIP":
                reason = test.get("stdout", "").strip().splitlines()
                print(f"{test['name']}: {reason[-1] if reason else 'skipped'}")
    print("%d passed, %d failed, %d skipped" % tuple(total))
    return 1 if total[1] or not total[0] else 0


if __name__ == "__main__":
    sys.exit(main())
