#!/usr/bin/env bash
# Merges what the tasks of a sweep have written: for each scene and size a report in OUT/reports. What
# is missing or there twice is said; exit code 1 if a report lacks a cell.
#
#   merge.sh OUT
set -uo pipefail

[[ $# -eq 1 ]] || {
    echo "usage: merge.sh OUT" >&2
    exit 2
}
out=$1
limn=$(command -v "${LIMN:-limn}") || {
    echo "merge.sh: there is no limn in the PATH; LIMN=FILE names it" >&2
    exit 3
}
[[ -f $out/tasks.tsv ]] || {
    echo "merge.sh: $out is no sweep, it has no tasks.tsv" >&2
    exit 1
}
worst=0
while read -r name; do
    shopt -s nullglob
    parts=("$out/parts/$name"/*/study.json)
    if ((${#parts[@]} == 0)); then
        echo "merge.sh: no task of $name has written anything" >&2
        worst=1
        continue
    fi
    rm -rf "$out/reports/$name" # no page of an earlier merge stays
    "$limn" report --merge "${parts[@]%/study.json}" -o "$out/reports/$name"
    code=$?
    ((code <= worst)) || worst=$code
done < <(cut -f 1 "$out/tasks.tsv" | sort -u)
exit "$worst"
