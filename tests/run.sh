#!/usr/bin/env bash
# Builds limn with its tests and runs all of them. Arguments go to ctest: tests/run.sh -R volume
set -euo pipefail
cd "$(dirname "$0")/.."
source .ci/setup.sh
limn_install_missing "${limn_build_packages[@]}" "${limn_test_packages[@]}"

export NINJA_STATUS="[%f/%t, %es] " # one line on a terminal
cmake --preset dev >/dev/null
cmake --build --preset dev
ctest --preset dev "$@"
