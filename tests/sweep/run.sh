#!/usr/bin/env bash
# The scripts of samples/sweep without Slurm and limn: programs of their names say what they were
# called with, and limn writes a cell at each call, killing itself at the first.
#
#   run.sh SOURCE_DIR
set -euo pipefail

scripts=$1/samples/sweep
scene=$1/samples/furniture/furniture.scene.yaml
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin"

fail() {
    echo "sweep: $1" >&2
    exit 1
}

# expect CODE TEXT COMMAND...: it ends with the code and says the text.
expect() {
    local wanted=$1 text=$2 code=0
    shift 2
    "$@" >"$folder/said" 2>&1 || code=$?
    [[ $code == "$wanted" ]] || fail "exit code $code instead of $wanted: $* says $(<"$folder/said")"
    grep -qF -- "$text" "$folder/said" || fail "'$text' is not in what $* says: $(<"$folder/said")"
}

for script in "$scripts"/*.sh "$scripts/sweep.sbatch"; do
    bash -n "$script"
done

sweep=$scripts/sweep.sh
export PATH=$folder/bin:/usr/bin:/bin
export LIMN=$folder/bin/limn
expect 2 "no folder for the sweep; -o OUT" "$sweep" "$scene"
expect 2 "no scene" "$sweep" -o "$folder/out"
expect 2 "--size needs a value" "$sweep" --size
expect 2 "--size 1280: such as 1280x720 is expected" "$sweep" -o "$folder/out" --size 1280 "$scene"
expect 2 "--shards 0: a number from 1 to 9999" "$sweep" -o "$folder/out" --shards 0 "$scene"
expect 2 "unknown option --quick" "$sweep" -o "$folder/out" --quick "$scene"
expect 1 "there is no scene nowhere.scene.yaml" "$sweep" -o "$folder/out" nowhere.scene.yaml
expect 3 "there is no limn in the PATH" "$sweep" -o "$folder/out" "$scene"

cat >"$folder/bin/limn" <<'LIMN'
#!/usr/bin/env bash
echo "limn $*"
if [[ $* == *--merge* ]]; then exit 0; fi
cell() { echo '{}' >>"$4/cells.jsonl"; }
cell "$@"
[[ $(wc -l <"$4/cells.jsonl") -gt 1 ]] || kill -9 $$
touch "$4/study.json"
LIMN
chmod +x "$folder/bin/limn"
if [[ ! -x /usr/bin/sbatch ]]; then
    expect 3 "there is no sbatch here: Slurm is missing" "$sweep" -o "$folder/out" "$scene"
fi
[[ ! -e $folder/out ]] || fail "what was refused left something behind"

printf '#!/bin/sh\necho "$@" >>%s/sbatch; echo 7\n' "$folder" >"$folder/bin/sbatch"
printf '#!/bin/sh\necho "$@" >>%s/scontrol\n' "$folder" >"$folder/bin/scontrol"
printf '#!/bin/sh\n' >"$folder/bin/sleep"
chmod +x "$folder"/bin/*
submit() { "$sweep" -o "$folder/out" --size 8x4 --size 16x8 --shards "$1" "$scene" -- --quick "a b"; }
expect 0 "job 7: 6 tasks" submit 3
grep -q -- "--array=1-6 .*sweep.sbatch $folder/out" "$folder/sbatch" || fail "$(<"$folder/sbatch")"
grep -q -- "--dependency=afterany:7 .*merge.sh $folder/out" "$folder/sbatch" || fail "no merging"
printf 'furniture_16x8\t%s\t16x8\t2/3\n' "$(realpath "$scene")" |
    cmp - <(sed -n 5p "$folder/out/tasks.tsv") || fail "task 5 is another one"
expect 0 "job 7" submit 3
expect 1 "holds another sweep, see its tasks.tsv" submit 2
[[ $(wc -l <"$folder/out/tasks.tsv") == 6 ]] || fail "a refused sweep changed the tasks"

# A killed limn comes back, and goes on with its cell.
export SLURM_ARRAY_TASK_ID=5 SLURM_ARRAY_JOB_ID=7
expect 137 "restart 0, 0 cells there" bash "$scripts/sweep.sbatch" "$folder/out"
grep -q "^requeue 7_5$" "$folder/scontrol" || fail "a killed task is not put into the queue"
export SLURM_RESTART_COUNT=1
expect 0 "restart 1, 1 cells there" bash "$scripts/sweep.sbatch" "$folder/out"
part=$folder/out/parts/furniture_16x8/2
expect 0 "limn report $(realpath "$scene") -o $part --size 16x8 --shard 2/3 --quick a b" \
    bash "$scripts/sweep.sbatch" "$folder/out"
rm "$part/cells.jsonl"
SLURM_RESTART_COUNT=3 expect 137 "exit code 137" bash "$scripts/sweep.sbatch" "$folder/out"
[[ $(wc -l <"$folder/scontrol") == 1 ]] || fail "a task is put into the queue without end"
SLURM_ARRAY_TASK_ID=9 expect 1 "has no line 9" bash "$scripts/sweep.sbatch" "$folder/out"

expect 1 "is no sweep, it has no tasks.tsv" "$scripts/merge.sh" "$folder"
expect 1 "no task of furniture_8x4 has written anything" "$scripts/merge.sh" "$folder/out"
expect 1 "limn report --merge $part -o $folder/out/reports/furniture_16x8" \
    "$scripts/merge.sh" "$folder/out"

expect 2 "usage: trial_cluster.sh start|stop DIR" "$scripts/trial_cluster.sh" begin "$folder"
expect 1 "has no cluster" "$scripts/trial_cluster.sh" stop "$folder"
echo "the scripts of a sweep do what they say"
