#!/usr/bin/env bash
# Runs the shell blocks of samples/guide/testing.md in an empty folder, and compares what they print
# with what the page says.
# Usage: guide.sh REPOSITORY LIMN_PROGRAM
set -euo pipefail
repository=$1
page=$repository/samples/guide/testing.md
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "testing.md: $1" >&2; exit 1; }

mkdir bin
ln -s "$2" bin/limn
ln -s "$repository/samples" "$repository/features" .
export PATH=$folder/bin:$PATH XDG_CACHE_HOME=$folder/cache VK_ICD_FILENAMES=/nonexistent

# blocks LANGUAGE: the fenced blocks of that language
blocks() { awk -v start="\`\`\`$1" '/^```/ { inside = !inside && $0 == start; next } inside' "$page"; }

blocks sh >commands.sh
[ "$(grep -c '^limn check' commands.sh)" = 6 ] || fail "there are not six commands"
bash -eu commands.sh >printed.txt || { cat printed.txt; fail "a command of the page fails"; }
blocks text >expected.txt
grep -qF "$(cat expected.txt)" printed.txt || fail "the quoted answer is not what limn prints"
[ "$(sed -n 1p printed.txt)" = "9 expectations, 0 failed" ] || fail "the first command says: $(sed -n 1p printed.txt)"
[ "$(tail -1 printed.txt)" = "8 expectations, 0 failed" ] || fail "the last command says: $(tail -1 printed.txt)"
[ "$(grep -c '<testcase ' results.xml)" = 8 ] || fail "results.xml has not eight test cases"
blocks yaml >all.yaml
limn check samples/furniture/furniture.scene.yaml all.yaml >printed.txt || { cat printed.txt; fail "the example of a file does not hold"; }
[ "$(wc -l <"$page")" -le 100 ] || fail "the page has more than 100 lines"
echo "testing.md: every block holds"
