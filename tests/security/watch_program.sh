#!/usr/bin/env bash
# watch_program.sh PROGRAM BOARD SCRATCH: draws BOARD under strace. It must open no socket, start no program and write to nothing but the
# picture. 77 where strace is not there or may not look.
set -euo pipefail
program=$1 board=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch/home"
cd "$scratch"
command -v strace >/dev/null || { echo "not run: there is no strace on this machine"; exit 77; }
strace -qq -o /dev/null true 2>/dev/null || { echo "not run: strace may not watch programs here"; exit 77; }

# The driver's cache of shaders is the driver's (Mesa: ~/.cache); here it is off, so that all that is written is ours.
# Leaks cannot be looked for under strace.
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0
HOME=$scratch/home XDG_CACHE_HOME=$scratch/cache MESA_SHADER_CACHE_DISABLE=true MESA_GLSL_CACHE_DISABLE=true strace -f -qq -o trace \
    -e trace=%network,execve,execveat,open,openat,creat,unlink,unlinkat,rename,renameat,renameat2,mkdir,mkdirat,symlink,symlinkat,link,linkat,truncate,mknod,mknodat \
    "$program" render "$board" -o picture.png
[ -s picture.png ] || { echo "there is no picture" >&2; exit 1; }

# What remains of the calls when the harmless ones are taken away: reading, the first execve, files below /dev and /proc, the picture and the
# file that becomes it, what the driver compiled (SECURITY.md), and sockets that are not opened.
sed -E 's/^[0-9]+ +//' trace | grep -vE '^(\+\+\+|---|<\.\.\.)' | awk '
    /^execve\(/ && !started { started = 1; next }
    /^open(at)?\(/ && !/O_WRONLY|O_RDWR|O_CREAT|O_TRUNC|O_APPEND/ { next }
    /"\/(dev|proc|sys)\// { next }
    /^mkdir(at)?\(.*\/cache(\/copperscope)?"/ { next }
    /\/cache\/copperscope\/pipelines-[0-9a-f-]+\.cache(\.part[0-9-]+)?"/ { next }
    /"([^"]*\/)?picture\.png(\.part[0-9-]+)?"/ { next }
    /^(open|openat)\(.*"\/tmp\/[^"]*O_TMPFILE|memfd/ { next }
    { print }' >others
if [ -s others ]; then
    echo "besides the picture it did:" >&2
    cat others >&2
    exit 1
fi
echo "$(wc -l <trace) calls: no socket, no program, and only the picture written"
