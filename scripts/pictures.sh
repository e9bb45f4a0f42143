#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Renders the samples for README.md into docs/pictures.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for recipe in resources/recipes/*.json; do
    name="$(basename "$recipe" .json)"
    ./run replay "$recipe" --png "docs/pictures/$name.png" --size 640x560
done
