#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# build.sh - compiles the module and puts together the package and the page, in build/web/; ./dev web calls it.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$root/build/web

say() { printf '%s\n' "web: $*" >&2; }

# size_line FILE
size_line() {
  printf '%-28s %10s bytes, gzip %s, brotli %s\n' "${1#"$out/"}" "$(stat -c %s "$1")" "$(gzip -9 -c "$1" | wc -c)" "$(brotli -c "$1" | wc -c)"
}

build_module() {
  # Boost 1.74 derives from a class that C++20 has not.
  local flags="'-fwasm-exceptions', '-msimd128', '-msse2', '-DBOOST_NO_CXX98_FUNCTION_BASE', '-isystem', '$out/prefix/include'"
  # The same bytes wherever it is compiled: no message of an assertion names this folder.
  flags+=", '-ffile-prefix-map=$root/='"
  cat >"$out/cross.new" <<INI
[binaries]
c = '$out/bin/emcc'
cpp = '$out/bin/em++'
ar = '$out/bin/emar'
ranlib = '$out/bin/emranlib'
pkgconfig = 'pkg-config'
[properties]
pkg_config_libdir = '$out/prefix/lib/pkgconfig'
[built-in options]
cpp_args = [$flags]
cpp_link_args = ['-fwasm-exceptions', '-L$out/prefix/lib']
[host_machine]
system = 'emscripten'
cpu_family = 'wasm32'
cpu = 'wasm32'
endian = 'little'
INI
  # Meson reads flags once, so others need a folder anew; a file that is merely newer would have everything compiled again.
  cmp -s "$out/cross.new" "$out/cross.ini" || { rm -rf "$out/module" && mv "$out/cross.new" "$out/cross.ini"; }
  [ -f "$out/module/build.ninja" ] || meson setup "$out/module" --cross-file "$out/cross.ini" -Dtests=false -Dpython=disabled \
    -Dunity=on -Dunity_size=40 -Db_pch=false
  ninja -C "$out/module" -j2 web/convexact.wasm
}

start=$SECONDS
"$root/web/toolchain.sh"
say "compiling the library (the first time takes minutes)"
build_module >"$out/module.log" 2>&1 || { cat "$out/module.log" >&2; exit 1; }
python3 "$root/web/package.py" "$out"
say "built in $((SECONDS - start)) s"
size_line "$out/package/convexact.wasm"
limit=2097152
found=$(brotli -c "$out/package/convexact.wasm" | wc -c)
[ "$found" -le $limit ] || { say "the module has $found bytes with brotli: at most $limit"; exit 1; }
