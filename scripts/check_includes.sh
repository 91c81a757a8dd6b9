#!/usr/bin/env bash
# Checks that the sources of ui/ include what they use: ./scripts/check_includes.sh [BUILD DIRECTORY, build/test by default]
# The test build reads Qt's headers once for all of them (precompiled headers), which hides what a source fails to include, and breaks the build of
# ./run, which does not. Compiles each as the build did, without these headers and without optimising; what comes out is thrown away, but a compiler
# cache remembers that it did.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
build=$(readlink -f "${1:-$root/build/test}")

objects=$(mktemp -d)
trap 'rm -rf "$objects"' EXIT
# Of "... -Winvalid-pch -include HEADERS -MD ... -o OBJECT -c SOURCE" the flags before and the source, which is quoted where it has blanks.
commands=$(ninja -C "$build" -t commands copperscope |
    sed -nE "s#^(.*) -Winvalid-pch -include .* -MD .* -c ([^ ]*/ui/[^ ]*\.cpp|'.*/ui/[^']*\.cpp')\$#\1 -O0 -c \2#p" |
    awk -v folder="$objects" '{ print $0 " -o \"" folder "/" NR ".o\"" }')
[ -n "$commands" ] || { echo "check_includes: no source of ui/ in $build uses precompiled headers" >&2; exit 1; }
cd "$build"
xargs -P "$(nproc)" -d '\n' -n 1 bash -c <<<"$commands"
echo "check_includes: $(wc -l <<<"$commands") sources include what they use"
