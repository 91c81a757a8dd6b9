#!/usr/bin/env bash
# Makes the pictures of docs/guide: scripts/guide_pictures.sh PROGRAM [FOLDER]. Drives the program on the bundled sample board with real keys and a real
# mouse on a display of its own (1280x800), and cuts the pictures out of the screen. Look at them before they are committed.
# On a busy machine `settle` and `first` are the seconds to wait before a picture and after a start, for example settle=8 first=40.
# Needs Xvfb, xdotool, ImageMagick (import, convert) and the software Vulkan device.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
readonly root program=$(readlink -f "$1") out=$(readlink -f "${2:-$root/docs/guide}")
scratch=$(mktemp -d)
readonly scratch
trap 'stop_program; kill "${display_pid:-}" 2>/dev/null || true; rm -rf "$scratch"' EXIT

start_display() {
    exec 8< <(exec timeout 1800 Xvfb -displayfd 1 -screen 0 1280x800x24 -nolisten tcp 2>/dev/null)
    display_pid=$!
    local number
    read -r -t 30 -u 8 number
    export DISPLAY=:$number QT_QPA_PLATFORM=xcb XDG_CONFIG_HOME=$scratch/config XDG_RUNTIME_DIR=$scratch/runtime
    VK_DRIVER_FILES=$(compgen -G '/usr/share/vulkan/icd.d/lvp_icd*.json' | head -n 1)
    export VK_DRIVER_FILES
    unset WAYLAND_DISPLAY
    mkdir -p -m 700 "$scratch/runtime"
}

stop_program() {
    [ -z "${program_pid:-}" ] || kill "$program_pid" 2>/dev/null || true
    program_pid=
}

# start BOARD: a fresh window, in which the notice of software devices was seen.
start() {
    stop_program
    rm -rf "$XDG_CONFIG_HOME"
    mkdir -p "$XDG_CONFIG_HOME/Copperscope"
    printf '[window]\nknows%%20software%%20device=true\n[files]\nfolder=/tmp\n' >"$XDG_CONFIG_HOME/Copperscope/Copperscope.conf"
    timeout 900 "$program" "$@" >"$scratch/log" 2>&1 &
    program_pid=$!
    sleep "${first:-10}"
    local window
    window=$(window_named 'Copperscope$')
    xdotool windowmove "$window" 0 0
    xdotool windowsize "$window" 1280 800  # it left room for a frame
    focus 'Copperscope$'
}

# window_named TITLE: waits for it; a search fails where another window goes while it looks.
window_named() {
    local window
    for _ in $(seq 40); do
        window=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -n 1) || true
        [ -z "$window" ] || break
        sleep 0.5
    done
    [ -n "$window" ] || { echo "there is no window $1" >&2; return 1; }
    echo "$window"
}

# focus TITLE: there is no window manager that would do it.
focus() {
    xdotool windowfocus "$(window_named "$1")"
    sleep 0.5
}

press() {
    local key
    for key in "$@"; do
        xdotool key "$key"
        sleep 0.7
    done
}

write() { xdotool type --delay 40 "$1"; sleep 1; }
point() { xdotool mousemove "$1" "$2"; sleep 0.8; }
click() { point "$1" "$2"; xdotool click "${3:-1}"; sleep 0.8; }

# drag X0 Y0 X1 Y1 [BUTTON]
drag() {
    local i
    xdotool mousemove "$1" "$2" mousedown "${5:-1}"
    for i in 1 2 3 4 5 6 7 8; do
        xdotool mousemove $(($1 + ($3 - $1) * i / 8)) $(($2 + ($4 - $2) * i / 8))
        sleep 0.05
    done
    xdotool mouseup "${5:-1}"
    sleep 1
}

# shrink NAME [GEOMETRY]: that part of what is on the screen, not wider than the page of the guide, in 128 colours.
shrink() {
    convert "$scratch/screen.png" ${2:+-crop "$2" +repage} -resize '760x>' -dither None -colors 128 -strip -define png:compression-level=9 "$out/$1.png"
    echo "$1: $(stat -c %s "$out/$1.png") bytes"
}

# take NAME [GEOMETRY]: once the picture has settled.
take() {
    xdotool mousemove 900 8  # what it rests on in a view is outlined, and elsewhere has a tip
    sleep "${settle:-3}"
    import -window root -silent "$scratch/screen.png"
    shrink "$@"
}

# take_window TITLE NAME: a dialog.
take_window() {
    focus "$1"
    sleep "${settle:-3}"
    import -window "$(window_named "$1")" -silent "$scratch/screen.png"
    shrink "$2"
}

# A job of Gerber files with names that say little.
make_gerber_job() {
    local file
    mkdir -p "$1"
    for file in top.art gnd.art bottom.art mask_t.art fab.art; do
        printf '%%FSLAX46Y46*%%\n%%MOMM*%%\n%%ADD10C,0.25*%%\nD10*\nX0Y0D02*\nX30000000D01*\nY20000000D01*\nX0D01*\nY0D01*\nM02*\n' >"$1/$file"
    done
    printf 'M48\nMETRIC,TZ\nT1C0.3\n%%\nT1\nX10.0Y5.0\nX15.0Y5.0\nM30\n' >"$1/holes.drl"
}

# A later revision of the sample: on its top layer a pad is moved, another one is gone, and there is a track more.
make_revision() {
    local features=$scratch/revision/odb/steps/pcb/layers/l01-top_layer/features
    mkdir "$scratch/revision"
    tar -xzf "$scratch/timecard.tgz" -C "$scratch/revision"
    awk '/^P 37\.85/ && $3 < 8 { $2 += 0.6 } !/^P 43\.1/' "$features" >"$scratch/features"
    { cat "$scratch/features"; echo 'L 33 6 36 7 0 P 0'; } >"$features"
    tar -czf "$1" -C "$scratch/revision" odb
}

views() {
    take window
    press ctrl+f
    write 1PPS
    take find 480x120+398+40
    press Return ctrl+F11
    take nets 1280x736+0+30
    press Escape Escape ctrl+F10
    take stackup 322x720+0+54
    press ctrl+F9 3
    point 800 600
    press i f e
    sleep "${settle:-3}"
    take explode 950x620+325+90
    point 800 600
    press e 4
}

distances() {
    press ctrl+0
    sleep "${settle:-3}"
    point 600 300
    press f shift+m
    click 712 298
    click 712 341
    press Escape
    point 716 320
    xdotool click --repeat 6 --delay 150 4
    take measuring 1280x736+0+30
    press ctrl+z ctrl+F12 ctrl+shift+g
    sleep "${settle:-3}"
    press F8
    take clearances 1280x736+0+30
    press shift+g
    take map 476x500+325+54
    press shift+g Escape Escape ctrl+alt+r
    take_window '^Rules$' rules
    press Escape
    focus 'Copperscope$'
}

cuts() {
    press ctrl+F9 ctrl+alt+0
    sleep "${settle:-3}"
    point 600 200
    press f shift+s
    drag 430 330 770 330
    take section 1280x736+0+30
    press alt+x 3
    point 800 200
    press i f
    take plane 950x400+325+54
    press ctrl+e
    take_window '^Export$' export
}

revisions() {
    make_revision "$scratch/revision-b.tgz"
    press ctrl+F9 ctrl+alt+c
    write "$scratch/revision-b.tgz"
    press Return
    sleep "${settle:-3}"
    click 600 665
    take comparing 1280x736+0+30
}

start_display
cp "$root/resources/sample/ocp_tap_sa45_odb.tgz" "$scratch/timecard.tgz"
start "$scratch/timecard.tgz"
views
distances
cuts
start "$scratch/timecard.tgz"
revisions

mkdir "$scratch/board"
cp "$scratch/timecard.tgz" "$root/tests/data/kicad/small.kicad_pcb" "$scratch/board"
start "$scratch/board"
take_window '^Choose a form$' forms
make_gerber_job "$scratch/job"
start "$scratch/job"
press ctrl+alt+a
take_window '^Assign layers$' assign
