#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Configures a preset if necessary and builds it; shows the compiler's output only if it fails.
# Usage: scripts/build.sh PRESET [TARGET…]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly preset="$1"
shift
readonly folder="build/$preset"
readonly log="$folder/build.log"
mkdir -p "$folder"

# Two builds at the same time in one folder would damage it: the second waits.
exec 9>"$folder/build.lock"
flock 9

fail() {
    [[ -t 2 ]] && printf '\r\033[K' >&2
    # The compiler's messages without the progress and the long command lines between them.
    sed -e '/^\[[0-9]*\/[0-9]*\] /d' -e '/^FAILED: /{n;d}' "$log" | tail -n 200 >&2
    echo "build: $1 failed ($log has everything)" >&2
    exit 1
}

if [[ ! -f "$folder/build.ninja" ]]; then
    configure=(cmake --preset "$preset")
    # Clang compiles this code in two thirds of the time that GCC takes.
    if [[ "$preset" == release && -z "${CXX:-}" ]] && command -v clang++-16 >/dev/null; then
        configure+=(-DCMAKE_CXX_COMPILER=clang++-16)
    fi
    "${configure[@]}" >"$log" 2>&1 || fail configuring
fi

build=(cmake --build --preset "$preset" --parallel "$(nproc)")
if (($# > 0)); then
    build+=(--target "$@")
fi
if [[ -t 2 ]]; then
    "${build[@]}" 2>&1 | tee "$log" | while IFS= read -r line; do
        [[ "$line" == \[* ]] && printf '\r\033[K%s' "${line:0:$((${COLUMNS:-80} - 1))}" >&2
    done || fail building
    printf '\r\033[K' >&2
else
    "${build[@]}" >"$log" 2>&1 || fail building
fi
