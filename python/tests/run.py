# SPDX-License-Identifier: MIT
"""run.py CORE DATA [PYTEST_ARGUMENTS] - runs the tests on the package with the extension CORE, without installing it.

Skipped (77) where pytest or hypothesis is missing.
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent


def main() -> Any:
    try:
        import hypothesis  # pylint: disable=import-outside-toplevel,unused-import
        import pytest  # pylint: disable=import-outside-toplevel,unused-import
    except ImportError as error:
        print(f"skipped: {error}; python3-pytest and python3-hypothesis")
        return 77
    core, data = Path(sys.argv[1]).resolve(), sys.argv[2]
    with tempfile.TemporaryDirectory() as folder:
        package = Path(folder) / "convexact"
        package.mkdir()
        for source in (HERE.parent / "convexact").iterdir():
            if source.is_file():
                (package / source.name).symlink_to(source)
        (package / core.name).symlink_to(core)
        environment = {**os.environ, "PYTHONPATH": folder, "CONVEXACT_TEST_DATA": data, "PYTHONDONTWRITEBYTECODE": "1"}
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "convexact.pytest_plugin", str(HERE), *sys.argv[3:]]
        return subprocess.run(command, cwd=folder, env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
