#!/usr/bin/env bash
# Refuses memory of host and device, fills disks, lets reads fail and loses devices at one moment after another: scripts/faults.sh [--thorough] [--write]
# Fails where something is lost, left or only half there. --thorough tries each moment, otherwise a sample of them. With --write how many
# faults were injected goes into docs/reliability.md.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/reliability.sh"

readonly tests=(scarce_memory_test whole_or_nothing_test failing_reads_test faults_test)
writes="" how=""
while [ $# -gt 0 ]; do
    case $1 in
        --thorough) export COPPERSCOPE_THOROUGH=1 how=", each moment" ;;
        --write) writes=yes ;;
        *) die 1 "usage: scripts/faults.sh [--thorough] [--write]" ;;
    esac
    shift
done

setup_machine build run software test
for test in "${tests[@]}"; do
    build_preset_target test "$test"
done
use_windowless_surroundings "$root/build/test/surroundings"

numbers=$root/build/test/faults.md
log=$root/build/test/faults.log
status=0
for test in "${tests[@]}"; do
    "$root/build/test/tests/$test" || status=$?
done >"$log" 2>&1
{
    echo "| test | faults | of which kind, and what came of them |"
    echo "|---|---|---|"
    awk -v tests="${tests[*]}" '
        BEGIN { split(tests, names, " ") }
        /Start testing/ { ++row }
        sub(/.*faults injected: /, "") { all += $1; line = $0; sub(/^[0-9]+ /, "", line); printf "| `%s` | %d | %s |\n", names[row], $1, line }
        END { printf "| **all** | %d | |\n", all }' "$log"
} >"$numbers"
cat "$numbers"
[ "$status" -eq 0 ] || { grep -A 4 '^FAIL' "$log" | head -n 40 >&2; die "$status" "not everything held; see $log"; }
[ -z "$writes" ] || { measured_at "test$how"; echo; echo "Nothing was lost, left or half there."; echo; cat "$numbers"; } |
    write_numbers "scripts/faults.sh" "Faults"
