#!/usr/bin/env bash
# Builds the .deb of this checkout: scripts/package.sh [--twice]
# It ends in build/package/packages. --twice builds a second time, from a copy of the sources at another place, and compares the bits.
# COPPERSCOPE_PACKAGER and COPPERSCOPE_HOMEPAGE of the environment say who made it and where the project is to be found.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# shellcheck source-path=SCRIPTDIR
# shellcheck disable=SC2154
. "$root/scripts/setup.sh"
. "$root/scripts/build.sh"

# The day of what is packed: that of the commit, else of the newest source.
source_date() {
    git -C "$root" log -1 --format=%ct 2>/dev/null || find "$root" -path "$root/build" -prune -o -type f -printf '%T@\n' | sort -n | tail -n 1 | cut -d. -f1
}

# option NAME: what tells CMake the variable of that name, or that it is no longer set.
option() { if [ -n "${!1:-}" ]; then echo "-D$1=${!1}"; else echo "-U$1"; fi; }

# package ROOT: the path of the .deb of the sources there.
package() {
    local root=$1
    build_preset package "$(option COPPERSCOPE_PACKAGER)" "$(option COPPERSCOPE_HOMEPAGE)"
    (cd "$root/build/package" && umask 022 && rm -rf packages && cpack -G DEB >package.log 2>&1) ||
        { tail -n 20 "$root/build/package/package.log" >&2; die "$kBuildFailed" "cpack failed"; }
    ls "$root"/build/package/packages/*.deb
}

setup_machine build package
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(source_date)}
export SOURCE_DATE_EPOCH
made=$(package "$root")
say "${made#"$root"/}: $(stat -c %s "$made") bytes, sha256 $(sha256sum "$made" | cut -d' ' -f1)"
[ "${1:-}" = --twice ] || exit 0

elsewhere=$(mktemp -d)
trap 'rm -rf "$elsewhere"' EXIT
say "building once more in $elsewhere/copperscope"
git clone -q "$root" "$elsewhere/copperscope"
export CCACHE_DISABLE=1
again=$(package "$elsewhere/copperscope")
cmp "$made" "$again" || die "$kBuildFailed" "the two packages differ; the second is not kept"
say "the same bits again"
