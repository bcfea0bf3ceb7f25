#!/usr/bin/env bash
# Fails if a prefix that limn was installed into lacks what people look for there.
# Usage: installed.sh PREFIX
set -euo pipefail
cd "$1"

missing=0
set -f # patterns are for compgen
for file in bin/limn include/limn/limn.h include/limn/core/Scene.h include/limn/features/Outline.h \
    include/limn/features/Version.h include/limn/vulkan/VulkanDevice.h \
    'lib*/cmake/limn/limnConfig.cmake lib/*/cmake/limn/limnConfig.cmake' \
    share/man/man1/limn.1 share/bash-completion/completions/limn \
    'share/zsh/site-functions/_limn share/zsh/vendor-completions/_limn' \
    share/fish/vendor_completions.d/limn.fish \
    share/doc/limn/copyright share/doc/limn/README.md share/doc/limn/CHANGELOG.md \
    share/limn/samples/furniture/furniture.scene.yaml share/limn/samples/guide/program/main.cpp \
    share/limn/samples/porting/CMakeLists.txt; do
    found=
    for pattern in $file; do
        found+=$(compgen -G "$pattern" || true)
    done
    if [ -z "$found" ]; then
        echo "installed.sh: '$file' was not installed" >&2
        missing=1
    fi
done
set +f
[ $missing = 0 ]

# The man page is one, and the shell takes its completions.
if command -v groff >/dev/null; then
    [ -z "$(groff -man -Tutf8 -ww -z share/man/man1/limn.1 2>&1)" ]
    groff -man -Tutf8 -P-cbou share/man/man1/limn.1 | grep -q '^LIMN(1)'
fi
bash -c 'source share/bash-completion/completions/limn; complete -p limn' | grep -q _limn
head -1 share/zsh/*/_limn | grep -q '#compdef limn'

# What is installed draws: a sample, out of the installed files.
picture=$(mktemp -d)
trap 'rm -rf "$picture"' EXIT
LIMN_DEVICE=software bin/limn render share/limn/samples/selection/selection.scene.yaml \
    --size 64x36 --no-cache -o "$picture/selection.png" -q
[ -s "$picture/selection.png" ]
