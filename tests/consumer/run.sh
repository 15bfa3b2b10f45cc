#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh BUILD_DIR - installs the library to a scratch folder, then builds and runs a program of ten
# lines against it, once by pkg-config and once by CMake, and one in C against the C interface.
set -euo pipefail
build_dir=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
command -v cmake >/dev/null || { echo "skipped: cmake is not installed"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
expected="8 vertices, 6 facets"

DESTDIR= meson install -C "$build_dir" --no-rebuild --destdir "$scratch/root" >"$scratch/log"
config=$(find "$scratch/root" -name convexact.pc)
prefix=$(cd "$(dirname "$config")" && while [ ! -d include ]; do cd ..; done && pwd)

read -ra flags <<<"$(PKG_CONFIG_PATH=$(dirname "$config") pkg-config --cflags --libs --static convexact)"
read -ra cxx <<<"${CXX:-c++}"
"${cxx[@]}" -std=c++20 "$here/main.cpp" -o "$scratch/by_pkg_config" "${flags[@]}"
[ "$("$scratch/by_pkg_config")" = "$expected" ]
echo "pkg-config: builds and runs"

python3 "$here/examples.py" "$scratch/root"

cmake -S "$here" -B "$scratch/cmake" -DCMAKE_PREFIX_PATH="$prefix" >"$scratch/log"
cmake --build "$scratch/cmake" >"$scratch/log"
[ "$("$scratch/cmake/consumer")" = "$expected" ]
echo "CMake: builds and runs"

config=$(find "$scratch/root" -name convexact_c.pc)
read -ra flags <<<"$(PKG_CONFIG_PATH=$(dirname "$config") pkg-config --cflags --libs convexact_c)"
read -ra cc <<<"${CC:-cc}"
"${cc[@]}" "$here/../capi/example.c" -o "$scratch/from_c" "${flags[@]}"
library=$(dirname "$(find "$scratch/root" -name libconvexact_c.so)")
LD_LIBRARY_PATH=$library "$scratch/from_c" >"$scratch/log"
grep -q 'exactly 1/16' "$scratch/log"
echo "C by pkg-config: builds and runs"

program=$(find "$scratch/root" -path '*/bin/convexact')
(cd "$scratch" && "$program" conform --level 1 --flag malformed -- false {input} {faces} {output}) >"$scratch/log" && exit 1
grep -q 'nothing was asked' "$scratch/log"
echo "installed program: finds its conformance vectors"
"$program" stress --list >"$scratch/log"
echo "installed program: starts convexact-lab"
