#!/usr/bin/env bash
# Draws the selection scene with every profile of this folder and puts the pictures on one sheet,
# each over the first line of its profile (Graphviz does).
#   samples/selection/contact_sheet.sh [OUT.png] [LIMN]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-out/techniques.png}
limn=${2:-$here/../../build/release/editor_stub/limn}
columns=4
size=400x250

techniques=(screen_space selection selection_apart mask_difference depth_normals depth_normals_hardened
    inflated rim color_edges wide strokes see_through)

pictures=$(mktemp -d)
trap 'rm -rf "$pictures"' EXIT

cells=""
row=""
count=0
for technique in "${techniques[@]}"; do
    profile=$here/$technique.profile.yaml
    "$limn" render "$here/selection.scene.yaml" --profile "$profile" --size $size --time 0.6 \
        -q -o "$pictures/$technique.png" >/dev/null
    caption=$(sed -n '1s/^# //p' "$profile")
    row+="<TD><TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"2\">"
    row+="<TR><TD><IMG SRC=\"$technique.png\"/></TD></TR>"
    row+="<TR><TD>${caption/: /<BR/>}</TD></TR></TABLE></TD>"
    count=$((count + 1))
    if ((count % columns == 0)); then
        cells+="<TR>$row</TR>"
        row=""
    fi
done
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
