#!/usr/bin/env bash
# catches_violations.sh SCRATCH: that the tests beside this one fail for programs that do what they must not do.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
scratch=$1
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
failures=0

# planted NAME 'C STATEMENTS': a program that draws its "picture" and does this too.
planted() {
    cat >"$1.c" <<SOURCE
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>
int main(int argc, char** argv) {
    FILE* picture = fopen(argv[argc - 1], "w");
    fputs("picture", picture);
    fclose(picture);
    $2
    return 0;
}
SOURCE
    "${CC:-cc}" -o "$1" "$1.c" 2>cc.log || { cat cc.log >&2; exit 1; }
}

# expects NAME STATUS COMMAND…
expects() {
    local name=$1 wanted=$2 status=0
    shift 2
    "$@" >"$name.log" 2>&1 || status=$?
    [ "$status" = "$wanted" ] || { echo "$name: exit code $status instead of $wanted: $(cat "$name.log")" >&2; failures=$((failures + 1)); }
}

planted honest ''
planted talks 'if (socket(AF_INET, SOCK_STREAM, 0) < 0) return 1;'
planted starts 'if (system("true") != 0) return 1;'
planted writes 'if (open("elsewhere", O_WRONLY | O_CREAT, 0600) < 0) return 1;'
expects honest_is_linked 0 bash "$here/check_program.sh" ./honest
expects talks_is_linked 1 bash "$here/check_program.sh" ./talks
expects starts_is_linked 1 bash "$here/check_program.sh" ./starts
if command -v strace >/dev/null && strace -qq -o /dev/null true 2>/dev/null; then
    expects honest_runs 0 bash "$here/watch_program.sh" "$scratch/honest" board "$scratch/honest.run"
    for name in talks starts writes; do
        expects "${name}_runs" 1 bash "$here/watch_program.sh" "$scratch/$name" board "$scratch/$name.run"
    done
fi
[ "$failures" -eq 0 ]
