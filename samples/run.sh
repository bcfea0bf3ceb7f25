#!/usr/bin/env bash
# Builds limn and draws the furniture sample: out/furniture.png. The picture is there before the verbs
# that it does not need are built.
set -euo pipefail
cd "$(dirname "$0")/.."
source .ci/setup.sh
limn_install_missing "${limn_build_packages[@]}"

export NINJA_STATUS="[%f/%t, %es] " # one line on a terminal
cmake --preset release >/dev/null
cmake --build --preset release --target first_picture
mkdir -p out
build/release/editor_stub/first_picture samples/furniture/furniture.scene.yaml out/furniture.png
echo "picture: out/furniture.png; the rest of limn follows"
cmake --build --preset release
