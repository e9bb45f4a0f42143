#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The long forms of the tests that ./test runs in a short form: faults of disk and memory, kills, random operations,
# fuzzers, and the tests with sanitizers. Takes some hours on two cores; the logs go to build/nightly.
# Usage: scripts/nightly.sh [faults] [kills] [soak] [fuzz] [sanitised] [threads] [tidy]     (all when nothing is named)
# FUZZ_SECONDS: for each target, 600 by default.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly logs="$PWD/build/nightly"
readonly fuzz_seconds="${FUZZ_SECONDS:-600}"
readonly targets=(project recipe drawing skeleton image changes operations)
failed=()
mkdir -p "$logs"

# run NAME command…: its output goes to a log; the last lines are shown.
run() {
    local name="$1"
    shift
    echo "$(date +%T) $name"
    if ! "$@" >"$logs/$name.log" 2>&1; then
        failed+=("$name")
    fi
    tail -n 2 "$logs/$name.log" | sed 's/^/         /'
}

fuzz() {
    local target="$1"
    local found="$logs/corpus/$target"
    mkdir -p "$found" "$logs/crashes"
    # A second for a small input, which the sanitizer makes several times slower.
    QT_QPA_PLATFORM=offscreen ASAN_OPTIONS=detect_leaks=0 "build/fuzz/bin/fuzz_$target" \
        -max_total_time="$fuzz_seconds" -timeout=5 -rss_limit_mb=2048 -malloc_limit_mb=512 -max_len=65536 \
        -artifact_prefix="$logs/crashes/$target-" -print_final_stats=1 -fork=0 -close_fd_mask=2 \
        "$found" "tests/fuzz/corpus/$target"
}

scripts/setup.sh build test nightly
for part in "${@:-all}"; do
    [[ "$part" == all ]] || [[ "$part" =~ ^(faults|kills|soak|fuzz|sanitised|threads|tidy)$ ]] || {
        echo "nightly: there is no part '$part'" >&2
        exit 1
    }
done
readonly parts=" ${*:-faults kills soak fuzz sanitised threads tidy} "
wanted() { [[ "$parts" == *" $1 "* ]]; }

scripts/build.sh release fault_test kill_test kill_victim soak
if wanted faults; then QT_QPA_PLATFORM=offscreen run faults build/release/bin/fault_test --all; fi
if wanted faults; then QT_QPA_PLATFORM=offscreen run deaths build/release/bin/fault_test --deaths --all; fi
if wanted kills; then run kills build/release/bin/kill_test --kills 300; fi
if wanted soak; then run soak build/release/bin/soak --operations 50000 --history 1; fi
if wanted fuzz; then
    scripts/build.sh fuzz
    for target in "${targets[@]}"; do run "fuzz-$target" fuzz "$target"; done
fi
if wanted sanitised; then run sanitised ./test --sanitised; fi
if wanted threads; then run threads ./test --threads; fi
if wanted tidy; then
    scripts/build.sh tidy
    run tidy run-clang-tidy -p build/tidy -quiet '/(app|commands|model|panels|views)/[^/]*\.cpp$'
fi

if ((${#failed[@]} > 0)); then
    echo "nightly: failed: ${failed[*]} (logs in $logs)" >&2
    exit 1
fi
