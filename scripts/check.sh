#!/usr/bin/env bash
# What a change must pass, before it is proposed: scripts/check.sh [format] [tidy] [dev] [headless] [asan] [tsan]
# Without arguments all of them. `tidy` looks at the files changed since COPPERSCOPE_BASE (default: the last commit on origin's main
# branch, else HEAD).
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/setup.sh"
. "$root/scripts/build.sh"
. "$root/scripts/testing.sh"
cd "$root"

check_format() { git ls-files -z '*.h' '*.cpp' | xargs -0 clang-format --dry-run --Werror; }

changed_sources() {
    local base
    base=${COPPERSCOPE_BASE:-$(git merge-base HEAD origin/HEAD 2>/dev/null || echo HEAD)}
    { git diff -z --name-only --diff-filter=d "$base" -- '*.cpp'; git ls-files -z --others --exclude-standard -- '*.cpp'; } | sort -zu
}

check_tidy() {
    build_preset dev
    changed_sources | xargs -0 -r -n 1 -P "$(nproc)" clang-tidy -p build/dev --quiet
}

check_preset() {
    build_preset "$1"
    ctest --preset "$1" --parallel "$(nproc)"
}

check() {
    say "check: $1"
    case $1 in
        format | tidy) "check_$1" ;;
        dev | headless | asan | tsan) check_preset "$1" ;;
        *) die 1 "no such check: $1 (format, tidy, dev, headless, asan, tsan)" ;;
    esac
}

setup_machine build run software test check
use_test_surroundings "$root/build/check"
[ $# -gt 0 ] || set -- format tidy dev headless asan tsan
for name; do
    check "$name"
done
say "all checks passed: $*"
