#!/bin/sh
# SPDX-License-Identifier: MIT
# run_ci_step.sh PROGRAM - the CI step of docs/integrations.md accepts a program that encloses its
# input, and refuses one that does not, one that fails and one that writes nothing.
set -eu
export CONVEXACT=$1
step=$(cd "$(dirname "$0")" && pwd)/ci_step.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
"$CONVEXACT" generate dodecahedron -o first.obj
"$CONVEXACT" generate octahedron -o second.obj

# program NAME COMMAND...: a program that is called as NAME in.obj out.obj.
program() {
  printf '#!/bin/sh\n%s\n' "$2" >"$1"
  chmod +x "$1"
}
program encloses '"$CONVEXACT" simplify "$1" --faces 8 -o "$2" >log'
program writes_hulls '"$CONVEXACT" hull "$1" -o "$2" >log'
program misses 'sed "1,3d" "$1" | grep "^v" >"$2"'
program fails 'exit 3'
program writes_nothing ': >"$2"'

"$step" ./encloses first.obj second.obj | grep -c ': holds$' | grep -qx 2
ASKS=hull "$step" ./writes_hulls first.obj second.obj | grep -c ': holds$' | grep -qx 2
if ASKS=hull "$step" ./encloses first.obj; then
  echo "the step accepted a program that writes no hull"
  exit 1
fi
for name in misses fails writes_nothing; do
  if "$step" "./$name" first.obj second.obj; then
    echo "the step accepted a program that $name"
    exit 1
  fi
done
grep -q '"contains-input"' verdicts/first.json
