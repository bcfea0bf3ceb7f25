#!/usr/bin/env bash
# A folder that is added after the project was configured is found by the next build; one whose
# sources nobody registers is refused. Usage: added_later.sh SOURCE_OF_LIMN
set -euo pipefail
limn=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r "$limn/features" "$folder"
cat >"$folder/CMakeLists.txt" <<EOF
cmake_minimum_required(VERSION 3.24)
project(added_later LANGUAGES NONE)
include(features/FeatureFolders.cmake)
limn_feature_folders(\${CMAKE_CURRENT_SOURCE_DIR}/features RegisterFeatures)
file(WRITE \${CMAKE_CURRENT_BINARY_DIR}/found.txt "\${feature_folders} \${feature_sources} \${feature_shaders}")
EOF
cmake -S "$folder" -B "$folder/build" -G Ninja >/dev/null
grep -q "    RegisterRenderObjects(features, components);" "$folder/build/RegisterFeatures.cpp"
header=$folder/build/include/limn/features/AllFeatures.h
grep -qx "#include <limn/features/RenderObjects.h>" "$header"
! grep -qi glow "$folder/build/RegisterFeatures.cpp" "$folder/build/found.txt" "$header"

cp -r "$limn/tests/feature_folders/glow" "$folder/features"
cmake --build "$folder/build" >/dev/null
grep -q "    RegisterGlow(features, components);" "$folder/build/RegisterFeatures.cpp"
grep -qx "#include <limn/features/Glow.h>" "$header"
for found in "features/glow " features/glow/src/Glow.cpp glow/AnyFileName.shader; do
    grep -q "$found" "$folder/build/found.txt" || grep -q "${found% };" "$folder/build/found.txt"
done

rm "$folder/features/glow/src/Glow.cpp"
touch "$folder/features/glow/src/Other.cpp"
if cmake --build "$folder/build" >"$folder/log" 2>&1; then
    echo "a folder that registers nothing was accepted" >&2
    exit 1
fi
grep -q "features/glow/src: no source defines" "$folder/log"
