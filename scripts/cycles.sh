#!/usr/bin/env bash
# Stops work at random moments, and opens and closes windows with boards: scripts/cycles.sh [--cancels N] [--cycles N] [--preset test|asan] [--write]
# By default 1,000 cancels and 200 cycles. Fails where something is left of what was stopped, or where memory, handles, threads or device memory
# grow. With --write the numbers go into docs/reliability.md.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/reliability.sh"

cancels=1000 cycles=200 preset=test writes=""
while [ $# -gt 0 ]; do
    case $1 in
        --cancels) cancels=$2; shift ;;
        --cycles) cycles=$2; shift ;;
        --preset) preset=$2; shift ;;
        --write) writes=yes ;;
        *) die 1 "usage: scripts/cycles.sh [--cancels N] [--cycles N] [--preset test|asan] [--write]" ;;
    esac
    shift
done

setup_machine build run software test
build_preset_target "$preset" soak
use_test_surroundings "$root/build/$preset/surroundings"

numbers=$root/build/$preset/cycles.md
status=0
boards=("$root"/resources/sample/*.tgz "$root"/tests/data/boards/opencellular_sync.tgz)
{
    # Cycles without the validation layer, which keeps 13 kB of each window for itself.
    COPPERSCOPE_VALIDATION=abort "$root/build/$preset/tests/soak" cancels --seed 1 --count "$cancels" "${boards[@]}" && echo &&
        "$root/build/$preset/tests/soak" cycles --count "$cycles" "${boards[@]}" "$root"/tests/data/odb/panel
} >"$numbers" || status=$?
cat "$numbers"
[ -z "$writes" ] || { measured_at "$preset"; printf '\n```\n'; cat "$numbers"; echo '```'; } | write_numbers "scripts/cycles.sh" "Cancels and cycles"
exit "$status"
