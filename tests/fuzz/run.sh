#!/usr/bin/env bash
# Builds every fuzz target with Clang, AddressSanitizer and UBSan and runs each for some time.
# Usage: tests/fuzz/run.sh SECONDS [BUILD_FOLDER]
# A finding fails the run; the input that shows it lies in BUILD_FOLDER/findings.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:?usage: tests/fuzz/run.sh SECONDS [BUILD_FOLDER]}
build=${2:-build/fuzz}
options=()
if [ $# -lt 2 ]; then
    options=(-DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1") # a folder of its own: quicker fuzzers
fi
cmake --preset asan -B "$build" "${options[@]}" >/dev/null
cmake --build "$build" --target fuzzers
mkdir -p "$build/findings"
fuzz() {
    local name=$1
    local corpus=$build/corpus/$name
    mkdir -p "$corpus"
    # The same inputs each time, as far as the time goes; LIMN_FUZZ_SEED=0 takes others.
    local options=(-seed="${LIMN_FUZZ_SEED:-1}" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=65536
        -artifact_prefix="$build/findings/" -verbosity=0 -print_final_stats=1)
    if [ -f "tests/fuzz/$name.dict" ]; then
        options+=(-dict="tests/fuzz/$name.dict")
    fi
    "$build/tests/${name}_fuzzer" "${options[@]}" "$corpus" "tests/fuzz/${name}_seeds" \
        >"$build/$name.log" 2>&1
}

# All at a time, a process each; what they print comes when they are done.
names=()
runs=()
for target in "$build"/tests/*_fuzzer; do
    names+=("$(basename "$target" _fuzzer)")
    fuzz "${names[-1]}" &
    runs+=($!)
done
failed=0
for i in "${!names[@]}"; do
    wait "${runs[i]}" || failed=1
    echo "== ${names[i]}, $seconds s"
    tail -n 20 "$build/${names[i]}.log"
done
exit "$failed"
