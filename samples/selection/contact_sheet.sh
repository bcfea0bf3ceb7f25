#!/usr/bin/env bash
# Draws the selection scene with every profile of this folder and puts the pictures on one sheet,
# each over the first line of its profile (Graphviz does).
#   samples/selection/contact_sheet.sh [OUT.png] [LIMN]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-out/techniques.png}
limn=${2:-build/release/editor_stub/limn}
columns=4
size=400x250

# Picture, profile and, behind it, settings of the scene's features with the caption they need.
techniques=(
    "screen_space"
    "selection"
    "selection|Selection.m_Grouping=PerGroup|Selection kept apart: a stencil each, none melts"
    "mask_difference"
    "depth_normals"
    "color_edges"
    "rim"
    "inflated"
    "wide"
    "wide|Wide.m_Method=Separable --set WideOutline.m_Falloff=0 --set WideOutline.m_Gradient=0 --set WideOutline.m_OutlineWidth=3 --set WideOutline.m_Gap=3|Wide: a line with a gap"
    "strokes"
    "strokes|Strokes.m_Occlusion=SeeThrough|Strokes: what is hidden in its own colour"
)

pictures=$(mktemp -d)
trap 'rm -rf "$pictures"' EXIT

cells=""
row=""
count=0
for technique in "${techniques[@]}"; do
    IFS='|' read -r name settings caption <<<"$technique"
    profile=$here/$name.profile.yaml
    read -ra arguments <<<"${settings:+--set $settings}"
    "$limn" render "$here/selection.scene.yaml" --profile "$profile" "${arguments[@]}" \
        --size $size --time 0.6 -q -o "$pictures/$count.png" >/dev/null
    caption=${caption:-$(sed -n '1s/^# //p' "$profile")}
    row+="<TD><TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"2\">"
    row+="<TR><TD><IMG SRC=\"$count.png\"/></TD></TR>"
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
