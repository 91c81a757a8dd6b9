#!/usr/bin/env bash
# Writes what a build consists of as a bill of materials in CycloneDX 1.5 (JSON) to stdout: scripts/sbom.sh [PROGRAM]
# Components are the packages of the distribution that hold the libraries the program is linked with, directly or through others, and those
# whose headers are compiled in. The same build gives the same bytes.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
program=${1:-$root/build/package/app/copperscope}
readonly headers="libcgal-dev libboost-dev libcli11-dev libglm-dev nlohmann-json3-dev libspdlog-dev libmeshoptimizer-dev"

[ -x "$program" ] || { echo "sbom: there is no program $program (scripts/package.sh makes it)" >&2; exit 1; }

# The packages that hold the libraries. Where /lib is /usr/lib, dpkg knows some by the one name and some by the other.
linked_packages() {
    local libraries found
    mapfile -t libraries < <(ldd "$program" | awk '$2 == "=>" { print $3 } $1 ~ /^\/lib/ { print $1 }' | xargs -n 1 readlink -f | sort -u)
    found=$(dpkg-query -S "${libraries[@]}" "${libraries[@]#/usr}" 2>/dev/null || true)
    local library
    for library in "${libraries[@]}"; do
        awk -v path="$library" '$2 == path || "/usr" $2 == path { found = 1 } END { exit !found }' <<<"$found" || echo "sbom: no package holds $library" >&2
    done
    sed 's/: .*//' <<<"$found" | sort -u
}

# rows USE PACKAGE…: "USE name version architecture", by name.
rows() {
    local use=$1
    shift
    dpkg-query -W -f "$use \${Package} \${Version} \${Architecture}\n" "$@" | sort -u
}

encoded() { sed 's/+/%2B/g; s/:/%3A/g; s/~/%7E/g' <<<"$1"; }

components() {
    local use name version architecture between=""
    while read -r use name version architecture; do
        printf '%s    {"type": "library", "bom-ref": "%s", "name": "%s", "version": "%s", "scope": "required",\n' "$between" "$name" "$name" "$version"
        printf '     "purl": "pkg:deb/%s/%s@%s?arch=%s&distro=%s",\n' "$system" "$(encoded "$name")" "$(encoded "$version")" "$architecture" "$system-$release"
        printf '     "properties": [{"name": "copperscope:use", "value": "%s"}]}' "$use"
        between=$',\n'
    done <<<"$parts"
}

version=$("$program" --version)
system=$(sed -n 's/^ID=//p' /etc/os-release)
release=$(sed -n 's/^VERSION_ID=//p' /etc/os-release | tr -d '"')
# shellcheck disable=SC2046,SC2086
parts=$(rows compiled-in $headers && rows linked $(linked_packages))
names=$(awk '{ print "\"" $2 "\"" }' <<<"$parts" | paste -sd,)
cat <<BILL
{
  "bomFormat": "CycloneDX",
  "specVersion": "1.5",
  "version": 1,
  "metadata": {
    "component": {"type": "application", "bom-ref": "copperscope", "name": "copperscope", "version": "$(awk '{ sub(",", "", $2); print $2 }' <<<"$version")",
                  "licenses": [{"license": {"id": "GPL-3.0-or-later"}}],
                  "hashes": [{"alg": "SHA-256", "content": "$(sha256sum "$program" | cut -d' ' -f1)"}],
                  "properties": [{"name": "copperscope:commit", "value": "$(sed -n 's/.*commit //p' <<<"$version")"}]}
  },
  "components": [
$(components)
  ],
  "dependencies": [{"ref": "copperscope", "dependsOn": [$names]}]
}
BILL
