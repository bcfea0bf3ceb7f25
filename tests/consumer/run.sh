#!/usr/bin/env bash
# Installs the build tree into an empty folder, then configures, builds and runs a project that finds
# it there. Usage: run.sh BUILD_TREE SOURCE_OF_THE_PROJECT CXX_COMPILER
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/prefix" >/dev/null
cmake -S "$2" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" \
    -DCMAKE_CXX_COMPILER="$3" >/dev/null
cmake --build "$folder/build" >/dev/null
"$folder/build/consumer"
"$folder/prefix/bin/limn" --version
