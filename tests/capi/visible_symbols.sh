#!/bin/sh
# SPDX-License-Identifier: MIT
# visible_symbols.sh LIBRARY HEADER - the library exports the functions of the header, no others.
set -eu
command -v nm >/dev/null || { echo "skipped: nm is not installed"; exit 77; }
exported=$(nm -D --defined-only "$1" | awk '{print $3}' | sed 's/@.*//' | sort -u)
declared=$(grep -o 'convexact_[a-z_]*(' "$2" | tr -d '(' | sort -u)
[ "$exported" = "$declared" ] && exit 0
echo "exported: $exported"
echo "declared: $declared"
exit 1
