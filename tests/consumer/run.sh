#!/usr/bin/env bash
# Installs a build tree into an empty folder, then configures, builds and runs a project that finds
# it there. Usage: run.sh BUILD_TREE SOURCE_OF_THE_PROJECT CXX_COMPILER static|shared
# (which libraries are to be in the build tree). With static libraries only that project is built:
# what else is tried here differs in nothing then.
set -euo pipefail
folder=$1/installed
trap 'rm -rf "$folder"' EXIT
rm -rf "$folder"
mkdir "$folder"
if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$folder CCACHE_NOHASHDIR=1
fi
cmake --install "$1" --prefix "$folder/first" >/dev/null
mv "$folder/first" "$folder/prefix" # what is installed can be moved

extension=a
needless=()
if [ "$4" = shared ]; then
    extension=so
    # Who uses shared libraries needs nothing of what they are made of.
    for package in glslang SPIRV-Tools SPIRV-Tools-opt spirv_cross_core yaml-cpp TinyGLTF PNG Vulkan; do
        needless+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
    done
fi
for library in shaderlab core volume features vulkan editor_stub; do
    compgen -G "$folder/prefix/lib*/liblimn_$library.$extension" >/dev/null ||
        compgen -G "$folder/prefix/lib*/*/liblimn_$library.$extension" >/dev/null ||
        { echo "liblimn_$library.$extension was not installed" >&2; exit 1; }
done

cmake -S "$2" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" \
    -DCMAKE_CXX_COMPILER="$3" "${needless[@]}" >/dev/null
cmake --build "$folder/build" >/dev/null
"$folder/build/consumer"
"$folder/prefix/bin/limn" --version
[ "$4" = shared ] || exit 0

# A feature written by `limn new` is built by whoever has limn installed, and drawn by it.
limn=$folder/prefix/bin/limn
for style in urp14 unity6; do
    paint=$folder/$style
    "$limn" new feature Paint --style $style -o "$paint" -q >/dev/null
    cmake -S "$paint" -B "$paint/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" \
        -DCMAKE_CXX_COMPILER="$3" "${needless[@]}" \
        -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror" >/dev/null
    cmake --build "$paint/build" >/dev/null
    ctest --test-dir "$paint/build" --output-on-failure
    "$limn" render "$paint/Paint.scene.yaml" --plugin "$paint/build/Paint.so" \
        --device software --no-cache -o "$paint.png" >/dev/null
    python3 "$(dirname "$0")/check_picture.py" "$paint.png"
done
cmp "$folder/urp14.png" "$folder/unity6.png"
"$(dirname "$0")/plugin.sh" "$limn" "$folder/urp14"

# What `limn port` writes of C# builds without a warning and draws a frame.
ported=$folder/ported
mkdir "$ported"
echo 'cmake_minimum_required(VERSION 3.24)
project(ported LANGUAGES C CXX)
enable_testing()' > "$ported/CMakeLists.txt"
for csharp in "$(dirname "$0")"/../editor_stub/data/port/*.cs \
    "$(dirname "$0")"/../port_corpus/MaskGlowFeature.cs; do # with lines of a filter
    name=$(basename "$csharp" .cs)
    "$limn" port "$csharp" -o "$ported/$name" -q >/dev/null 2>&1
    echo "add_subdirectory($name)" >> "$ported/CMakeLists.txt"
done
cmake -S "$ported" -B "$ported/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" \
    -DCMAKE_CXX_COMPILER="$3" "${needless[@]}" \
    -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror" >/dev/null
cmake --build "$ported/build" >/dev/null
ctest --test-dir "$ported/build" --output-on-failure
