# The surroundings in which tests run the same everywhere. Sourced by ./test and scripts/check.sh after setup.sh and build.sh.
# shellcheck shell=bash disable=SC2154

# Display, device and settings of their own for everything that runs after this.
use_test_surroundings() {
    use_windowless_surroundings "$1"
    start_display "$1"
}

# The same without a display.
use_windowless_surroundings() {
    local scratch=$1
    mkdir -p "$scratch/config" "$scratch/data" "$scratch/runtime"
    use_utf8
    use_software_device
    # Settings written by the tests stay out of the user's own.
    export XDG_CONFIG_HOME=$scratch/config XDG_DATA_HOME=$scratch/data XDG_RUNTIME_DIR=$scratch/runtime
    chmod 700 "$scratch/runtime"
    # Windows look for the desktop's bus. Where there is none libdbus forks to start it, and once in ten starts under the address sanitizer it waited
    # for the child without end.
    export DBUS_SESSION_BUS_ADDRESS=disabled:
    # Tests run in other folders than the caller.
    [ -z "${COPPERSCOPE_BOARDS:-}" ] || COPPERSCOPE_BOARDS=$(readlink -m "$COPPERSCOPE_BOARDS")
}

# Xvfb picks a free display and writes its number when it is ready. `timeout` ends it even if this script is killed.
start_display() {
    exec 8< <(exec timeout 7200 Xvfb -displayfd 1 -screen 0 1600x1000x24 -nolisten tcp 2>"$1/xvfb.log")
    display_pid=$!
    trap 'kill "$display_pid" 2>/dev/null || true' EXIT
    trap 'exit 130' INT
    trap 'exit 143' TERM
    local number
    read -r -t 30 -u 8 number || die "$kSetupFailed" "Xvfb did not start; see $1/xvfb.log"
    export DISPLAY=:$number QT_QPA_PLATFORM=xcb
    unset WAYLAND_DISPLAY
}

# Pictures are then the same everywhere. COPPERSCOPE_TEST_GPU=1 leaves the choice to the Vulkan loader, as does a choice made before.
use_software_device() {
    [ -z "${COPPERSCOPE_TEST_GPU:-}${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ] || return 0
    local manifest
    manifest=$(compgen -G '/usr/share/vulkan/icd.d/lvp_icd*.json' | head -n 1) || true
    [ -n "$manifest" ] || die "$kSetupFailed" "the software Vulkan device (package mesa-vulkan-drivers) is missing"
    export VK_DRIVER_FILES=$manifest VK_ICD_FILENAMES=$manifest
}
