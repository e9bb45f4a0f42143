#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that every tracked source names its licence in the first line and has the layout of clang-format 14.
# Usage: scripts/check-format.sh [--fix]       (--fix corrects the layout, also of untracked sources)
# Fails if clang-format 14 is not installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

fix="${1:-}"
untracked=()
if [[ "$fix" == --fix ]]; then
    untracked=(--others --exclude-standard)
fi

list() {
    if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
        git ls-files --cached "${untracked[@]}" -- '*.cpp' '*.h'
    else
        find app commands model panels tests views \( -name '*.cpp' -o -name '*.h' \) -print
    fi
}
mapfile -t files < <(list | while IFS= read -r file; do [[ -f "$file" ]] && echo "$file"; done)
if ((${#files[@]} == 0)); then
    exit 0
fi

status=0
for file in "${files[@]}"; do
    IFS= read -r first <"$file" || true
    if [[ "$first" != "// SPDX-License-Identifier: GPL-3.0-or-later" ]]; then
        echo "$file:1: the first line should be // SPDX-License-Identifier: GPL-3.0-or-later" >&2
        status=1
    fi
done

program="$(command -v clang-format-14 || command -v clang-format || true)"
if [[ -z "$program" || "$("$program" --version)" != *"version 14."* ]]; then
    echo "format: clang-format 14 is not installed (scripts/setup.sh test installs it on Debian 12), so the layout was not checked" >&2
    exit 1
fi
if [[ "$fix" == --fix ]]; then
    "$program" -i "${files[@]}"
else
    wrong="$({ "$program" --dry-run -Werror "${files[@]}" 2>&1 || true; } |
        sed -n 's/^\([^:]*\):[0-9]*:[0-9]*: error: .*/\1/p' | sort -u)"
    if [[ -n "$wrong" ]]; then
        sed 's/$/: clang-format would change it (scripts\/check-format.sh --fix)/' <<<"$wrong" >&2
        status=1
    fi
fi
exit $status
