#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of README.md, in docs/pictures, those of the help, in docs/help/pictures, and those of the library, in
# resources/thumbnails. "readme", "help", "strands" or "library" as an argument makes only these. Needs ImageMagick.
# "strands" are the figures of Strands 2024 and Okabe 2005 in README.md and in the help, as tests/gallery/strand-figures.json
# describes them; it takes names of pictures: scripts/pictures.sh strands strands-alpha. "library" takes names of recipes:
# scripts/pictures.sh library oak willow.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
readonly what="${1:-all}"

if [[ "$what" == all || "$what" == readme ]]; then
    picture="$(mktemp --suffix .png)"
    for name in bonsai candelabra helix lobed oak spruce swan willow windswept; do
        ./run replay "resources/recipes/$name.json" --png "$picture" --size 640x560
        convert "$picture" -strip -quality 88 "docs/pictures/$name.jpg"
    done
    rm -f "$picture"
fi

if [[ "$what" == all || "$what" == help ]]; then
    scripts/setup.sh build test display
    scripts/build.sh release help_pictures
    home="$(mktemp -d)" # The person's own settings have no part in them.
    trap 'rm -rf "$home"' EXIT
    HOME="$home" XDG_CONFIG_HOME="$home" XDG_DATA_HOME="$home" LANGUAGE=en LC_ALL=C.UTF-8 QT_QPA_PLATFORM=xcb \
        xvfb-run -a -s "-screen 0 1600x1000x24 +extension GLX -noreset" \
        build/release/bin/help_pictures docs/help/pictures
fi

if [[ "$what" == all || "$what" == strands ]]; then
    scripts/setup.sh build test display
    scripts/build.sh release strand_figures
    QT_QPA_PLATFORM=xcb xvfb-run -a -s "-screen 0 1600x1000x24 +extension GLX -noreset" \
        build/release/bin/strand_figures tests/gallery/strand-figures.json . "${@:2}"
fi

if [[ "$what" == all || "$what" == library ]]; then
    names=("${@:2}")
    if [[ ${#names[@]} -eq 0 ]]; then
        for recipe in resources/recipes/*.json; do
            names+=("$(basename "$recipe" .json)")
        done
    fi
    picture="$(mktemp --suffix .png)"
    for name in "${names[@]}"; do
        ./run replay "resources/recipes/$name.json" --png "$picture" --size 640x560
        convert "$picture" -resize 256x224 -strip -sampling-factor 4:2:0 -quality 86 "resources/thumbnails/$name.jpg"
    done
    rm -f "$picture"
fi
