#!/usr/bin/env bash
# check_install.sh CMAKE BUILD SCRATCH: installs a build, moves it, and looks at what is there and whether the program finds what it needs.
set -euo pipefail
cmake=$1 build=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch/home"
"$cmake" --install "$build" --prefix "$scratch/first" >"$scratch/log"
mv "$scratch/first" "$scratch/moved"
cd "$scratch/moved"

failed() {
    echo "$*" >&2
    exit 1
}

for file in bin/copperscope share/copperscope/sample/ocp_tap_sa45_odb.tgz share/copperscope/guide/{README,opening}.md share/doc/copperscope/{LICENSE,copyright,changelog.gz} \
    share/man/man1/copperscope.1.gz share/man/man1/copperscope-info.1.gz share/bash-completion/completions/copperscope; do
    [ -s "$file" ] || failed "there is no $file"
done
[ ! -e share/applications ] || grep -q "^Exec=copperscope %f$" share/applications/*.desktop || failed "the menu entry does not start the program"
for icon in share/icons/hicolor/*/apps/*; do
    case $icon in */copperscope.png | */copperscope.svg | */\*) ;; *) failed "there is an icon of another name: $icon" ;; esac
done
! find . -path '*.a' -o -name '*.h' -o -name '*_manual' | grep . || failed "that is not to be installed"

export HOME=$scratch/home
bin/copperscope info >info.txt || failed "the installed program cannot read its sample"
grep -q "^job " info.txt || failed "it says nothing of its sample"
rm -r share/copperscope
status=0
bin/copperscope info >/dev/null 2>error.txt || status=$?
[ "$status" = 2 ] || failed "without its sample it answers $status"
grep -qF "$scratch/moved/share/copperscope/sample/" error.txt || failed "its sample is not the one beside it: $(cat error.txt)"
! ldd bin/copperscope | grep -i 'not found' || failed "libraries are missing"
echo "$(wc -l <"$scratch/log") files installed"
