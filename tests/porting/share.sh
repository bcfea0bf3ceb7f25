#!/usr/bin/env bash
# The figures of samples/porting/README.md are what share.py prints, and no worse than they were.
# Usage: share.sh REPOSITORY
set -euo pipefail
cd "$1/samples/porting"
printed=$(python3 -B share.py)
quoted=$(sed -n '/share.py$/,/^    all /p' README.md | sed '1d; s/^    //')
[ "$printed" = "$quoted" ] || { printf 'README.md says\n%s\nshare.py says\n%s\n' "$quoted" "$printed" >&2; exit 1; }
awk '/^all/ { exit !($4 >= 85) }' <<<"$printed" || { echo "less than 85 % goes over" >&2; exit 1; }
