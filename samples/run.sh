#!/usr/bin/env bash
# Builds limn and draws the furniture sample: out/furniture.png.
set -euo pipefail
cd "$(dirname "$0")/.."
source .ci/setup.sh
limn_install_missing "${limn_build_packages[@]}"

export NINJA_STATUS="[%f/%t, %es] " # one line on a terminal
cmake --preset release >/dev/null
cmake --build --preset release
mkdir -p out
build/release/editor_stub/limn render samples/furniture/furniture.scene.yaml -o out/furniture.png
