#!/usr/bin/env bash
# Tests when scripts/build.sh configures: build_test.sh ROOT SCRATCH
set -euo pipefail
scripts=$1/scripts
root=$2/made-up
rm -rf "$2"
mkdir -p "$root/build/test"
touch -d '1 hour ago' "$root/CMakePresets.json"
# shellcheck source=/dev/null
. "$scripts/setup.sh"
# shellcheck source=/dev/null
. "$scripts/build.sh"
failures=0

# Stands for the program: remembers that it was called, and with what.
cmake() { echo "$*" >"$root/called"; }

# expect_configured WHAT WANTED [OPTION...]: with which arguments cmake is called, "" for not at all.
expect_configured() {
    local what=$1 wanted=$2 got=""
    shift 2
    rm -f "$root/called"
    configure test "$root/build/test" "$@" 2>/dev/null
    [ ! -e "$root/called" ] || got=$(cat "$root/called")
    [ "$wanted" != "$got" ] || return 0
    printf 'FAILED: %s\n  wanted: %s\n  got:    %s\n' "$what" "$wanted" "$got"
    failures=$((failures + 1))
}

expect_configured "a new folder" "--preset test -DA=ON" -DA=ON
expect_configured "the same options again" "" -DA=ON
expect_configured "no options: as it is" ""
expect_configured "other options" "--preset test -DA=OFF" -DA=OFF
touch -d '1 hour' "$root/CMakePresets.json"
expect_configured "newer presets" "--preset test"
touch -d '1 hour ago' "$root/CMakePresets.json"
expect_configured "no options after none" ""
echo "/elsewhere -DA=OFF" >"$root/build/test/.configured"
expect_configured "a checkout that was moved" "--preset test"

[ "$failures" -eq 0 ] || exit 1
echo "all passed"
