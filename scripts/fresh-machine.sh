#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs both commands of README.md on a bare Debian 12: makes one in a folder with debootstrap, copies this checkout into it
# (with changes that are not committed), and runs "./run --demo" and "./test" there as root, on two cores. Fails if a command
# fails, if a test of tests/tests.txt is missing or skipped, or if ./test needs more than 15 minutes of two cores. Prints how
# long each command took.
# Usage: scripts/fresh-machine.sh [FOLDER]     (a new or empty folder, which is kept; else a temporary one, which is removed)
# Needs root, debootstrap, 8 GB of disk space and the Debian mirror of this machine. The logs go to build/fresh-machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly most_minutes=15
readonly logs="$PWD/build/fresh-machine"
readonly certificates=/usr/local/share/ca-certificates

fail() {
    echo "fresh-machine: $*" >&2
    exit 1
}

say() {
    echo "$(date +%H:%M:%S) $*"
}

# The host's Debian mirror, also if its sources have the newer format.
mirror() {
    local found
    found="$(sed -nE -e 's/^deb (\[[^]]*\] )?(http[^ ]+) bookworm .*/\2/p' -e '/security/d;s/^URIs: *(http[^ ]+).*/\1/p' \
        /etc/apt/sources.list /etc/apt/sources.list.d/debian.sources 2>/dev/null | head -n 1 || true)"
    echo "${found:-http://deb.debian.org/debian}"
}

make_machine() {
    local root="$1" from="$2" file
    say "debootstrap from $from"
    debootstrap --variant=minbase bookworm "$root" "$from" >"$logs/debootstrap.log" 2>&1 ||
        fail "debootstrap failed: $(tail -n 1 "$logs/debootstrap.log")"
    echo "deb $from bookworm main" >"$root/etc/apt/sources.list"
    for file in /etc/resolv.conf /etc/hosts /etc/apt/apt.conf.d/*proxy*; do
        if [[ -f "$file" ]]; then
            cp -L "$file" "$root$file"
        fi
    done
    # The certificates by which this machine knows the servers of its network.
    mkdir -p "$root$certificates"
    cp "$certificates"/*.crt "$root$certificates" 2>/dev/null || true
    cat "$root$certificates"/*.crt >"$root$certificates.pem" 2>/dev/null || true
    mkdir "$root/root/espalier"
    git ls-files -z --cached --others --exclude-standard |
        while IFS= read -r -d '' file; do [[ -e "$file" ]] && printf '%s\0' "$file"; done |
        tar --create --null --files-from=- | tar --extract --directory "$root/root/espalier"
}

# Runs a command of the checkout in the machine. Writes seconds on the clock and of the processor to a file beside its log.
inside() {
    local root="$1" name="$2" status=0
    shift 2
    say "$*"
    local TIMEFORMAT="%R %U %S"
    {
        time chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
            NODE_EXTRA_CA_CERTS="$certificates.pem" ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
            /bin/bash -c 'cd /root/espalier && exec "$@"' bash "$@" >"$logs/$name.log" 2>&1
    } 2>"$logs/$name.time" || status=$?
    awk -v name="$*" '{ printf "         %s took %.1f min on the clock, %.1f min of processor time (%.1f on each of two cores)\n",
        name, $1 / 60, ($2 + $3) / 60, ($2 + $3) / 120 }' "$logs/$name.time"
    if ((status != 0)); then
        tail -n 60 "$logs/$name.log" >&2
    fi
    return "$status"
}

# Checks that all tests of the list have run and passed, and that none of their functions was skipped.
count_tests() {
    local checkout="$1" wanted passed skipped
    local -r last="$checkout/build/release/Testing/Temporary/LastTest.log"
    wanted="$(grep -cv -e '^#' -e '^$' tests/tests.txt)"
    passed="$(grep -c '^Test Passed\.$' "$last" || true)"
    skipped="$(sed -nE 's/^Totals: .* ([0-9]+) skipped.*/\1/p' "$last" | awk '{ sum += $1 } END { print sum + 0 }')"
    say "$passed of $wanted tests passed, $skipped functions skipped"
    [[ "$passed" == "$wanted" && "$skipped" == 0 ]] || fail "not every test ran and passed ($logs/test.log has the rest)"
}

# Runs inside the namespaces. Their mounts and processes end when this function ends, also on a failure.
run_all() {
    local root="$1" name
    make_machine "$root" "$(mirror)"
    mount -t proc proc "$root/proc"
    mount -t tmpfs -o mode=755 tmpfs "$root/dev"
    for name in null zero full random urandom tty; do
        touch "$root/dev/$name"
        mount --bind "/dev/$name" "$root/dev/$name"
    done
    ln -s /proc/self/fd "$root/dev/fd"
    ln -s /proc/self/fd/0 "$root/dev/stdin"
    ln -s /proc/self/fd/1 "$root/dev/stdout"
    ln -s /proc/self/fd/2 "$root/dev/stderr"
    mkdir "$root/dev/shm" "$root/dev/pts"
    mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts"
    ln -s pts/ptmx "$root/dev/ptmx"

    inside "$root" run ./run --demo || fail "./run --demo failed ($logs/run.log)"
    for name in espalier fbx obj glb png; do
        [[ -s "$root/root/espalier/first-tree.$name" ]] || fail "./run --demo did not write first-tree.$name"
    done
    inside "$root" test ./test || fail "./test failed ($logs/test.log)"
    count_tests "$root/root/espalier"
    awk -v most="$most_minutes" '{
        if (($2 + $3) / 120 > most) exit 1
        if ($1 / 60 > most) print "         more than " most " minutes on the clock: this machine had other work to do"
    }' "$logs/test.time" || fail "./test needs more than $most_minutes minutes"
    say "both commands of README.md work on a bare Debian 12"
}

if [[ "${1:-}" == --inside ]]; then
    run_all "$2"
    exit
fi

((EUID == 0)) || fail "only root can make a machine: sudo scripts/fresh-machine.sh"
scripts/setup.sh fresh
mkdir -p "$logs"
if (($# > 0)); then
    root="$(realpath -m "$1")"
    mkdir -p "$root"
    [[ -z "$(ls -A "$root")" ]] || fail "$root is not empty"
else
    root="$(mktemp -d -p "${TMPDIR:-/var/tmp}" fresh-machine.XXXXXX)"
    trap 'rm -rf --one-file-system "$root"' EXIT
fi
two_cores=()
if (($(nproc) > 2)); then
    two_cores=(taskset --cpu-list 0,1)
fi
"${two_cores[@]}" unshare --mount --pid --fork --kill-child --mount-proc "$0" --inside "$root"
