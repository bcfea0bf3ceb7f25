#!/usr/bin/env bash
# The figures of samples/porting/README.md are what share.py prints, and no worse than they were.
# Usage: share.sh REPOSITORY
set -euo pipefail
cd "$1/samples/porting"
printed=$(python3 -B share.py)
quoted=$(sed -n '/share.py$/,/^    all /p' README.md | sed '1d; s/^    //')
[ "$printed" = "$quoted" ] || { printf 'README.md says\n%s\nshare.py says\n%s\n' "$quoted" "$printed" >&2; exit 1; }
awk '/^all/ { exit !($4 >= 90) }' <<<"$printed" || { echo "less than 90 % goes over" >&2; exit 1; }
# A file with each call of URP 14 once, however seldom a feature makes it.
each=../../tests/editor_stub/data/port/ToolboxFeature
share=$(python3 -B share.py $each.cs $each.h | sed -n 's/^all .* \([0-9.]*\) %.*/\1 %/p')
grep -qF "it is $share:" README.md || { echo "of ToolboxFeature.cs it is $share; README.md says otherwise" >&2; exit 1; }
