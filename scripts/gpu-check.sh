#!/usr/bin/env bash
# One call for a machine with a graphics card, under ten minutes: scripts/gpu-check.sh [--quick] [--built] [BOARD]...
# Builds without the workbench, runs the tests labelled `gpu` on the card with the validation layer, measures all back ends on generated
# boards (t3, t7, t9, 4 × t9) and on BOARD... (default: two of the bundled ones), and the triangulators, up to a million vertices; writes
# all tables to docs/performance-gpu.md. What would not fit into the time is named there as not run. Where there is a software device only,
# nothing of that is about a card, and build/card/performance-gpu.md is written instead, as with --quick, which takes t3 alone, to try the script.
# --built: build/card was built on another machine and copied to the same path here; nothing is installed or built.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/setup.sh"
. "$root/scripts/build.sh"
. "$root/scripts/testing.sh"

readonly kSeconds=590  # from start to end
quick="" built=""
while true; do
    case ${1:-} in
        --quick) quick=yes ;;
        --built) built=yes ;;
        *) break ;;
    esac
    shift
done
boards=("$@")
[ ${#boards[@]} -gt 0 ] || boards=("$root"/resources/sample/*.tgz "$root"/tests/data/boards/opencellular_sync.tgz)
for board in "${boards[@]}"; do
    [ -e "$board" ] || die 1 "$board does not exist"
done

sections=(build run test)
scratch=$root/build/card/measured
page=$root/build/card/performance-gpu.md
if [ "$(vulkan_kind)" = hardware ]; then
    export COPPERSCOPE_TEST_GPU=1
    [ -n "$quick" ] || page=$root/docs/performance-gpu.md
else
    sections+=(software)
    say "no graphics card with a Vulkan driver is here: this tries the script on the software device"
fi

left() { echo $((kSeconds - SECONDS)); }

# section TITLE: false, and said there, where no time is left for it.
section() {
    printf '\n## %s\n\n' "$1"
    if [ "$(left)" -lt 10 ]; then
        echo "Not run: the ten minutes were over."
        return 1
    fi
    say "$1"
}

# table TITLE COMMAND...: a section with what the command prints, or why it is not there.
table() {
    local title=$1 status=0 text
    shift
    section "$title" || return 0
    text=$(timeout "$(left)" "$@" 2>"$scratch/errors") || status=$?
    # shellcheck disable=SC2016
    printf '`copperscope %s`\n\n```\n%s\n```\n' "$(sed "s|$scratch/||g; s|$root/||g" <<<"${*:2}")" "$text"
    case $status in
        0) ;;
        124) echo; echo "Cut off: the ten minutes were over." ;;
        *) echo; echo "Ended with code $status: $(tail -n 1 "$scratch/errors")"; failed+=("$title") ;;
    esac
}

tests() {
    local status=0
    section "Tests labelled gpu" || return 0
    (cd "$root" && timeout "$(left)" ctest --preset card --parallel 2) >"$root/build/card/tests.log" 2>&1 || status=$?
    # shellcheck disable=SC2016
    printf '`ctest --preset card`, with the validation layer: %s\n' "$(grep 'tests passed' "$root/build/card/tests.log" || echo "code $status")"
    grep -E '\*\*\*[A-Z]|\(Failed\)' "$root/build/card/tests.log" | sed 's/^/    /' || true
    [ "$status" = 0 ] || failed+=("tests")
}

# generated NAME [OPTION...]: the path of a generated board.
generated() {
    local name=$1
    shift
    "$program" generate "$@" -o "$scratch/$name.tgz" >/dev/null 2>&1
    echo "$scratch/$name.tgz"
}

tables() {
    if [ -n "$quick" ]; then
        table "Both pipelines, t3" "$program" bench "$(generated t3 --like t3)" --only-culled --frames 1
        table "Triangulators" "$program" bench --triangulation --triangulators parallel,gpu --sets none --repeats 1 "${boards[0]}"
        return
    fi
    table "Both pipelines" "$program" bench "$(generated t3 --like t3)" "$(generated t7 --like t7)" "${boards[@]}"
    table "Both pipelines, t9" "$program" bench "$(generated t9 --like t9)" --only-culled --stages --frames 5
    table "The hybrid pipeline, 4 × t9" "$program" bench "$(generated t9x4 --like t9 --scale 4)" --pipeline hybrid --only-culled --stages --frames 5
    table "Triangulators" "$program" bench --triangulation --triangulators parallel,gpu --huge "${boards[@]}"
}

if [ -z "$built" ]; then
    setup_machine "${sections[@]}"
    build_preset_target card copperscope
    build_preset_target card gpu_tests
fi
use_windowless_surroundings "$root/build/card/surroundings"
program=$root/build/card/app/copperscope
mkdir -p "$scratch"
failed=()
{
    # shellcheck disable=SC2016
    printf '# Performance on a graphics card\n\nWritten by `scripts/gpu-check.sh` on %s: preset card, %s cores.\n' "$(date -u +%Y-%m-%d)" "$(nproc)"
    tests
    tables
} >"$scratch/page.md"
mv "$scratch/page.md" "$page"
say "written: $page ($SECONDS s)"
[ ${#failed[@]} -eq 0 ] || die 1 "gpu-check: failed: ${failed[*]}"
