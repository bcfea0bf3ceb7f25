#!/usr/bin/env bash
# Installs a build tree into an empty folder, then configures, builds and runs projects that find it
# there: samples/guide/program and core_only. Usage: run.sh BUILD_TREE THIS_FOLDER CXX_COMPILER
# static|shared (which libraries are to be in the build tree). With static libraries only these are
# built: what else is tried here differs in nothing then.
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

"$2/installed.sh" "$folder/prefix"

tests=$2
compiler=$3
# configure SOURCE BUILD OPTIONS...
configure()
{
    cmake -S "$1" -B "$2" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" --no-warn-unused-cli "${@:3}" "${needless[@]}"
}
# Who wants the core alone needs nothing of what lies above it.
above=()
for package in yaml-cpp Vulkan embree TIFF OpenEXR; do
    above+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
configure "$tests/core_only" "$folder/core_only" -DCMAKE_PREFIX_PATH="$folder/prefix" \
    "${above[@]}" >/dev/null
cmake --build "$folder/core_only" >/dev/null
"$folder/core_only/core_only"

# A component that limn does not have is named, with those that it has.
mkdir "$folder/unknown"
echo 'cmake_minimum_required(VERSION 3.24)
project(unknown LANGUAGES C CXX)
find_package(limn REQUIRED COMPONENTS core volumes)' > "$folder/unknown/CMakeLists.txt"
if configure "$folder/unknown" "$folder/unknown/build" -DCMAKE_PREFIX_PATH="$folder/prefix" \
    >"$folder/out" 2>&1; then
    echo "run.sh: a component that limn does not have was found" >&2
    exit 1
fi
tr -s '\n ' ' ' <"$folder/out" |
    grep -qF "limn has no component 'volumes'; its components are base, shaderlab, core, volume, features," ||
    { cat "$folder/out" >&2; exit 1; }

# The sample program, which has 20 lines, finds limn where it is installed and where it was built.
program=$tests/../../samples/guide/program
lines=$(sed -n '/^int main/,/^}/p' "$program/main.cpp" | grep -vcE '^ *(//.*)?$')
[ "$lines" -le 20 ] || { echo "run.sh: main of samples/guide/program has $lines lines" >&2; exit 1; }
draw() # FOLDER OPTION
{
    configure "$program" "$1" "$2" >/dev/null
    cmake --build "$1" >/dev/null
    (cd "$1" && LIMN_DEVICE=software XDG_CACHE_HOME=$folder/cache ./torus) 2>"$folder/notes"
    [ ! -s "$folder/notes" ] || { cat "$folder/notes" >&2; exit 1; }
    python3 "$tests/check_picture.py" "$1/torus.png" "$program/torus.png"
}
draw "$folder/program" "-DCMAKE_PREFIX_PATH=$folder/prefix"
draw "$folder/of_build" "-Dlimn_DIR=$1"
# Where nothing can be written it says so, and ends with 1.
mkdir "$folder/nowhere" "$folder/nowhere/torus.png"
code=0
(cd "$folder/nowhere" && LIMN_DEVICE=software XDG_CACHE_HOME=$folder/cache ../program/torus) \
    2>"$folder/notes" || code=$?
[ $code = 1 ] && grep -q '^error: torus.png: ' "$folder/notes" ||
    { echo "run.sh: exit code $code:" >&2; cat "$folder/notes" >&2; exit 1; }
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

# What `limn port` writes of C# builds without a warning. Two of the features draw a frame; the others
# ask for shaders and materials of their own, which are not here.
ported=$folder/ported
mkdir "$ported"
sed -n '/^```cs$/,/^```$/p' "$tests/../../samples/guide/porting.md" | sed '/^```/d' \
    > "$ported/TintFeature.cs"
echo 'cmake_minimum_required(VERSION 3.24)
project(ported LANGUAGES C CXX)
enable_testing()' > "$ported/CMakeLists.txt"
for csharp in "$tests"/../editor_stub/data/port/*.cs "$ported/TintFeature.cs" \
    "$tests"/../port_corpus/MaskGlowFeature.cs; do # with lines of a filter
    name=$(basename "$csharp" .cs)
    "$limn" port "$csharp" -o "$ported/$name" -q >/dev/null 2>&1
    echo "add_subdirectory($name)" >> "$ported/CMakeLists.txt"
done
cmake -S "$ported" -B "$ported/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" \
    -DCMAKE_CXX_COMPILER="$3" "${needless[@]}" \
    -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror" >/dev/null
cmake --build "$ported/build" >"$folder/out" || { cat "$folder/out" >&2; exit 1; }
ctest --test-dir "$ported/build" --output-on-failure -R '^(HeightFog|Tint)_' --no-tests=error
