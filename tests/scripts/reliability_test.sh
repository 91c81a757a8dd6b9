#!/usr/bin/env bash
# Tests that scripts/reliability.sh sets one section of docs/reliability.md and leaves the others: reliability_test.sh ROOT SCRATCH
set -euo pipefail
scripts=$1/scripts
root=$2/made-up
rm -rf "$root"
mkdir -p "$root/docs"
# shellcheck source=/dev/null
. "$scripts/reliability.sh"
failures=0

# expect WHAT WANTED GOT
expect() {
    [ "$2" != "$3" ] || return 0
    printf 'FAILED: %s\n  wanted: %s\n  got:    %s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
}

page() { cat "$root/docs/reliability.md"; }
# section KEY: what lies between its comments.
section() { sed -n "/^<!-- $1 -->\$/,/^<!-- end of $1 -->\$/p" "$root/docs/reliability.md" | sed '1d;$d'; }

echo "one \\ & 1" | write_numbers first "First"
expect "the page is made with its title" "# Reliability" "$(head -n 1 "$root/docs/reliability.md")"
expect "the section has its text as it is" $'## First\n\none \\ & 1' "$(section first)"
echo "two" | write_numbers second "Second"
echo "three" | write_numbers first "First"
expect "the section is replaced" $'## First\n\nthree' "$(section first)"
expect "the other one stays" $'## Second\n\ntwo' "$(section second)"
expect "there is one of each" "2" "$(page | grep -c '^## ')"
before=$(page)
echo "three" | write_numbers first "First"
expect "the same again changes nothing" "$before" "$(page)"

[ "$failures" -eq 0 ] || exit 1
echo "all passed"
