#!/usr/bin/env bash
# Tests of the functions in scripts/setup.sh that decide something: setup_test.sh ROOT SCRATCH
set -euo pipefail
root=$1
scratch=$2
# shellcheck source=/dev/null
. "$root/scripts/setup.sh"
failures=0

# expect WHAT WANTED GOT
expect() {
    [ "$2" != "$3" ] || return 0
    printf 'FAILED: %s\n  wanted: %s\n  got:    %s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
}

# A file of the given name with the text on stdin; prints its path.
file() {
    mkdir -p "$(dirname "$scratch/$1")"
    cat >"$scratch/$1"
    echo "$scratch/$1"
}

test_stanza_becomes_one_for_backports() {
    local source
    source=$(file debian.sources <<'END'
# a comment
Types: deb
URIs: https://elsewhere.example/tools
Suites: bookworm
Components: main

Types: deb deb-src
# another one
URIs: http://mirror.example/debian/
Suites: bookworm bookworm-updates
Components: main contrib
Architectures: amd64
Signed-By:
 -----BEGIN PGP PUBLIC KEY BLOCK-----
 .
 AAAA

Types: deb
URIs: http://mirror.example/debian-security
Suites: bookworm-security
Components: main
END
    )
    expect "a stanza keeps its options and loses suites and components" "Types: deb
Suites: bookworm-backports
Components: main
URIs: http://mirror.example/debian/
Architectures: amd64
Signed-By:
 -----BEGIN PGP PUBLIC KEY BLOCK-----
 .
 AAAA" "$(derive_backports "$source" http://mirror.example/debian/)"
}

test_unusable_stanzas_are_passed_over() {
    local source
    source=$(file off.sources <<'END'
Enabled: no
Types: deb
URIs: http://mirror.example/debian
Suites: bookworm
Components: main

Types: deb-src
URIs: http://mirror.example/debian
Suites: bookworm
Components: main

Types: deb
URIs: http://mirror.example/debian
Suites:
 bookworm-updates
 bookworm
Components: main
Trusted: yes
END
    )
    expect "switched-off and source-only stanzas are passed over, folded fields are read" "Types: deb
Suites: bookworm-backports
Components: main
URIs: http://mirror.example/debian
Trusted: yes" "$(derive_backports "$source" http://mirror.example/debian/)"
}

test_line_becomes_one_for_backports() {
    local source
    source=$(file sources.list <<'END'
# deb http://mirror.example/debian bookworm main
deb cdrom:[Debian GNU/Linux 12]/ bookworm main
deb-src http://mirror.example/debian bookworm main
deb http://mirror.example/debian-security bookworm-security main
deb http://elsewhere.example/tools bookworm main
deb [ arch=amd64 signed-by=/keys/k.gpg ] http://mirror.example/debian bookworm main contrib # comment
END
    )
    expect "a line keeps its options" "deb [ arch=amd64 signed-by=/keys/k.gpg ] http://mirror.example/debian bookworm-backports main" \
        "$(derive_backports "$source" http://mirror.example/debian/)"
}

test_other_servers_give_nothing() {
    local source
    source=$(echo "deb http://elsewhere.example/tools bookworm main" | file other.list)
    expect "an entry of another server is not taken" "" "$(derive_backports "$source" http://mirror.example/debian)"
}

# machine NAME KERNEL_DRIVER MANIFEST: a folder that looks like / of a machine with this graphics driver and Vulkan manifest ("" = none).
machine() {
    local at=$scratch/$1
    rm -rf "$at"
    mkdir -p "$at/usr/share/vulkan/icd.d" "$at/drivers/$2"
    if [ -n "$2" ]; then
        mkdir -p "$at/sys/class/drm/renderD128/device"
        ln -s "$at/drivers/$2" "$at/sys/class/drm/renderD128/device/driver"
    fi
    [ -z "$3" ] || touch "$at/usr/share/vulkan/icd.d/$3"
    vulkan_kind "$at"
}

test_hardware_is_told_from_software() {
    expect "no graphics at all" none "$(machine bare '' '')"
    expect "the software device is no hardware" none "$(machine soft '' lvp_icd.x86_64.json)"
    expect "Intel graphics with its driver" hardware "$(machine intel i915 intel_icd.x86_64.json)"
    expect "AMD graphics without a driver" driverless "$(machine amd amdgpu lvp_icd.x86_64.json)"
    expect "AMD graphics with a driver for something else" driverless "$(machine amd2 amdgpu intel_icd.x86_64.json)"
    expect "a virtual machine's display" none "$(machine virtual virtio_gpu virtio_icd.x86_64.json)"
    expect "NVIDIA's own driver" hardware "$(machine nvidia nvidia nvidia_icd.json)"
    expect "NVIDIA without its driver is not ours to repair" none "$(machine nvidia2 nvidia lvp_icd.x86_64.json)"
}

test_packages_are_named_once_with_a_purpose() {
    local rows
    rows=$(package_rows build run software wayland test check)
    expect "no package is listed twice" "" "$(cut -d ' ' -f 1 <<<"$rows" | sort | uniq -d)"
    expect "every package says what it is for" "" "$(awk 'NF < 3' <<<"$rows")"
    expect "sections are kept apart" "xvfb libocct-data-exchange-dev libfontconfig-dev libtinygltf-dev vulkan-validationlayers desktop-file-utils appstream libxml2-utils groff-base zsh strace" "$(package_names test | xargs)"
    expect "fuzzing needs git for its table" "clang libclang-rt-dev git" "$(package_names fuzz | xargs)"
}

# user_without_root "PACKAGE VERSION"...: what ./test says to a user who may not install on a Debian 12 without graphics card, and the code
# it ends with; of g++ and mesa-vulkan-drivers those given are installed.
user_without_root() {
    local made_up=$scratch/without_root there
    there=$(printf '%s\n' "$@")
    mkdir -p "$made_up/scripts"
    printf 'build g++ compiles\nsoftware mesa-vulkan-drivers draws\n' >"$made_up/scripts/packages.txt"
    (
        root=$made_up
        id() { echo 1000; }
        sudo() { return 1; }
        codename() { echo bookworm; }
        vulkan_kind() { echo none; }
        require_dpkg() { :; }
        installed_versions() { for name; do grep "^$name " <<<"$there" || true; done; }
        apt_get() { echo "installs" >&2; }
        trap 'echo "code $?"' EXIT
        set -e  # as ./test does; a call in a condition would switch it off
        setup_machine build software
    ) 2>&1
    return 0
}

test_an_older_mesa_is_enough_for_who_may_not_install() {
    local said
    rm -rf "$scratch/without_root"
    said=$(user_without_root "g++ 12" "mesa-vulkan-drivers 22.3.6")
    expect "the older software device is kept" "copperscope: this machine lacks:
    mesa-vulkan-drivers       draws
copperscope: sudo does not let you: going on with the older software device, which has the \`pull\` back end only
code 0" "$said"
    expect "it is said once" "code 0" "$(user_without_root "g++ 12" "mesa-vulkan-drivers 22.3.6")"
    rm -rf "$scratch/without_root"
    said=$(user_without_root "g++ 12")
    expect "without any device it ends" "code 4" "$(tail -n 1 <<<"$said")"
    expect "it names what to install by hand" "    apt-get install --no-install-recommends mesa-vulkan-drivers" "$(grep apt-get <<<"$said")"
    said=$(user_without_root "mesa-vulkan-drivers 22.3.6")
    expect "what the build needs is no choice" "    apt-get install --no-install-recommends g++" "$(grep apt-get <<<"$said")"
}

mkdir -p "$scratch"
for name in $(compgen -A function test_); do
    "$name"
done
rm -rf "$scratch"
[ "$failures" = 0 ]
