# SPDX-License-Identifier: MIT
"""Asks `convexact verify` and the independent judge about one output, and lists where they differ."""
import json
import subprocess
from fractions import Fraction

from judge import decide_convex, judge_files, squared_tolerance

# Of these claims a tolerance forgives distances; the figure that decides is beside each.
MEASURED = {"contains-input": "squared_distance", "mesh-planar": "squared_bend", "mesh-convex": "squared_concavity",
            "is-hull": "squared_hausdorff"}
COUNTS = ("facets", "vertices", "most_facet_vertices")


def ask_convexact(convexact, source, target, options, seconds):
    """The exit code (None: over time) and the JSON object, if there is one."""
    command = [convexact, "verify", str(source), str(target), "--json", *options]
    try:
        done = subprocess.run(command, capture_output=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return None, None
    try:
        return done.returncode, json.loads(done.stdout)
    except ValueError:
        return done.returncode, None


def shown(value):
    """A fraction for the eye, also beyond doubles."""
    try:
        return f"{float(value):.6g}"
    except OverflowError:
        return f"about 2^{value.numerator.bit_length() - value.denominator.bit_length()}"


class Differences:
    """Where the two disagree: (kind, claim, sentence), worst kinds first in KINDS."""
    KINDS = ("missed violation", "false accusation", "other exit", "distance", "volume", "count", "not decided")

    def __init__(self):
        self.found = []

    def add(self, kind, claim, sentence):
        self.found.append((kind, claim, sentence))


def expected_claims(verdict, diameter, tolerance):
    """The judge's claims, with a tolerance that `verdict` itself was made without."""
    claims, figures = dict(verdict.claims), verdict.figures
    allowed = squared_tolerance(tolerance, diameter)
    if allowed and "squared_distance" in figures:
        claims["contains-input"] = figures["squared_distance"] <= allowed
    if allowed and "squared_hausdorff" in figures:
        claims["is-hull"] = figures["squared_hausdorff"] <= allowed
    if allowed and claims["mesh-planar"] is False:
        claims["mesh-planar"] = not figures["not_simple"] and figures["squared_bend"] <= allowed
    if allowed and claims["mesh-convex"] is False:
        claims["mesh-convex"] = decide_convex(claims, figures, allowed)
    return claims


def compare_claims(claims, said, differences):
    for claim, expected in claims.items():
        status, sentence = said.get(claim, {}).get("status"), said.get(claim, {}).get("sentence", "")
        if expected is False and status == "holds":
            differences.add("missed violation", claim, sentence)
        elif expected is True and status == "violated":
            differences.add("false accusation", claim, sentence)
        elif expected is True and status == "not-applicable":
            differences.add("not decided", claim, sentence)


def distance_said(claim):
    found = claim.get("witness", {}).get("distance")
    return Fraction(found["squared"]) if found else None


def compare_figures(verdict, given, answer, said, differences):
    figures = verdict.figures
    outside = answer.get("outside")
    if outside and "outside" in figures and verdict.claims["candidate-solid"] and outside["points"] != figures["outside"]:
        differences.add("count", "outside", f"{outside['points']} points, by the judge {figures['outside']}")
    for name in COUNTS:
        if name in figures and name in answer["candidate"] and answer["candidate"][name] != figures[name]:
            differences.add("count", name, f"{answer['candidate'][name]}, by the judge {figures[name]}")
    for claim, figure in MEASURED.items():
        found, expected = distance_said(said.get(claim, {})), figures.get(figure)
        if found is not None and expected is not None and found != expected:
            note = " (the distance to a plane)" if found == figures.get("squared_excess") else ""
            differences.add("distance", claim, f"{shown(found)} squared{note}, by the judge {shown(expected)}")
    ratio = answer.get("tightness") and answer["tightness"]["volume_ratio"]["value"]
    if ratio is not None and "volume" in figures and given.volume():
        expected = figures["volume"] / given.volume()
        if abs(Fraction(ratio) - expected) > expected / 10 ** 12 + Fraction(1, 2 ** 1074):  # doubles end there
            differences.add("volume", "tightness", f"ratio {ratio}, by the judge {shown(expected)}")


def compare(convexact, given, source, target, numbers="binary64", tolerance=None, seconds=60, verdict=None):
    """Differences of the two on one output, verify's exit code and its answer; `given` is the judge's Input."""
    options = ["--asks", "hull", *(["--tolerance", tolerance] if tolerance else [])]
    options += {"binary64": [], "binary32": ["--numbers", "binary32"], "exact": ["--decimal", "exact"]}[numbers]
    status, answer = ask_convexact(convexact, source, target, options, seconds)
    differences = Differences()
    if given.volume() == 0:
        if status != 4:
            differences.add("other exit", "input", f"exit {status} for an input without volume")
        return differences, status, answer
    if status not in (0, 1) or answer is None or "claims" not in answer:
        message = answer.get("error", {}).get("message", "") if answer else ""
        differences.add("other exit", "", f"exit {status} {message}")
        return differences, status, answer
    verdict = verdict or judge_files(given, target, numbers, asks_hull=True)
    said = {claim["code"]: claim for claim in answer["claims"]}
    claims = expected_claims(verdict, given.squared_diameter(), tolerance or "0")
    compare_claims(claims, said, differences)
    if (status == 1) != (False in claims.values()) and not differences.found:
        differences.add("missed violation" if status == 0 else "false accusation", "verdict", f"exit {status}")
    if claims["candidate-finite"]:
        compare_figures(verdict, given, answer, said, differences)
    return differences, status, answer
