# What scripts/soak.sh and its like share: writes what a script measured into docs/reliability.md, and brings along what builds and runs it.
# shellcheck shell=bash source-path=SCRIPTDIR disable=SC2154
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
. "$(dirname "${BASH_SOURCE[0]}")/build.sh"
. "$(dirname "${BASH_SOURCE[0]}")/testing.sh"

# "Measured on 2026-01-31 at commit 1a2b3c4, preset asan, 2 cores." The commit is that of the sources; changes that are not committed are named.
measured_at() {
    local commit changed=""
    commit=$(git -C "$root" rev-parse --short=10 HEAD)
    git -C "$root" diff --quiet HEAD -- . ':!docs' || changed=" with changes"
    echo "Measured on $(date -u +%Y-%m-%d) at commit $commit$changed, preset $1, $(nproc) cores."
}

# write_numbers KEY TITLE <TEXT: sets the section of this key, or adds it at the end; the others stay.
write_numbers() {
    local key=$1 title=$2 page=$root/docs/reliability.md body
    body=$(cat)
    [ -e "$page" ] || printf '# Reliability\n\nSections between comments are written by the scripts they name.\n' >"$page"
    if ! grep -qxF "<!-- $key -->" "$page"; then
        printf '\n<!-- %s -->\n<!-- end of %s -->\n' "$key" "$key" >>"$page"
    fi
    KEY=$key TEXT=$(printf '## %s\n\n%s' "$title" "$body") awk '
        $0 == "<!-- end of " ENVIRON["KEY"] " -->" { skips = 0 }
        !skips { print }
        $0 == "<!-- " ENVIRON["KEY"] " -->" { print ENVIRON["TEXT"]; skips = 1 }' "$page" >"$page.new"
    mv "$page.new" "$page"
}
