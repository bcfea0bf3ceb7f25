#!/usr/bin/env bash
# Builds limn with its tests and runs those that tell whether it works on this machine. Arguments go
# to ctest in place of that choice: `tests/run.sh -R volume` runs what has `volume` in its name, and
# `tests/run.sh --parallel 2` runs everything, as .ci/run does.
set -euo pipefail
cd "$(dirname "$0")/.."
source .ci/setup.sh
limn_install_missing "${limn_build_packages[@]}" "${limn_test_packages[@]}"

export NINJA_STATUS="[%f/%t, %es] " # one line on a terminal
cmake --preset tests >/dev/null
cmake --build --preset tests
if [ $# = 0 ]; then
    set -- --label-exclude 'second_driver|install'
fi
ctest --preset tests "$@"
