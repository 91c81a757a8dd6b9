#!/usr/bin/env bash
# Tests that a checkout may lie in a folder with blanks in its name, as far as can be told without building there: blanks_test.sh ROOT
set -euo pipefail
cd "$1"
failures=0

# expect_none WHAT LINES: there must be no such lines.
expect_none() {
    [ -n "$2" ] || return 0
    printf 'FAILED: %s\n%s\n' "$1" "$2"
    failures=$((failures + 1))
}

# Blanks in the text of a command divide a path; what follows the text is "$0", "$1", … in it, whole.
# shellcheck disable=SC2016
expect_none "commands of a shell take paths as arguments, not in their text" \
    "$(find . \( -path ./build -o -path ./.git \) -prune -o \( -name '*.cmake' -o -name CMakeLists.txt \) -exec grep -nE '\bsh -c "([^"\\]|\\.)*\$\{' {} +)"
expect_none "flags with paths are quoted in presets" "$(grep -nE '\$\{sourceDir\}[^ "'\''\\]* ' CMakePresets.json)"
# shellcheck disable=SC2016
expect_none "files of suppressions are quoted for sanitizers" \
    "$(grep -rnE 'suppressions=[^'\'' ]*(\$root|\$\{sourceDir\})' CMakePresets.json scripts)"

[ "$failures" -eq 0 ] || exit 1
echo "all passed"
