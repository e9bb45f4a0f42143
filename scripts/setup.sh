#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian packages that are needed and missing. Prints nothing if none is missing.
# Usage: scripts/setup.sh [build] [display] [test] [bench] [fresh] [nightly] [threads]     (build when nothing is named)
set -euo pipefail

readonly build=(
    g++ clang-16 cmake ninja-build ccache
    qt6-base-dev libqt6opengl6-dev qt6-svg-dev qt6-tools-dev qt6-l10n-tools qt6-translations-l10n
    libassimp-dev libeigen3-dev libmeshoptimizer-dev libopenmesh-dev libtbb-dev libzip-dev zlib1g-dev
)
readonly display=(xvfb xauth libgl1-mesa-dri)
test=("${display[@]}" blender python3 python3-numpy clang-format)
# Other packages of Node.js than Debian's bring npm along and conflict with Debian's.
command -v npm >/dev/null || test+=(nodejs npm)
readonly test
readonly bench=(libbenchmark-dev)
readonly fresh=(debootstrap)
readonly nightly=(libclang-rt-16-dev clang-tidy)
readonly threads=(clang-16 libclang-rt-16-dev llvm-16)

fail() {
    echo "setup: $*" >&2
    exit 1
}

wanted=()
for group in "${@:-build}"; do
    case "$group" in
        build) wanted+=("${build[@]}") ;;
        display) wanted+=("${display[@]}") ;;
        test) wanted+=("${test[@]}") ;;
        bench) wanted+=("${bench[@]}") ;;
        fresh) wanted+=("${fresh[@]}") ;;
        nightly) wanted+=("${nightly[@]}") ;;
        threads) wanted+=("${threads[@]}") ;;
        *) fail "there is no group '$group'; there are build, display, test, bench, fresh, nightly and threads" ;;
    esac
done

# On other systems the user installs these; CMake names missing packages.
if ! command -v dpkg-query >/dev/null; then
    exit 0
fi

installed=" $(dpkg-query --show --showformat '${db:Status-Status}:${Package} ' 2>/dev/null) "
missing=()
for package in "${wanted[@]}"; do
    [[ "$installed" == *" installed:$package "* ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
    exit 0
fi

as_root=(env)
if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "please install, as root: apt-get install ${missing[*]}"
    as_root=(sudo env)
fi

log="$(mktemp)"
trap 'rm -f "$log"' EXIT
apt() {
    "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 \
        -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" >"$log" 2>&1
}

echo "setup: installing ${missing[*]}" >&2
apt update || fail "apt-get update failed: $(tail -n 1 "$log")"
apt install --yes --no-install-recommends "${missing[@]}" ||
    fail "apt-get install failed: $(grep '^E:' "$log" | head -n 1 || tail -n 1 "$log")"
