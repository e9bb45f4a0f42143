#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Takes pictures of the window with every panel, at all sizes and scales that are supported, dark and light, in
# English and in German, and lays each set out on a sheet: build/gallery/SIZE-THEME-LANGUAGE-SCALE.jpg, the pictures
# beside it in a folder of that name. Needs Xvfb and ImageMagick. Arguments choose sets: scripts/gallery.sh 1024 light
# takes those whose names contain all of them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly root="$PWD/build/gallery"
scripts/setup.sh build test display
scripts/build.sh release window_gallery
home="$(mktemp -d)" # The person's own settings have no part in them.
trap 'rm -rf "$home"' EXIT

wanted() {
    local word
    for word in "${words[@]}"; do
        [[ "$1" == *"$word"* ]] || return 1
    done
}

# The size is that of the screen; a scale makes the window smaller by as much, in its own pixels.
take() {
    local width="$1" height="$2" scale="$3" theme language name small
    for theme in dark light; do
        for language in en de; do
            name="${width}x$height-$theme-$language-$scale"
            wanted "$name" || continue
            rm -rf "${root:?}/$name"
            mkdir -p "$root/$name"
            local size
            size="$(awk "BEGIN { printf \"%dx%d\", $width / $scale, $height / $scale }")"
            echo "$name"
            HOME="$home" XDG_CONFIG_HOME="$home" XDG_DATA_HOME="$home" LANGUAGE=en LC_ALL=C.UTF-8 QT_QPA_PLATFORM=xcb \
                QT_SCALE_FACTOR="$scale" \
                xvfb-run -a -s "-screen 0 ${width}x${height}x24 +extension GLX -noreset" \
                build/release/bin/window_gallery "$size" "$theme" "$language" "$root/$name" >/dev/null
            # Scaled down one by one: all large pictures at once are too much for ImageMagick.
            small="$(mktemp -d)"
            mogrify -path "$small" -resize "1200x>" "$root/$name"/*.png
            montage "$small"/*.png -tile 3x -geometry +6+6 -background "#808080" -quality 88 "$root/$name.jpg"
            rm -r "$small"
        done
    done
}

words=("$@")
take 1024 700 1
take 1600 1000 1
take 1600 1050 1.5 # As 1066x700
take 3840 2160 1
take 3840 2160 2
take 3840 2160 3
