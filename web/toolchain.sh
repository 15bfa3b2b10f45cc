#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# toolchain.sh - brings what turns C++ into WebAssembly, into build/web/: Emscripten as build/web/bin/em*, and in
# build/web/prefix GMP, MPFR, pugixml and the headers of the packages that have nothing but headers.
#
# The Emscripten on the path is taken, if it is new enough. Otherwise Debian 13's goes into a folder of its own,
# which leaves the machine as it is: em* start there (bwrap), and see this tree.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$root/build/web
prefix=$out/prefix
oldest=3.1.60

say() { printf '%s\n' "web: $*" >&2; }

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }

is_new_enough() {
  local found
  found=$(emcc --version 2>/dev/null | sed -n '1s/.* \([0-9][0-9.]*[0-9]\)\b.*/\1/p')
  [ -n "$found" ] && [ "$(printf '%s\n' "$oldest" "$found" | sort -V | head -1)" = "$oldest" ]
}

# make_command NAME: build/web/bin/NAME, in the folder of Debian 13 unless the path has it.
make_command() {
  local start='exec'
  if [ -d "$out/debian" ]; then
    start="exec bwrap --bind '$out/debian' / --bind /tmp /tmp --ro-bind /usr/include /usr/include --bind '$root' '$root'"
    start+=" --dev /dev --proc /proc --chdir \"\$PWD\" --unsetenv CCACHE_DIR"
  fi
  printf '%s\n' '#!/bin/sh' "$start $1 \"\$@\"" >"$out/bin/$1"
  chmod +x "$out/bin/$1"
}

bring_emscripten() {
  [ -x "$out/bin/em++" ] && return
  mkdir -p "$out/bin"
  if [ ! -d "$out/debian" ] && ! is_new_enough; then
    say "no Emscripten of $oldest or newer on the path: Debian 13's goes into build/web/debian (2 GB, some minutes)"
    rm -rf "$out/debian.part"
    as_root mmdebstrap --variant=apt --include=emscripten \
      --dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/doc/*' \
      --dpkgopt='path-exclude=/usr/share/locale/*' trixie "$out/debian.part" >"$out/debian.log" 2>&1 ||
      { cat "$out/debian.log" >&2; return 1; }
    mv "$out/debian.part" "$out/debian"
  fi
  local name
  for name in emcc em++ emar emranlib; do make_command $name; done
}

# The sources of a package of this distribution, unpacked into build/web/NAME: the version whose headers and library
# the native program has. They are asked for in lists of our own, so that the machine's stay as they are.
source_of() {
  local name=$1 lists=$out/apt
  [ -d "$out/$name" ] && return
  local options=(-o "Dir::Etc::SourceList=$lists/list" -o "Dir::Etc::SourceParts=$lists/parts" -o "Dir::State::Lists=$lists/lists"
    -o "Dir::Cache=$lists/cache" -o APT::Sandbox::User=root -o Debug::NoLocking=1)
  if [ ! -d "$lists" ]; then
    mkdir -p "$lists/parts" "$lists/lists/partial" "$lists/cache/archives/partial"
    sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >"$lists/list" 2>/dev/null || true
    local file
    for file in /etc/apt/sources.list.d/*debian*.sources /etc/apt/sources.list.d/*ubuntu*.sources; do
      [ ! -f "$file" ] || sed 's/^Types:.*/Types: deb-src/' "$file" >"$lists/parts/$(basename "$file")"
    done
    apt-get "${options[@]}" -qq update >&2 || say "not all package lists could be had"
  fi
  rm -rf "$out/$name.part"
  mkdir -p "$out/sources"
  (cd "$out/sources" && apt-get "${options[@]}" -qq source --download-only "$name" >&2 &&
    dpkg-source --no-check -x "$name"_*.dsc "$out/$name.part" >/dev/null)
  mv "$out/$name.part" "$out/$name"
}

# Debian leaves the manual of GMP out, which is not free by its rules; its makefile is asked for all the same.
without_manual() { [ -d "$out/gmp/doc" ] || { mkdir "$out/gmp/doc" && echo 'all install:' >"$out/gmp/doc/Makefile.in"; }; }

# build_library NAME CONFIGURE-OPTIONS...
build_library() {
  local name=$1
  shift
  source_of "$name"
  [ "$name" != gmp ] || without_manual
  say "building $name"
  (cd "$out/$name" && {
    CC=$out/bin/emcc AR=$out/bin/emar RANLIB=$out/bin/emranlib CFLAGS=-O2 CC_FOR_BUILD=gcc \
      ./configure --host=none --prefix="$prefix" --disable-shared "$@" && make -j2 && make install
  } >"$out/$name.log" 2>&1) || { tail -20 "$out/$name.log" >&2; return 1; }
}

write_pc() { printf 'Name: %s\nDescription: %s\nVersion: %s\nCflags: -isystem %s %s\nLibs: %s\n' "$1" "$1" "$2" "$prefix/include" "$3" "${4:-}" >"$prefix/lib/pkgconfig/$1.pc"; }

# Eigen adds doubles in the order in which its vectors of two do, so the module has SSE too, which Emscripten makes of
# WebAssembly's vectors; else the two would round otherwise. Four functions are then in assembly for old GCCs, which it
# takes Clang for; and a header is missing of which it needs nothing.
copy_eigen() {
  rm -rf "$prefix/include/eigen3"
  cp -rL /usr/include/eigen3 "$prefix/include/eigen3"
  sed -i 's/^#if EIGEN_COMP_GNUC && EIGEN_COMP_GNUC < 63$/#if 0/' "$prefix/include/eigen3/Eigen/src/Core/arch/SSE/PacketMath.h"
  touch "$prefix/include/mmintrin.h"
}

bring_libraries() {
  [ -f "$prefix/complete" ] && return
  mkdir -p "$prefix/include" "$prefix/lib/pkgconfig"
  # Headers of the system, one by one: its own library's must not be seen.
  local package
  for package in boost nlohmann fmt; do ln -sfn "/usr/include/$package" "$prefix/include/$package"; done
  copy_eigen
  [ -f "$prefix/lib/libgmp.a" ] || build_library gmp --disable-assembly ABI=standard
  [ -f "$prefix/lib/libmpfr.a" ] || build_library mpfr4 --with-gmp="$prefix" --disable-thread-safe --disable-decimal-float --disable-float128
  source_of pugixml
  "$out/bin/em++" -O2 -fwasm-exceptions "-ffile-prefix-map=$root/=" -c "$out/pugixml/src/pugixml.cpp" -o "$out/pugixml.o"
  "$out/bin/emar" rcs "$prefix/lib/libpugixml.a" "$out/pugixml.o"
  cp "$out"/pugixml/src/*.hpp "$prefix/include"
  write_pc fmt "$(pkg-config --modversion fmt)" -DFMT_HEADER_ONLY
  write_pc nlohmann_json "$(pkg-config --modversion nlohmann_json)" ''
  write_pc eigen3 "$(pkg-config --modversion eigen3)" "-isystem $prefix/include/eigen3"
  write_pc pugixml "$(pkg-config --modversion pugixml)" '' "-L$prefix/lib -lpugixml"
  touch "$prefix/complete"
}

bring_emscripten
bring_libraries
