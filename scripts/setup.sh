# Brings a Debian or Ubuntu machine to the point where Copperscope builds and runs. Sourced by ./run, ./test and scripts/check.sh,
# which set `root` to the source folder. Prints and changes nothing when all is there; talk goes to stderr.
# COPPERSCOPE_SKIP_SETUP=1 skips it all, for machines that are prepared in another way.
# shellcheck shell=bash disable=SC2034,SC2119,SC2120,SC2154

readonly kSetupFailed=4  # exit codes of the front door; 0 to 3 are copperscope's own (docs/command-line.md)
readonly kBuildFailed=5
readonly kMeshShaderMesa=24.1  # the first Mesa whose software device has mesh shaders

say() { printf 'copperscope: %s\n' "$*" >&2; }

die() {
    local code=$1
    shift
    say "$@"
    exit "$code"
}

# Rows of packages.txt that belong to the given sections: "package purpose...".
package_rows() {
    awk -v sections=" $* " '!/^#/ && NF && index(sections, " " $1 " ") { $1 = ""; print substr($0, 2) }' \
        "$root/scripts/packages.txt"
}

package_names() { package_rows "$@" | cut -d ' ' -f 1; }

# "package version" for those of the given packages that are installed.
installed_versions() {
    dpkg-query -W -f '${db:Status-Status} ${Package} ${Version}\n' "$@" 2>/dev/null | sed -n 's/^installed //p' || true
}

# The Vulkan driver that Mesa or the maker has for a kernel graphics driver, as the stem of its manifest's name. No answer: none that
# is worth preferring to the software device (virtual machines, display-only devices).
manifest_stem() {
    case $1 in
        i915 | xe) echo intel ;;
        amdgpu) echo radeon ;;
        nouveau) echo nouveau ;;
        nvidia) echo nvidia ;;
        v3d) echo broadcom ;;
        msm | msm_dpu) echo freedreno ;;
    esac
}

# What this machine has for Vulkan: "hardware" (a GPU and its driver), "driverless" (a GPU, but its driver is not installed) or "none".
# The argument stands for / in the tests.
vulkan_kind() {
    local prefix=${1:-} node driver stem kind=none
    if [ -e "$prefix/proc/driver/nvidia/version" ] && has_manifest "$prefix" nvidia; then
        echo hardware
        return
    fi
    for node in "$prefix"/sys/class/drm/renderD*; do
        driver=$(basename "$(readlink "$node/device/driver" || true)")
        stem=$(manifest_stem "$driver")
        [ -n "$stem" ] || continue
        if has_manifest "$prefix" "$stem"; then
            echo hardware
            return
        fi
        # Only Mesa's drivers are ours to install; a maker's own driver is the owner's business.
        [ "$stem" = nvidia ] || kind=driverless
    done
    echo "$kind"
}

has_manifest() {
    compgen -G "$1/usr/share/vulkan/icd.d/$2_*.json" >/dev/null || compgen -G "$1/etc/vulkan/icd.d/$2_*.json" >/dev/null
}

# Makes sure that the packages of the given sections are installed. SECTION `software` also means: with mesh shaders if at all possible.
setup_machine() {
    [ -z "${COPPERSCOPE_SKIP_SETUP:-}" ] || return 0
    require_dpkg "$@"
    local names installed missing="" name
    mapfile -t names < <(package_names "$@")
    installed=$(installed_versions "${names[@]}")
    for name in "${names[@]}"; do
        case $'\n'$installed in *$'\n'"$name "*) ;; *) missing+=" $name" ;; esac
    done
    local newer_mesa=""
    wants_newer_mesa "$installed" "$@" && newer_mesa=yes
    [ -n "$missing$newer_mesa" ] || return 0

    [ -z "$newer_mesa" ] || missing=${missing/ mesa-vulkan-drivers/}
    announce "$missing${newer_mesa:+ mesa-vulkan-drivers}" "$@"
    if ! may_install; then
        local needed=$missing${newer_mesa:+$(mesa_if_missing)}
        [ -z "$needed" ] || give_up "$needed" "$why_not."
        keep_older_mesa "$why_not"
        return
    fi
    mkdir -p "$root/build" || give_up "$missing" "cannot write to $root/build."
    say "installing with apt-get (once; the log is build/setup.log)"
    install_packages "$missing"
    [ -z "$newer_mesa" ] || newer_mesa_or_pull || install_packages "$(mesa_if_missing)"
}

require_dpkg() {
    command -v dpkg-query >/dev/null && command -v apt-get >/dev/null && return
    say "this is no Debian or Ubuntu system, so the packages cannot be installed for you. Needed, by their Debian names:"
    package_rows "$@" | print_rows
    die "$kSetupFailed" "install these by hand, then call again with COPPERSCOPE_SKIP_SETUP=1"
}

print_rows() { awk '{ name = $1; $1 = ""; printf "    %-26s%s\n", name, substr($0, 2) }' >&2; }

# announce "MISSING" SECTION...: says what is to be installed and why.
announce() {
    local missing=" $1 "
    shift
    say "this machine lacks:"
    package_rows "$@" | while read -r name purpose; do
        case $missing in *" $name "*) echo "$name $purpose" ;; esac
    done | print_rows
}

# Whether this user can install packages; otherwise why_not says why.
may_install() {
    why_not=""
    [ "$(id -u)" != 0 ] || return 0
    command -v sudo >/dev/null || { why_not="you are not root, and there is no sudo"; return 1; }
    sudo true || { why_not="sudo does not let you"; return 1; }
}

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }

# Never removes a package to make room for ours, waits for another apt to finish, asks nothing, and keeps files of settings that were changed.
apt_get() {
    as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 \
        apt-get -y -q --no-remove -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 \
        -o Dpkg::Options::=--force-confdef -o Dpkg::Options::=--force-confold "$@" \
        >>"$root/build/setup.log" 2>&1 </dev/null
}

# install_packages "NAME NAME...": fresh machines have no package lists and old ones have stale lists; both show as a failure of the first try.
# Whether the update worked is judged by the second try, because some unrelated source of the machine may be broken.
install_packages() {
    local names
    read -r -a names <<<"$1"
    [ ${#names[@]} -gt 0 ] || return 0
    apt_get install --no-install-recommends "${names[@]}" && return
    apt_get update || true
    apt_get install --no-install-recommends "${names[@]}" && return
    say "apt-get says:"
    grep -E '^(E|Err|W):' "$root/build/setup.log" | tail -n 5 | sed 's/^/    /' >&2 || true
    give_up "$1" "the packages could not be installed; the whole log is build/setup.log."
}

# give_up "NAME NAME..." WHY
give_up() {
    say "$2 By hand, as root:"
    printf '    apt-get install --no-install-recommends %s\n' "$(xargs <<<"$1")" >&2
    exit "$kSetupFailed"
}

# --- Debian 12: a software device with mesh shaders comes from the backports suite -----------------------------------------------

readonly kNoBackports=build/no-backports  # left behind when the suite cannot be had or installed, so that it is tried once a day at most

wants_newer_mesa() {
    local installed=$1 version
    shift
    case " $* " in *" software "*) ;; *) return 1 ;; esac
    [ "$(codename)" = bookworm ] && [ -z "$(find "$root/$kNoBackports" -mtime -1 2>/dev/null)" ] && [ "$(vulkan_kind)" = none ] || return 1
    version=$(sed -n 's/^mesa-vulkan-drivers //p' <<<"$installed" | head -n 1)
    [ -z "$version" ] || dpkg --compare-versions "$version" lt "$kMeshShaderMesa"
}

codename() { sed -n 's/^VERSION_CODENAME=//p' /etc/os-release; }

# The ordinary suite's driver, when there is none at all.
mesa_if_missing() { [ -n "$(installed_versions mesa-vulkan-drivers)" ] || echo " mesa-vulkan-drivers"; }

newer_mesa_or_pull() {
    say "no hardware Vulkan driver here: the software one comes from Debian's bookworm-backports, where it has mesh shaders"
    add_backports && apt_get install --no-install-recommends -t bookworm-backports mesa-vulkan-drivers && return
    keep_older_mesa "bookworm-backports cannot be had"
    return 1
}

# keep_older_mesa WHY: says so, and leaves the mark that it was.
keep_older_mesa() {
    mkdir -p "$root/build" && touch "$root/$kNoBackports" || true
    say "$1: going on with the older software device, which has the \`pull\` back end only"
}

# Makes the suite known to apt: adds an entry unless the machine has one, and takes it back if the suite turns out not to be there.
add_backports() {
    local entry=""
    if ! grep -qsE '^[^#]*bookworm-backports' /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources; then
        entry=$(write_backports_entry) || return 1
    fi
    apt_get update || true
    apt-cache policy | grep -q 'n=bookworm-backports' && return
    [ -z "$entry" ] || as_root rm -f "$entry"
    return 1
}

# Prints the path of the entry, which is in the same form as the one it is derived from.
write_backports_entry() {
    local found file entry text
    found=$(debian_entry)
    if [ -z "$found" ]; then
        apt_get update || true
        found=$(debian_entry)
    fi
    file=${found#* }
    file=${file%:*}
    [ -r "$file" ] || return 1
    text=$(derive_backports "$file" "${found%% *}")
    [ -n "$text" ] || return 1
    entry=/etc/apt/sources.list.d/copperscope-backports.${file##*.}
    as_root tee "$entry" <<<"$text" >/dev/null && echo "$entry"
}

# "URI FILE:NUMBER" of the source that apt knows to be Debian's own bookworm; nothing while there are no package lists.
debian_entry() {
    # shellcheck disable=SC2016
    apt-get indextargets --format '$(REPO_URI) $(SOURCESENTRY)' 'Created-By: Packages' 'Origin: Debian' \
        'Codename: bookworm' 'Component: main' 2>/dev/null | head -n 1
}

# derive_backports FILE URI: the entry of an apt source file (deb822 or one-line form, told by its name) that serves bookworm from URI,
# turned into one for bookworm-backports. All its other options (keys, architectures, trust) stay as they are.
derive_backports() {
    case $1 in
        *.sources) derive_from_stanza "$@" ;;
        *) derive_from_line "$@" ;;
    esac
}

derive_from_line() {
    awk -v uri="${2%/}" '
        /^[ \t]*deb[ \t]/ {
            sub(/#.*/, "")
            options = ""
            if (match($0, /\[[^]]*\]/)) {
                options = substr($0, RSTART, RLENGTH) " "
                $0 = substr($0, 1, RSTART - 1) " " substr($0, RSTART + RLENGTH)
            }
            site = $2
            sub(/\/$/, "", site)
            if (site == uri && $3 == "bookworm") { print "deb " options $2 " bookworm-backports main"; exit }
        }' "$1"
}

derive_from_stanza() {
    awk -v uri="${2%/}" '
        function finish() {
            if (serves && here && binary && !disabled) {
                printf "Types: deb\nSuites: bookworm-backports\nComponents: main\n%s", kept
                done = 1
                exit
            }
            serves = here = binary = disabled = 0
            kept = field = ""
        }
        /^#/ { next }
        /^[ \t]*$/ { finish(); next }
        {
            if (!/^[ \t]/) { field = tolower($0); sub(/:.*/, "", field) }
            words = " " $0 " "
            sub(/^ [^ \t:]*:/, " ", words)
            gsub(/[ \t]+/, " ", words)
            if (field == "suites" && index(words, " bookworm ")) serves = 1
            if (field == "types" && index(words, " deb ")) binary = 1
            if (field == "uris" && (index(words, " " uri " ") || index(words, " " uri "/ "))) here = 1
            if (field == "enabled" && tolower(words) ~ /no|false|off|0/) disabled = 1
            if (field != "suites" && field != "types" && field != "components") kept = kept $0 "\n"
        }
        END { if (!done) finish() }' "$1"
}
