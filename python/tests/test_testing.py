# SPDX-License-Identifier: MIT
"""Assertions, the plugin, and that every example of the documents runs."""
import doctest
import json
import os
import re
import subprocess
import sys
import time
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import convexact as cx
from convexact import testing

CUBE = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
ROOT = Path(__file__).resolve().parents[2]


def test_assertions_say_claim_witness_and_input() -> None:
    testing.assert_is_hull(CUBE, CUBE)
    testing.assert_encloses(CUBE, np.array(CUBE) * 3 - 1)
    testing.assert_covers((CUBE, QUADS), [(CUBE, QUADS)])
    with pytest.raises(AssertionError, match=r"(?s)contains-input: 1 point outside.*points = \[\[0.0, 0.0, 0.0\]"):
        testing.assert_encloses(CUBE, CUBE[:7])
    with pytest.raises(AssertionError, match="is-hull"):
        testing.assert_is_hull(CUBE, np.array(CUBE) * 3 - 1)
    with pytest.raises(AssertionError, match="covers-surface"):
        testing.assert_covers((CUBE, QUADS), [CUBE[:4] + [[0.5, 0.5, 0.5]]])


def run_pytest(*arguments: Any) -> Any:
    installed = any(point.value == "convexact.pytest_plugin" for point in entry_points(group="pytest11"))
    plugin = [] if installed else ["-p", "convexact.pytest_plugin"]
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *plugin, *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, env=os.environ)


def test_the_example_for_pytest_runs(tmp_path: Any) -> None:
    ran = run_pytest(ROOT / "python" / "examples" / "verify_in_pytest.py", f"--rootdir={tmp_path}")
    assert "2 passed" in ran.stdout, ran.stdout


def test_the_plugin_keeps_what_fails(tmp_path: Any) -> None:
    test = tmp_path / "test_mine.py"
    test.write_text(
        f"CUBE = {CUBE}\n"
        "def test_loses_a_corner(oracle):\n    oracle.assert_is_hull(CUBE, CUBE[:7])\n"
        "def test_is_right(oracle):\n    oracle.assert_is_hull(CUBE, CUBE)\n",
        encoding="utf-8",
    )
    kept = tmp_path / "kept"
    ran = run_pytest(test, "--convexact-keep", kept)
    assert "1 failed, 1 passed" in ran.stdout
    assert "convexact verify" in ran.stdout and "--asks hull" in ran.stdout
    assert cx.hull(kept / "test_loses_a_corner-1.obj").volume == 1
    assert not cx.verify(kept / "test_loses_a_corner-1.obj", kept / "test_loses_a_corner-1-candidate.obj", asks="hull").ok


def test_examples_in_docstrings() -> None:
    for module, least in ((cx, 10), (cx._queries, 8)):  # pylint: disable=protected-access
        results = doctest.testmod(module)
        assert results.attempted > least and results.failed == 0


def blocks(page: Any) -> Any:
    return re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("number", range(len(blocks("docs/python.md"))))
def test_blocks_of_the_manual(number: Any, tmp_path: Any, monkeypatch: Any) -> None:
    block = blocks("docs/python.md")[number]
    wanted = re.findall(r"^(?:import|from) (trimesh|coacd|mujoco)\b", block, re.MULTILINE)
    for module in wanted:
        pytest.importorskip(module)
    (tmp_path / "spot.obj").symlink_to(Path(os.environ["CONVEXACT_TEST_DATA"]) / "spot.obj")
    (tmp_path / "bin.obj").symlink_to(Path(os.environ["CONVEXACT_TEST_DATA"]) / "cases" / "bin.obj")
    monkeypatch.chdir(tmp_path)
    exec(compile(block, f"docs/python.md, block {number}", "exec"), {"__name__": "block"})  # pylint: disable=exec-used


def test_the_notebook_runs_and_its_outputs_are_what_it_prints(monkeypatch: Any, capsys: Any) -> None:
    cells = json.loads((ROOT / "python/examples/notebook.ipynb").read_text(encoding="utf-8"))["cells"]
    monkeypatch.chdir(ROOT / "python/examples")
    names: dict[str, Any] = {}
    for cell in cells:
        if cell["cell_type"] != "code":
            continue
        exec("".join(cell["source"]), names)  # pylint: disable=exec-used
        printed = "".join("".join(output["text"]) for output in cell["outputs"] if output["output_type"] == "stream")
        assert capsys.readouterr().out == printed


def test_ctrl_c_in_a_notebook_ends_a_run_and_not_the_kernel() -> None:
    manager = pytest.importorskip("jupyter_client.manager")
    pytest.importorskip("ipykernel")
    kernel, client = manager.start_new_kernel(env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    try:
        client.execute("import convexact as cx, numpy as np\npoints = np.random.default_rng(1).normal(size=(20000, 3))\n"
                       "points /= np.linalg.norm(points, axis=1)[:, None]", reply=True, timeout=600)
        asked = client.execute("cx.simplify(points, faces=4, engine='exact')")
        time.sleep(1)
        kernel.interrupt_kernel()
        reply = client.get_shell_msg(timeout=600)
        while reply["parent_header"]["msg_id"] != asked:
            reply = client.get_shell_msg(timeout=600)
        assert reply["content"]["status"] == "error" and reply["content"]["ename"] in ("Interrupted", "KeyboardInterrupt")
        again = client.execute("assert cx.hull(points[:100], measures=()).faces", reply=True, timeout=600)
        assert again["content"]["status"] == "ok"
    finally:
        client.stop_channels()
        kernel.shutdown_kernel(now=True)
