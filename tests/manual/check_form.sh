#!/usr/bin/env bash
# check_form.sh KIND FILE...: whether what is installed has the form that its readers want. 77 where the distribution's checker is not there.
set -euo pipefail

needs() {
    command -v "$1" >/dev/null || { echo "not run: there is no $1 on this machine"; exit 77; }
}

failed() {
    echo "$*" >&2
    exit 1
}

check_man() {
    needs groff
    local page warnings count=0
    for page in "$1"/*.1; do
        warnings=$(groff -man -Tutf8 -ww -z "$page" 2>&1)
        [ -z "$warnings" ] || failed "$page: $warnings"
        count=$((count + 1))
    done
    [ "$count" -gt 5 ] || failed "there are $count man pages in $1"
}

check_bash() { bash -n "$1"; }

check_zsh() {
    needs zsh
    zsh -n "$1"
}

check_desktop() {
    needs desktop-file-validate
    local said
    said=$(desktop-file-validate "$1" 2>&1) || failed "$said"
    [ -z "$said" ] || failed "$said"
}

# A homepage is COPPERSCOPE_HOMEPAGE's to say; builds without one lack it.
check_metainfo() {
    needs appstreamcli
    local said
    said=$(appstreamcli validate --no-net "$1" 2>&1) || [ "$(grep -E '^[EW]:' <<<"$said" | sed 's/.*: //')" = url-homepage-missing ] || failed "$said"
}

# Well formed, and neither it nor the desktop file claims a type that is not of boards alone.
check_mime() {
    needs xmllint
    xmllint --noout "$1"
    local claimed
    claimed=$(grep -E '^MimeType=' "$2" | grep -oE 'application/(zip|xml|json|gzip|x-compressed-tar|x-tar)|text/plain') || true
    [ -z "$claimed" ] || failed "$2 claims $claimed"
    claimed=$(grep -oE 'pattern="\*\.(zip|xml|tgz|tar|tar\.gz|gz|json|txt)"' "$1") || true
    [ -z "$claimed" ] || failed "$1 claims $claimed"
    local type
    for type in $(sed -n 's/^MimeType=//p' "$2" | tr ';' ' '); do
        grep -q "mime-type type=\"$type\"" "$1" || failed "$1 does not describe $type"
    done
}

# Every PNG is as large as its name says: width and height are the 17th to 24th byte.
check_icons() {
    local file size
    for file in "$1"/copperscope-*.png; do
        size=$(od -An -tu1 -j16 -N8 "$file" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }')
        [ "$file $size" = "$1/copperscope-${size%x*}.png ${size%x*}x${size%x*}" ] || failed "$file is $size"
    done
}

kind=$1
shift
"check_$kind" "$@"
