#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the npm packages that the tests need, in the versions that tests/gltf/package-lock.json names, into a folder.
# Does nothing when they are there already. ctest runs it before the tests that need them.
# Usage: scripts/node-packages.sh FOLDER
set -euo pipefail
source="$(dirname "${BASH_SOURCE[0]}")/../tests/gltf"
readonly folder="$1"

fail() {
    echo "node-packages: $*" >&2
    exit 1
}

command -v node >/dev/null || fail "nodejs is missing; scripts/setup.sh test installs it"
if cmp -s "$source/package-lock.json" "$folder/installed-lock.json"; then
    exit 0
fi
command -v npm >/dev/null || fail "npm is missing; scripts/setup.sh test installs it"

mkdir -p "$folder"
rm -f "$folder/installed-lock.json"
cp "$source/package.json" "$source/package-lock.json" "$folder"
npm ci --prefix "$folder" --ignore-scripts --no-audit --no-fund >"$folder/npm.log" 2>&1 ||
    fail "npm could not install gltf-validator from its registry: $(tail -n 5 "$folder/npm.log")"
cp "$source/package-lock.json" "$folder/installed-lock.json"
