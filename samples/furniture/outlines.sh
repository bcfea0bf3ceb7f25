#!/usr/bin/env bash
# Draws the first picture of README.md: the selected sofa from nearby, on the left with the first
# article's technique (ScreenSpaceOutline), on the right with StrokeOutline, both 4 pixels wide.
#   samples/furniture/outlines.sh [OUT.png] [LIMN]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-out/outlines.png}
limn=${2:-build/release/editor_stub/limn}

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The furniture scene has the article's outline. Here it gets strokes, too, and another camera. They
# take every renderer of the rendering layer, so the sofa's contact shadow leaves it.
filter="m_LayerMask: [Furniture, Decoration], m_RenderingLayerMask: Selected"
sed -e "s/^  fieldOfView: .*/  fieldOfView: 11/" -e "s/^  lookAt: .*/  lookAt: [-0.55, 0.75, 1.3]/" \
    -e "s/^  features:/&\n    - {type: StrokeOutlineRendererFeature, name: Strokes, $filter}/" \
    -e "/name: Sofa/,/name: Shadow/s/name: Shadow/&\n        renderingLayerMask: Default/" \
    "$here/furniture.scene.yaml" >"$folder/near.scene.yaml"
cp "$here/can_place.profile.yaml" "$folder" # which the scene names
draw() # COMPONENT
{
    echo "$1: {m_Enable: true, m_OutlineColor: {r: 0.2, g: 1, b: 0.35}, m_OutlineWidth: 4}" \
        >"$folder/outline.profile.yaml"
    "$limn" render "$folder/near.scene.yaml" --profile "$folder/outline.profile.yaml" \
        --size 430x300 -q -o "$folder/$1.png" >/dev/null
}
draw ScreenSpaceOutline
draw StrokeOutline

# Graphviz puts both beside each other.
dot -Tpng:cairo -o "$folder/both.png" <<DOT
digraph both {
    graph [dpi=96, pad=0, margin=0, bgcolor="white", imagepath="$folder"]
    node [shape=plain]
    both [label=<<TABLE BORDER="0" CELLBORDER="0" CELLSPACING="0" CELLPADDING="0"><TR>
        <TD><IMG SRC="ScreenSpaceOutline.png"/></TD>
        <TD WIDTH="8" HEIGHT="8"></TD>
        <TD><IMG SRC="StrokeOutline.png"/></TD></TR></TABLE>>]
}
DOT
mkdir -p "$(dirname "$out")"
cp "$folder/both.png" "$out"
echo "$out"
