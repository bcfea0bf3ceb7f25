#!/usr/bin/env bash
# Draws the selection scene with every profile of this folder and puts the pictures on one sheet,
# each over its caption (Graphviz does). The first line of a profile is its caption, if it has a
# colon; a line "# also SETTINGS | CAPTION" asks for one more picture, with these arguments of --set.
#   samples/selection/contact_sheet.sh [OUT.png] [LIMN]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-out/techniques.png}
limn=${2:-build/release/editor_stub/limn}
columns=5
size=400x250

pictures=$(mktemp -d)
trap 'rm -rf "$pictures"' EXIT

cells=""
row=""
count=0
while IFS='|' read -r profile settings caption; do
    read -ra arguments <<<"${settings// / --set }"
    "$limn" render "$here/selection.scene.yaml" --profile "$profile" "${arguments[@]}" \
        --size $size --time 0.6 -q -o "$pictures/$count.png" </dev/null >/dev/null
    row+="<TD VALIGN=\"TOP\"><TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"2\">"
    row+="<TR><TD><IMG SRC=\"$count.png\"/></TD></TR>"
    # A caption wider than a picture would widen its column.
    caption=$(fold -s -w 48 <<<"${caption/: /$'\n'}" | sed 's|$|<BR/>|')
    row+="<TR><TD>$caption</TD></TR></TABLE></TD>"
    count=$((count + 1))
    if ((count % columns == 0)); then
        cells+="<TR>$row</TR>"
        row=""
    fi
done < <(for profile in "$here"/*.profile.yaml; do
    sed -n "1s/^# \(.*: .*\)/|\1/p; s/^# also\( [^|]*[^| ]\) *| */\1|/p" "$profile" |
        sed "s|^|$profile\||"
done)
[ -z "$row" ] || cells+="<TR>$row</TR>"

mkdir -p "$(dirname "$out")"
cd "$pictures" && dot -Tpng:cairo -o sheet.png <<DOT
digraph sheet {
    graph [dpi=96, pad=0.1, bgcolor="white", imagepath="$pictures"]
    node [shape=plain, fontname="DejaVu Sans", fontsize=12]
    sheet [label=<<TABLE BORDER="0" CELLBORDER="0" CELLSPACING="4">$cells</TABLE>>]
}
DOT
cd - >/dev/null && cp "$pictures/sheet.png" "$out"
echo "$out"
