# Configures and builds a preset with few words. Sourced by ./run and ./test after setup.sh.
# shellcheck shell=bash disable=SC2154

# build_preset PRESET [CMAKE OPTION...]: leaves the result in build/PRESET and all output in build/PRESET/build.log.
# Prints nothing when nothing is to do.
build_preset() { build_preset_target "$1" all "${@:2}"; }

# build_preset_target PRESET TARGET [CMAKE OPTION...]: the same of one target.
build_preset_target() {
    local preset=$1 dir=$root/build/$1 target=$2
    shift 2
    mkdir -p "$dir" || die "$kBuildFailed" "cannot write to $root/build"
    exec 9>"$dir/.lock"
    flock -n 9 || { say "another build of $preset is running, waiting for it"; flock 9; }
    configure "$preset" "$dir" "$@"
    cmake --build "$dir" --target "$target" 2>&1 | follow_build "$dir" || build_failed "$dir" "the build"
    exec 9>&-  # the program that runs next must not hold the lock
}

# Configures if that has not been done with this place and these options; later changes to CMake files are ninja's business. Who names no
# options takes the build as it is configured: a whole build is not thrown away because a script wants one program of it.
configure() {
    local preset=$1 dir=$2 stamp=$2/.configured done_before=""
    shift 2
    local wanted="$root $*"
    [ ! "$root/CMakePresets.json" -ot "$stamp" ] || done_before=$(cat "$stamp")
    case $done_before in
        "$wanted") return ;;
        "$root "*) [ $# -gt 0 ] || return 0 ;;
    esac
    say "configuring build/$preset"
    rm -f "$stamp" "$dir/CMakeCache.txt"
    (cd "$root" && LC_ALL=C.UTF-8 cmake --preset "$preset" "$@") >"$dir/build.log" 2>&1 || build_failed "$dir" "configuring"
    printf '%s\n' "$wanted" >"$stamp"
}

# Reads ninja's output, keeps it in the log once there is work, and shows every fifth of the way.
follow_build() {
    local dir=$1 line fifth=-1 log=/dev/null
    while IFS= read -r line; do
        case $line in "ninja: no work to do."*) continue ;; esac
        if [ "$log" = /dev/null ]; then
            log=$dir/build.log
            : >"$log"
        fi
        printf '%s\n' "$line" >>"$log"
        case $line in *"Re-running CMake"*) continue ;; esac
        if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] && ((BASH_REMATCH[1] * 5 / BASH_REMATCH[2] > fifth)); then
            fifth=$((BASH_REMATCH[1] * 5 / BASH_REMATCH[2]))
            say "building ${dir##*/}: $((fifth * 20)) %"
        fi
    done
}

# The first thing that went wrong matters more than the end, where other steps were still finishing.
build_failed() {
    say "$2 failed; from $1/build.log:"
    sed -n '/^FAILED:\|^CMake Error/,$p' "$1/build.log" | head -n 40 | grep . >&2 || tail -n 40 "$1/build.log" >&2
    exit "$kBuildFailed"
}

# Programs want a UTF-8 locale; a bare machine has none set.
use_utf8() {
    case ${LC_ALL:-${LC_CTYPE:-${LANG:-}}} in
        *[Uu][Tt][Ff]*) ;;
        *) export LC_ALL=C.UTF-8 ;;
    esac
}
