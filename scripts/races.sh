#!/usr/bin/env bash
# The program under the thread sanitizer: scripts/races.sh [--write] [BOARD]...
# Opens boards (the bundled ones by default), checks their rules, exports them, and drags, zooms and highlights them in a window; fails where two
# threads touch something in no order. With --write how much was tried goes into docs/reliability.md. The tests labelled unit run under it too:
# scripts/check.sh tsan.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/reliability.sh"

writes=""
[ "${1:-}" != --write ] || { writes=yes; shift; }
boards=("$@")
[ ${#boards[@]} -gt 0 ] || boards=("$root"/resources/sample/*.tgz "$root"/tests/data/boards/*.tgz "$root"/tests/data/odb/* "$root"/tests/data/kicad/*.kicad_pcb)

setup_machine build run software test
build_preset_target tsan copperscope
use_windowless_surroundings "$root/build/tsan/surroundings"
# Qt and the driver are not instrumented, and hand over between their threads in ways that it does not see: what they do themselves is left out.
export QT_QPA_PLATFORM=offscreen TSAN_OPTIONS="halt_on_error=0 exitcode=66 ignore_noninstrumented_modules=1 suppressions='$root/scripts/sanitizers/tsan.supp' print_suppressions=0"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

commands=("info" "clearance --rules default" "export -o $scratch/a.step" "export -o $scratch/a.glb" "export -o $scratch/a.pdf"
    "bench --interactive --frames 8 --size 800x600")
runs=0 raced=0
for board in "${boards[@]}"; do
    for command in "${commands[@]}"; do
        read -ra words <<<"$command"
        status=0
        "$root/build/tsan/app/copperscope" "${words[0]}" "$board" "${words[@]:1}" >"$scratch/log" 2>&1 || status=$?
        runs=$((runs + 1))
        if [ "$status" -eq 66 ]; then
            raced=$((raced + 1))
            say "a race: ${words[*]} $board"
            grep -m 1 -A 20 'WARNING: ThreadSanitizer' "$scratch/log" >&2
        fi
    done
done
numbers="${#boards[@]} boards opened, checked, exported and moved in a window in $runs runs of the program under the thread sanitizer: $raced with a race."
echo "$numbers"
[ -z "$writes" ] || { measured_at tsan; echo; echo "$numbers"; } | write_numbers "scripts/races.sh" "Races"
[ "$raced" -eq 0 ]
