#!/usr/bin/env bash
# Makes the icon in the usual sizes from resources/desktop/icons/copperscope.svg, beside it: scripts/icons.sh (needs rsvg-convert).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../resources/desktop/icons"
for size in 16 22 24 32 48 64 128 256; do
    rsvg-convert -w "$size" -h "$size" copperscope.svg -o "copperscope-$size.png"
done
