#!/usr/bin/env bash
# Tells which lines of model/ the tests run: scripts/coverage.sh [--write]
# Runs the tests labelled `unit` and `cli`, built without the workbench, and prints a row per folder; build/coverage/lines.csv has one per file,
# build/coverage/html/index.html shows the lines themselves. Fails below 90 % over all. With --write the numbers go into docs/reliability.md.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
. "$root/scripts/reliability.sh"

least=90
writes=""
case ${1:-} in
    "") ;;
    --write) writes=yes ;;
    *) die 1 "usage: scripts/coverage.sh [--write]" ;;
esac

# Reads gcovr's table of files and prints one of their folders, the last row being all of them.
folder_table() {
    awk -F, '
        function row(name, lines, ran) { printf "| %s | %d | %d | %.1f |\n", name, lines, ran, lines ? 100 * ran / lines : 0 }
        NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; print "| folder | lines | run | % |\n|---|---|---|---|"; next }
        {
            folder = $column["filename"]
            sub(/\/[^\/]*$/, "", folder)
            if (!(folder in lines)) order[++count] = folder
            lines[folder] += $column["line_total"]
            ran[folder] += $column["line_covered"]
            all += $column["line_total"]
            allRan += $column["line_covered"]
        }
        END {
            for (i = 1; i <= count; ++i) row("`" order[i] "`", lines[order[i]], ran[order[i]])
            row("**all**", all, allRan)
        }' "$1"
}

setup_machine build run software test coverage
build_preset coverage
use_test_surroundings "$root/build/coverage/surroundings"
cd "$root"
find build/coverage -name '*.gcda' -delete
ctest --preset coverage --parallel "$(nproc)" >build/coverage/tests.log || { tail -n 30 build/coverage/tests.log >&2; die 1 "coverage: tests failed"; }
mkdir -p build/coverage/html
gcovr -j "$(nproc)" --root . --object-directory build/coverage --filter 'model/' \
    --csv build/coverage/lines.csv --html-details build/coverage/html/index.html
numbers=build/coverage/lines.md
folder_table <(head -n 1 build/coverage/lines.csv; tail -n +2 build/coverage/lines.csv | sort) >"$numbers"
cat "$numbers"
[ -z "$writes" ] || { measured_at coverage; echo; cat "$numbers"; } | write_numbers "scripts/coverage.sh" "Lines of model/ that tests run"
awk -F'|' -v least="$least" '/[*]all[*]/ { exit $5 < least }' "$numbers" || die 1 "coverage: less than $least % of the lines of model/"
