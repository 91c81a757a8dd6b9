#!/usr/bin/env bash
# A very large board within a budget of time and memory: scripts/large-board.sh [--write] [--quick PROGRAM]
# Generates a board four times as large as t9 of the paper (3.2 million elements), opens, draws, measures and exports it, and shows it in the window's
# views on the software device; fails where a command needs more than its budget. With --write the figures go into docs/reliability.md. It takes ten
# minutes and 20 GB of disk. --quick PROGRAM tries the same with a small board and a program that is built, for the tests.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/reliability.sh"

writes="" program="" like=(--like t9 --scale 4)
case ${1:-} in
    --write) writes=yes ;;
    --quick) program=$2 like=(--like t3) ;;
    "") ;;
    *) die 1 "usage: scripts/large-board.sh [--write] [--quick PROGRAM]" ;;
esac
if [ -z "$program" ]; then
    setup_machine build run software test
    build_preset_target test copperscope
    program=$root/build/test/app/copperscope
    use_windowless_surroundings "$root/build/test/surroundings"
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$program" generate "${like[@]}" -o "$scratch/board.tgz" >/dev/null
export QT_QPA_PLATFORM=offscreen

# What it does, seconds and MiB it may take, and the command.
readonly kRows=(
    "read, all counts|30|3000|info"
    "a picture, from above|30|3000|render -o $scratch/top.png"
    "a picture, isometric|30|3000|render --view iso -o $scratch/iso.png"
    "the distance of two items|30|3000|measure --from edge --to at:10mm,10mm"
    "all smallest clearances|60|4000|clearance"
    "a cross section|30|3000|section --line 0,0,50,50"
    "PDF|180|3000|export -o $scratch/a.pdf"
    "STEP|240|3000|export -o $scratch/a.step"
    "GLB|300|4000|export -o $scratch/a.glb"
    "the window: all of it drawn and moved|120|4000|bench --interactive --frames 8"
)

# measure COMMAND...: seconds and MiB at the peak; false, and what was said in $scratch/errors, where it fails.
measure() {
    local begin=$EPOCHREALTIME peak=0 now pid
    "$@" >/dev/null 2>"$scratch/errors" &
    pid=$!
    while [ -n "$(jobs -rp)" ]; do
        now=$(awk '/^VmHWM/ { print $2 }' "/proc/$pid/status" 2>/dev/null || true)
        peak=${now:-$peak}
        sleep 0.05
    done
    wait "$pid" || return 1
    awk "BEGIN { printf \"%.1f %d\", $EPOCHREALTIME - $begin, $peak / 1024 }"
}

table=$'| what | s | of | MiB | of |\n|---|---|---|---|---|'
over=0
for row in "${kRows[@]}"; do
    IFS='|' read -r what mostSeconds mostMib command <<<"$row"
    read -ra words <<<"$command"
    measured=$(measure "$program" "${words[0]}" "$scratch/board.tgz" "${words[@]:1}") || die 1 "$what: $(tail -n 1 "$scratch/errors")"
    read -r seconds mib <<<"$measured"
    rm -f "$scratch"/a.*
    table+=$'\n'"| $what | $seconds | $mostSeconds | $mib | $mostMib |"
    if ! awk "BEGIN { exit !($seconds <= $mostSeconds && $mib <= $mostMib) }"; then
        say "over its budget: $what: $seconds s, $mib MiB"
        over=$((over + 1))
    fi
done
numbers="\`generate ${like[*]}\`: each command by itself, from the packed job to the end, and what it may take.

$table"
echo "$numbers"
[ -z "$writes" ] || { measured_at test; echo; echo "$numbers"; } | write_numbers "scripts/large-board.sh" "Very large boards"
[ "$over" -eq 0 ]
