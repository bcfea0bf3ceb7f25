#!/usr/bin/env bash
# Runs the shell blocks of README.md behind the first one (which is what CI itself runs) in an empty
# folder, and compares the quoted files and messages with what is really there.
# Usage: run.sh REPOSITORY LIMN_PROGRAM
set -euo pipefail
repository=$1
program=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# block LANGUAGE N: the N-th fenced block of that language
block() {
    awk -v language="$1" -v wanted="$2" '
        /^```/ { if (inside) { inside = 0 } else if ($0 == "```" language) { inside = ++n == wanted } ; next }
        inside' "$repository/README.md"
}
fail() { echo "README.md: $1" >&2; exit 1; }

mkdir -p build/release/editor_stub out # both are there once samples/run.sh has run
ln -s "$program" build/release/editor_stub/limn
ln -s "$repository/samples" "$repository/features" .
export XDG_CACHE_HOME=$folder/cache

[ "$(block sh 1 | awk 'NF { print $1 }' | tr '\n' ' ')" = "samples/run.sh tests/run.sh " ] ||
    fail "the first two commands are not samples/run.sh and tests/run.sh"

for number in 2 3; do
    block sh $number >block.sh
    [ -s block.sh ] || fail "there is no shell block $number"
    cat block.sh >>commands.sh
done
bash -euO expand_aliases commands.sh || fail "a command of the shell blocks fails"
for file in out/a.png out/b.png out/c.png out/d.png out/e.png out/f.png out/g.png out/techniques.png out/report/report.html; do
    [ -s "$file" ] || fail "$file was not made"
done

while read -r line; do
    grep -qxF -- "$line" <(sed 's/^ *//' "$repository/samples/furniture/can_place.profile.yaml") ||
        fail "'$line' is not in can_place.profile.yaml"
done < <(block yaml 1)

# The messages: what makes each of them stands in the text around.
block text 1 >expected.txt
printf 'ScreenSpaceOutline:\n  m_Enable: true\n  outlneWidth: 4\n' >hero.profile.yaml
scene=samples/furniture/furniture.scene.yaml
{
    "$program" render "$scene" -o d.png --profile hero.profile.yaml && fail "a typo was accepted"
    "$program" render "$scene" -o d.png --set 'Screen Space Outline.m_LayerMask=Nothing'
} 2>actual.txt >/dev/null || true
diff expected.txt actual.txt || fail "the quoted messages are not what limn prints"
echo "README.md: every block holds"
