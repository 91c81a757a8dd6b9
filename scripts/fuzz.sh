#!/usr/bin/env bash
# Throws made-up input at every reader, one after the other: scripts/fuzz.sh [MINUTES PER TARGET] [TARGET]...
# Default: one minute, all targets; 0.2 is a look of 12 seconds. What is found stays in build/fuzz/found,
# a file per input; build/fuzz/tests/fuzz_TARGET FILE shows it again. What was run
# is written to the table of docs/reliability.md.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/setup.sh"
cd "$root"
minutes=${1:-1}
shift || true
seconds=$(awk -v minutes="$minutes" 'BEGIN { print int(minutes * 60 + 0.5) }')
[ "$seconds" -ge 1 ] || die 1 "usage: scripts/fuzz.sh [MINUTES PER TARGET] [TARGET]..."
table=${COPPERSCOPE_FUZZ_TABLE:-docs/reliability.md}
out=build/fuzz

# The number that libFuzzer prints as "stat::NAME: NUMBER"; 0 if it ended before.
stat_of() { awk -v name="stat::$2:" '$1 == name { n = $2 } END { print n + 0 }' "$1"; }

# row TARGET: sets the row of the target in the table, which is sorted by target.
row() {
    local name=$1 line
    line="| \`$name\` | $(stat_of "$out/$name.log" number_of_executed_units) | $minutes | $(findings "$name") | $(date -u +%F) | \`$commit\` |"
    awk -v name="| \`$name\` |" -v line="$line" '
        /^<!-- fuzz: end -->/ { if (!done) print line; done = 1 }
        index($0, name) == 1 { if (!done) print line; done = 1; next }
        /^\| `/ && inside && !done && $0 > name { print line; done = 1 }
        /^<!-- fuzz: begin -->/ { inside = 1 }
        /^<!-- fuzz: end -->/ { inside = 0 }
        { print }' "$table" >"$table.new"
    mv "$table.new" "$table"
}

# How many inputs of the target were found in this run.
findings() { find "$out/found" -name "$1-*" -newer "$out/$1.started" | wc -l; }

# fuzz TARGET: false if something was found.
fuzz() {
    local name=$1 status=0
    say "fuzz: $name for $minutes min"
    mkdir -p "$out/corpus/$name"
    touch "$out/$name.started"
    # No input of a few kB may need more than ten seconds or a GB at once.
    "$out/tests/fuzz_$name" -max_total_time="$seconds" -rss_limit_mb=2048 -malloc_limit_mb=1024 -timeout=10 -max_len=16384 \
        -artifact_prefix="$out/found/$name-" -print_final_stats=1 -verbosity=0 "$out/corpus/$name" "$out/seeds/$name" \
        >"$out/$name.log" 2>&1 || status=1
    grep -E 'number_of_executed_units|peak_rss|SUMMARY' "$out/$name.log" || true
    row "$name"
    return $status
}

setup_machine build fuzz
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target fuzzers
mkdir -p "$out/found"
commit=$(git rev-parse --short=8 HEAD)$(git diff --quiet HEAD -- model tri tests/fuzz || echo +)
mapfile -t targets < <("$out/tests/write_seeds" "$out/seeds")
[ $# -eq 0 ] || targets=("$@")

failed=()
for name in "${targets[@]}"; do
    fuzz "$name" || failed+=("$name")
done
[ ${#failed[@]} -eq 0 ] || die 1 "fuzz: found something in: ${failed[*]}; see $out/found and $out/TARGET.log"
say "fuzz: nothing found"
