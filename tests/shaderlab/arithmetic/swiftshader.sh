#!/bin/sh
# Runs the tests of HLSL's arithmetic and of generated HLSL on SwiftShader, which Chromium brings
# (package chromium-common, that chromium-headless-shell depends on). Takes the program with the
# tests.
for driver in /usr/lib/chromium /usr/lib/chromium-browser /opt/google/chrome; do
    description=$driver/vk_swiftshader_icd.json
    if [ -f "$description" ] && [ -f "$driver/libvk_swiftshader.so" ]; then
        export VK_DRIVER_FILES="$description" VK_ICD_FILENAMES="$description"
        export LIMN_TEST_DEVICE=swiftshader
        exec "$1" --gtest_filter='HlslArithmeticGpu.*:ArithmeticFormsGpu.*:HlslSnippetsGpu.*'
    fi
done
echo "there is no SwiftShader: apt install chromium-headless-shell"
[ "$LIMN_REQUIRE_DEVICE" = 1 ] && exit 1
exit 77
