#!/bin/sh
# SPDX-License-Identifier: MIT
# run.sh TEST PROGRAM - a test of the package that ./dev web made, in Node.
here=$(cd "$(dirname "$0")" && pwd)
web=$here/../../build/web
[ -f "$web/package/convexact.wasm" ] || { echo "skipped: no build/web, ./dev web makes it"; exit 77; }
command -v node >/dev/null || { echo "skipped: no Node"; exit 77; }
exec node "$here/$1" "$2" "$web"
