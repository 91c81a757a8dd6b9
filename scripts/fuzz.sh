#!/usr/bin/env bash
# Throws made-up input at every parser, one after the other: scripts/fuzz.sh [MINUTES PER PARSER] [PARSER]...
# Default: one minute, all parsers. What is found stays in build/fuzz/found,
# a file per input; build/fuzz/tests/fuzz_PARSER FILE shows it again.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/setup.sh"
cd "$root"
minutes=${1:-1}
shift || true
[ "$minutes" -ge 1 ] || die 1 "usage: scripts/fuzz.sh [MINUTES PER PARSER] [PARSER]..."

setup_machine build fuzz
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target fuzzers
out=build/fuzz
mkdir -p "$out/found"
mapfile -t parsers < <("$out/tests/write_seeds" "$out/seeds")
[ $# -eq 0 ] || parsers=("$@")

failed=()
for name in "${parsers[@]}"; do
    say "fuzz: $name for $minutes min"
    mkdir -p "$out/corpus/$name"
    # No input of a few kB may need more than ten seconds or a GB at once.
    "$out/tests/fuzz_$name" -max_total_time=$((minutes * 60)) -rss_limit_mb=2048 -malloc_limit_mb=1024 -timeout=10 -max_len=16384 \
        -artifact_prefix="$out/found/$name-" -print_final_stats=1 -verbosity=0 "$out/corpus/$name" "$out/seeds/$name" \
        >"$out/$name.log" 2>&1 || failed+=("$name")
    grep -E 'number_of_executed_units|peak_rss|SUMMARY' "$out/$name.log" || true
done
[ ${#failed[@]} -eq 0 ] || die 1 "fuzz: found something in: ${failed[*]}; see $out/found and $out/PARSER.log"
say "fuzz: nothing found"
