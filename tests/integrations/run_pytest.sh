#!/bin/sh
# SPDX-License-Identifier: MIT
# run_pytest.sh PROGRAM - runs the Python files of docs/integrations.md with the program as oracle.
set -eu
export CONVEXACT=$1
here=$(cd "$(dirname "$0")" && pwd)
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import hypothesis, pytest' 2>/dev/null; then
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    cp "$here/oracle.py" "$here/test_enclosure.py" "$scratch"
    cd "$scratch"
    "$python" -m pytest -q --hypothesis-seed=2604
    exit
  fi
done
echo "skipped: python3-pytest or python3-hypothesis is not installed"
exit 77
