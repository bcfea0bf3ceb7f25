#!/usr/bin/env bash
# Builds limn with its tests and runs those that tell whether it works on this machine. `--all` adds
# what is left to .ci/run: a second driver, projects that use an installed limn, and the benchmarks.
# Other arguments go to ctest and choose among all tests: tests/run.sh -R volume
set -euo pipefail
cd "$(dirname "$0")/.."
source .ci/setup.sh
limn_install_missing "${limn_build_packages[@]}" "${limn_test_packages[@]}"

export NINJA_STATUS="[%f/%t, %es] " # one line on a terminal
benchmarks=OFF
if [ $# = 0 ]; then
    set -- --label-exclude 'second_driver|install'
elif [ "$1" = --all ]; then
    shift
    benchmarks=ON
fi
cmake --preset tests -DLIMN_BUILD_BENCHMARKS=$benchmarks >/dev/null
cmake --build --preset tests
ctest --preset tests "$@"
