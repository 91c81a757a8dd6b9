#!/usr/bin/env bash
# Uses the window at random on all boards, with the validation layer: scripts/soak.sh MINUTES [--seed N] [--preset asan|test] [--write]
# Fails where the window crashes, leaks, complains, hangs or needs more than 250 ms to answer; then the last 50 actions are on stderr. The same seed
# draws the same actions again. Boards: those of COPPERSCOPE_BOARDS, or the bundled ones. With --write the numbers go into docs/reliability.md.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/reliability.sh"

minutes="" seed=$(date +%s) preset=asan writes="" faults=()
while [ $# -gt 0 ]; do
    case $1 in
        --seed) seed=$2; shift ;;
        --preset) preset=$2; shift ;;
        --faults) faults=(--faults) ;;
        --write) writes=yes ;;
        *) minutes=$1 ;;
    esac
    shift
done
[[ $minutes =~ ^[0-9]+$ && $minutes -ge 1 ]] || die 1 "usage: scripts/soak.sh MINUTES [--seed N] [--preset asan|test] [--faults] [--write]"

setup_machine build run software test
build_preset_target "$preset" soak
use_test_surroundings "$root/build/$preset/surroundings"
# Of stacks of allocations four frames, and little memory that was freed is kept: both take longer than what is watched.
few="malloc_context_size=4:quarantine_size_mb=32:thread_local_quarantine_size_kb=64"
export COPPERSCOPE_VALIDATION=abort ASAN_OPTIONS=detect_stack_use_after_return=1:abort_on_error=1:$few UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
export LSAN_OPTIONS="suppressions='$root/scripts/sanitizers/lsan.supp':print_suppressions=0"

folder=${COPPERSCOPE_BOARDS:-$root/tests/data/boards}
mapfile -t boards < <(find "$folder" -maxdepth 2 \( -name '*.tgz' -o -name '*.kicad_pcb' -o -name '*.zip' \) | sort)
numbers=$root/build/$preset/soak.md
status=0
"$root/build/$preset/tests/soak" use --seed "$seed" --seconds $((minutes * 60)) --stall-ms 250 "${faults[@]}" \
    "$root"/resources/sample/*.tgz "$root"/tests/data/odb/everything "${boards[@]}" >"$numbers" || status=$?
cat "$numbers"
# Beside the numbers it holds all that the window reported.
# shellcheck disable=SC2016
[ -z "$writes" ] || { measured_at "$preset"; echo; printf '```\n%s\n```\n' "$(grep -E '^random use|^ .* times, longest|^longest' "$numbers")"; } |
    write_numbers "scripts/soak.sh --preset $preset" "Random use of the window, preset $preset"
exit "$status"
