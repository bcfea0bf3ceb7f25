#!/usr/bin/env bash
# A plug-in of somebody who installed limn: shown, drawn, broken on purpose, and built anew while
# `limn watch` looks on. Usage: plugin.sh LIMN FOLDER_OF_THE_FEATURE_PAINT (built in its build/)
set -euo pipefail
limn=$1
paint=$2
scene=$paint/Paint.scene.yaml
plugin=$paint/build/Paint.so
export LIMN_DEVICE=software XDG_CACHE_HOME=$paint/cache

fail() { echo "plugin.sh: $1" >&2; tail "$paint/out" "$paint/err" >&2; exit 1; }
# wait_for TEXT FILE: until the text is in the file, at most 60 s
wait_for()
{
    for _ in $(seq 600); do
        if grep -qF -- "$1" "$2"; then return; fi
        sleep 0.1
    done
    fail "there is no '$1' in $2"
}
# refused FILE.so TEXT [VARIABLE=VALUE]: drawing with it ends with 1 and says so
refused()
{
    local code=0
    env ${3-} "$limn" render "$scene" -o "$paint/no.png" --plugin "$1" >"$paint/out" 2>"$paint/err" || code=$?
    [ $code = 1 ] || fail "exit code $code, not 1"
    grep -qF -- "$1: error: $2" "$paint/err" || fail "'$2' is not said"
}

"$limn" inspect "$scene" --plugin "$plugin" >"$paint/inspected"
grep -q m_LayerMask "$paint/inspected"
grep -q m_Color "$paint/inspected"
"$limn" schema scene --plugin "$plugin" >"$paint/schema"
grep -q '"PaintRendererFeature"' "$paint/schema"
"$limn" schema profile --plugin "$plugin" >"$paint/schema"
grep -q '"Paint"' "$paint/schema"

version=$("$limn" --version | cut -d' ' -f2)
LC_ALL=C sed "s/${version//./\\.}/${version//[0-9]/9}/" "$plugin" >"$paint/other.so"
refused "$paint/other.so" "this plug-in cannot be used: it was built for limn ${version//[0-9]/9}, but this is limn $version;"
LC_ALL=C sed 's/_ZN4limn17FindShippedShaderE/_ZN4limn17FindShippedShadowE/g' "$plugin" >"$paint/missing.so"
refused "$paint/missing.so" "the file cannot be loaded: it uses limn::FindShippedShadow(std::basic_string_view<char, std::char_traits<char> >, std::shared_ptr<limn::ShaderCompiler> const&), which neither it nor limn has;"
head -c 20000 "$plugin" >"$paint/half.so"
refused "$paint/half.so" "the file cannot be loaded: the file ends too early, after 20000 bytes"

cp "$plugin" "$paint/first.so"
"$limn" watch "$scene" -o "$paint/watched.png" --plugin "$plugin" >"$paint/lines" 2>"$paint/errors" &
watch=$!
trap 'kill $watch 2>/dev/null || true' EXIT
wait_for "watched.png 64x32" "$paint/lines"
cmp "$paint/watched.png" "$paint.png"

# A shader of the plug-in's is in it: what is said of a change, and no picture.
echo '// a remark' >>"$paint/Paint.shader"
wait_for "Paint.shader is compiled into $plugin; the picture shows the change once the plug-in is built again" "$paint/errors"
[ "$(wc -l <"$paint/lines")" -eq 1 ] || fail "a picture was drawn of what did not change"

echo '#error stop' >>"$paint/PaintRendererFeature.cpp"
if cmake --build "$paint/build" >/dev/null 2>&1; then fail "what has an error was built"; fi
rm -f "$plugin" # as some builds leave it
wait_for "Paint.so: error: the file cannot be loaded: there is no such file" "$paint/errors"
cp "$paint/half.so" "$plugin"
wait_for "Paint.so: error: the file cannot be loaded: the file ends too early" "$paint/errors"
cmp "$paint/watched.png" "$paint.png"

# Another colour, and two ways to fail.
sed -i -e '/^#error/d' -e '1i #include <cstdlib>\n#include <stdexcept>\n#include <string>' \
    -e 's/component\.m_Color\.value()/Color(component.m_Color.value().g, 0.0f, 0.0f, 1.0f)/' \
    -e 's/^ *DrawingSettings drawingSettings =/        FailIf("Execute");\n&/' \
    -e 's/^ *m_Pass = std::make_unique/    FailIf("Create");\n&/' \
    -e 's/^class PaintPass final/static void FailIf(const std::string\& where)\n{\n    const char* fault = std::getenv("FAULT");\n    if (fault \&\& fault == where)\n    {\n        throw std::runtime_error("out of paint");\n    }\n}\n\n&/' \
    "$paint/PaintRendererFeature.cpp"
cmake --build "$paint/build" --target Paint >"$paint/out" || fail "the changed feature does not build"
for _ in $(seq 600); do
    if [ "$(wc -l <"$paint/lines")" -ge 2 ]; then break; fi
    sleep 0.1
done
"$limn" render "$scene" -o "$paint/second.png" --plugin "$plugin" >/dev/null
cmp "$paint/watched.png" "$paint/second.png"
if cmp -s "$paint/watched.png" "$paint.png"; then fail "the new code is not used"; fi
kill -INT $watch
wait $watch
# Of a slow linker more is seen than of a quick one, but nothing else.
if grep error: "$paint/errors" | grep -vE "there is no such file|ends too early|file too short|invalid ELF header" >&2; then exit 1; fi

refused "$plugin" "'PaintRendererFeature' threw in Create: out of paint" FAULT=Create
refused "$plugin" "'PaintRendererFeature' threw in Execute of pass 'Paint': out of paint" FAULT=Execute
