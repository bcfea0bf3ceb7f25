#!/usr/bin/env bash
# Hands a sweep to Slurm: a task for each scene, size and shard, and behind them the job that merges
# their parts. A task that was killed, and a sweep that is handed over again, go on with what they
# have written.
#
#   sweep.sh -o OUT [--size WxH]... [--shards N] SCENE... [-- REPORT OPTION...]
#
# Into OUT: tasks.tsv, parts/NAME/I (a task's part), logs/I.log, reports/NAME. LIMN names the program
# if it is not in the PATH; everything must be in folders that all nodes see.
set -euo pipefail

fail() {
    echo "sweep.sh: $1" >&2
    exit "${2:-1}"
}

out='' shards=4 sizes=() scenes=() options=()
while (($# > 0)); do
    case $1 in
    -o | --size | --shards)
        (($# > 1)) || fail "$1 needs a value" 2
        case $1 in
        -o) out=$2 ;;
        --size) sizes+=("$2") ;;
        --shards) shards=$2 ;;
        esac
        shift
        ;;
    --)
        shift
        options=("$@")
        break
        ;;
    -*) fail "unknown option $1; options for \`limn report\` stand behind --" 2 ;;
    *) scenes+=("$1") ;;
    esac
    shift
done
[[ -n $out ]] || fail "no folder for the sweep; -o OUT" 2
((${#scenes[@]} > 0)) || fail "no scene" 2
[[ $shards =~ ^[1-9][0-9]{0,3}$ ]] || fail "--shards $shards: a number from 1 to 9999 is expected" 2
((${#sizes[@]} > 0)) || sizes=(1280x720)
for size in "${sizes[@]}"; do
    [[ $size =~ ^[1-9][0-9]*x[1-9][0-9]*$ ]] || fail "--size $size: such as 1280x720 is expected" 2
done
for scene in "${scenes[@]}"; do
    [[ -f $scene ]] || fail "there is no scene $scene"
    [[ $scene != *[$'\t\n']* ]] || fail "the name of the scene '$scene' has a tab or line break"
done
LIMN=$(command -v "${LIMN:-limn}") || fail "there is no limn in the PATH; LIMN=FILE names it" 3
LIMN=$(realpath "$LIMN")
export LIMN
command -v sbatch >/dev/null ||
    fail "there is no sbatch here: Slurm is missing. README.md says how to try it on one machine" 3

here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
mkdir -p "$out/logs"
out=$(realpath "$out")
declare -A known=()
for scene in "${scenes[@]}"; do
    for size in "${sizes[@]}"; do
        name=$(basename "$scene" .scene.yaml)_$size
        [[ -z ${known[$name]:-} ]] || fail "two scenes would be called $name"
        known[$name]=1
        for ((shard = 1; shard <= shards; ++shard)); do
            printf '%s\t%s\t%s\t%s\n' "$name" "$(realpath "$scene")" "$size" "$shard/$shards"
        done
    done
done >"$out/tasks.new"
((${#options[@]} == 0)) || printf '%s\n' "${options[@]}" >"$out/options.new"
touch "$out/options.new"
for kind in tasks options; do
    file=$out/$([[ $kind == tasks ]] && echo tasks.tsv || echo options.txt)
    [[ ! -f $file ]] || cmp --silent "$out/$kind.new" "$file" || {
        rm -f "$out"/*.new
        fail "$out holds another sweep, see its $(basename "$file"); choose another folder"
    }
done
mv "$out/tasks.new" "$out/tasks.tsv"
mv "$out/options.new" "$out/options.txt"

count=$(wc -l <"$out/tasks.tsv")
job=$(sbatch --parsable --array="1-$count" --output="$out/logs/%a.log" "$here/sweep.sbatch" "$out")
merge=$(sbatch --parsable --job-name=limn-merge --dependency="afterany:$job" \
    --output="$out/logs/merge.log" "$here/merge.sh" "$out")
echo "job $job: $count tasks, their logs in $out/logs; job $merge merges them into $out/reports"
