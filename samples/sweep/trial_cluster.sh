#!/usr/bin/env bash
# A Slurm cluster of two nodes on this machine, to try a sweep on before it goes to a real one.
#
#   trial_cluster.sh start DIR    starts it; everything it writes is below DIR
#   trial_cluster.sh stop DIR     ends it; DIR stays, with its logs
#
# Packages: slurmctld slurmd slurm-client munge. Runs as whoever starts it, root or not. The clients
# find it by SLURM_CONF=DIR/slurm.conf.
set -euo pipefail

fail() {
    echo "trial_cluster.sh: $1" >&2
    exit "${2:-1}"
}

[[ $# -eq 2 && ($1 == start || $1 == stop) ]] || fail "usage: trial_cluster.sh start|stop DIR" 2
export PATH="$PATH:/usr/sbin"

# Ends what a pid file names, if it is still that program, and waits for it.
end() {
    local file=$1 program=$2 pid
    [[ -f $file ]] || return 0
    pid=$(<"$file")
    [[ $pid =~ ^[0-9]+$ && $(ps -o comm= -p "$pid" 2>/dev/null) == "$program"* ]] || return 0
    kill "$pid"
    for _ in {1..100}; do
        [[ -d /proc/$pid ]] || return 0
        sleep 0.1
    done
    fail "$program, process $pid, does not end"
}

stop() {
    export SLURM_CONF=$dir/slurm.conf
    scancel --quiet --user="$(id -un)" || true # where slurmctld is gone there is nobody to ask
    for _ in {1..50}; do
        [[ -n $(squeue --noheader 2>/dev/null) ]] || break
        sleep 0.2
    done
    end "$dir/slurmd.trial1.pid" slurmd
    end "$dir/slurmd.trial2.pid" slurmd
    end "$dir/slurmctld.pid" slurmctld
    end "$dir/munged.pid" munged
}

# Ports that nothing listens at, so that a trial stands beside a real cluster or another trial.
free_ports() {
    python3 - <<'PYTHON'
import socket
sockets = [socket.socket() for _ in range(3)]
for one in sockets:
    one.bind(("127.0.0.1", 0))
print(*(one.getsockname()[1] for one in sockets))
PYTHON
}

configure() {
    local host cpus ports
    host=$(hostname -s)
    cpus=$(($(nproc) > 1 ? $(nproc) / 2 : 1)) # a half for each node
    read -r -a ports < <(free_ports)
    cat >"$dir/slurm.conf" <<CONF
ClusterName=trial
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$dir/munge.socket
CredType=cred/munge
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool.%n
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.%n.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdLogFile=$dir/slurmd.%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
ReturnToService=2
JobRequeue=1
KillWait=2
SlurmdTimeout=30
NodeName=trial1 NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[1]} CPUs=$cpus State=UNKNOWN
NodeName=trial2 NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[2]} CPUs=$cpus State=UNKNOWN
PartitionName=main Nodes=trial1,trial2 Default=YES MaxTime=INFINITE State=UP
CONF
}

start() {
    for program in munged slurmctld slurmd sinfo python3; do
        command -v "$program" >/dev/null ||
            fail "there is no $program; apt-get install slurmctld slurmd slurm-client munge python3" 3
    done
    mkdir -p "$dir/state" "$dir/spool.trial1" "$dir/spool.trial2"
    [[ ! -S $dir/munge.socket ]] || fail "$dir has a cluster already; stop it first"
    (umask 077 && head -c 128 /dev/urandom >"$dir/munge.key")
    configure
    munged --force --key-file="$dir/munge.key" --socket="$dir/munge.socket" \
        --pid-file="$dir/munged.pid" --log-file="$dir/munged.log" --seed-file="$dir/munged.seed" \
        >"$dir/munged.out" 2>&1 || fail "munged does not start: $(tail -n 1 "$dir/munged.out")"
    export SLURM_CONF=$dir/slurm.conf
    slurmctld || fail "slurmctld does not start, see $dir/slurmctld.log"
    slurmd -N trial1 || fail "slurmd does not start, see $dir/slurmd.trial1.log"
    slurmd -N trial2 || fail "slurmd does not start, see $dir/slurmd.trial2.log"
    for _ in {1..60}; do
        if [[ $(sinfo --noheader --format=%D --states=idle 2>/dev/null) == 2 ]]; then
            echo "two nodes are idle: export SLURM_CONF=$dir/slurm.conf"
            return
        fi
        sleep 0.5
    done
    fail "the nodes do not come up, see $dir/slurmctld.log and $dir/slurmd.*.log"
}

if [[ $1 == start ]]; then
    mkdir -p "$2"
    dir=$(realpath "$2")
    trap 'code=$?; if ((code != 0 && code != 3)) && [[ -f $dir/slurm.conf ]]; then stop; fi' EXIT
    start
else
    [[ -f $2/slurm.conf ]] || fail "$2 has no cluster"
    dir=$(realpath "$2")
    stop
fi
