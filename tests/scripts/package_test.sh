#!/usr/bin/env bash
# Tests with which options scripts/package.sh configures, at a location with a blank in its name: package_test.sh ROOT SCRATCH
set -euo pipefail
scripts=$1/scripts
root="$2/made up"
rm -rf "$2"
mkdir -p "$root/scripts" "$root/bin"
cp "$scripts"/{package,setup,build}.sh "$root/scripts"
touch "$root/CMakePresets.json"
failures=0

# These stand for the programs: cmake remembers what it is to configure with, cpack makes a package.
cat >"$root/bin/cmake" <<'END'
#!/usr/bin/env bash
[ "$1" = --preset ] || { echo "ninja: no work to do."; exit; }
printf '%s\n' "${@:3}" >configured
END
cat >"$root/bin/cpack" <<'END'
#!/usr/bin/env bash
mkdir packages && echo package >packages/copperscope.deb
END
chmod +x "$root"/bin/*
export PATH="$root/bin:$PATH" COPPERSCOPE_SKIP_SETUP=1 SOURCE_DATE_EPOCH=1

# expect_options WHAT WANTED PACKAGER HOMEPAGE
expect_options() {
    local got
    rm -f "$root/configured"
    COPPERSCOPE_PACKAGER=$3 COPPERSCOPE_HOMEPAGE=$4 bash "$root/scripts/package.sh" 2>"$root/said" || cat "$root/said"
    got=$(cat "$root/configured" 2>/dev/null || true)
    [ "$2" != "$got" ] || return 0
    printf 'FAILED: %s\n  wanted: %s\n  got:    %s\n' "$1" "$2" "$got"
    failures=$((failures + 1))
}

expect_options "the environment says who made it" $'-DCOPPERSCOPE_PACKAGER=A Packager <a@b.example>\n-DCOPPERSCOPE_HOMEPAGE=https://b.example' \
    "A Packager <a@b.example>" https://b.example
expect_options "the same again" "" "A Packager <a@b.example>" https://b.example
expect_options "it says nothing any more" $'-UCOPPERSCOPE_PACKAGER\n-UCOPPERSCOPE_HOMEPAGE' "" ""

[ "$failures" -eq 0 ] || exit 1
echo "all passed"
