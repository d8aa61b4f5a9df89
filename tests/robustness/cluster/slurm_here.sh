#!/usr/bin/env bash
# A Slurm of three nodes on this host, for tests: everything lies in a folder of its own.
#
#   slurm_here.sh start FOLDER         prints a line and exits with 77 where it cannot be started
#   slurm_here.sh kill FOLDER NODE     the node with all its children, as if its power were cut
#   slurm_here.sh revive FOLDER NODE
#   slurm_here.sh stop FOLDER
#
# Programs of Slurm find it by SLURM_CONF=FOLDER/slurm.conf.
set -uo pipefail
command=$1 R=$2 node=${3:-}
export SLURM_CONF=$R/slurm.conf

cannot() { echo "no Slurm for this test: $1"; exit 77; }

node_up() {
    # A session of its own: what it starts can be found again, and ended, by it.
    setsid slurmd -D -N "$1" >>"$R/log/slurmd.$1.out" 2>&1 &
    echo $! >"$R/pid/$1"
}

descendants() {
    local pid
    for pid in $(pgrep -P "$1"); do echo "$pid"; descendants "$pid"; done
}

# The processes of a node: slurmd, and of each of its jobs the script, what stands above it and all below.
node_processes() {
    local pid
    cat "$R/pid/$1"
    for pid in $(pgrep -f "^/bin/bash $R/spool/$1/"); do
        ps -o ppid= -p "$pid" && echo "$pid" && descendants "$pid"
    done
}

case $command in
    start)
        [ "$(id -u)" = 0 ] || cannot "only root can start its daemons"
        for program in munged slurmctld slurmd sbatch squeue; do
            command -v "$program" >/dev/null || cannot "$program is not installed"
        done
        mkdir -p "$R"/{log,pid,state} "$R"/spool/node{1,2,3} "$R"/tmp/node{1,2,3}
        chmod 755 "$R"
        dd if=/dev/urandom of="$R/munge.key" bs=1 count=1024 2>/dev/null
        chmod 400 "$R/munge.key"
        munged --force --socket="$R/munge.socket" --key-file="$R/munge.key" --pid-file="$R/munge.pid" \
            --log-file="$R/log/munged.log" --seed-file="$R/munge.seed" >"$R/log/munged.out" 2>&1 ||
            cannot "munged does not start: $(tail -1 "$R/log/munged.out")"
        host=$(hostname -s) port=$((20000 + $$ % 20000))
        cat >"$SLURM_CONF" <<END
ClusterName=here
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$R/munge.socket,cred_expire=5
StateSaveLocation=$R/state
SlurmctldPidFile=$R/pid/slurmctld.pid
SlurmctldLogFile=$R/log/slurmctld.log
SlurmdSpoolDir=$R/spool/%n
SlurmdPidFile=$R/pid/slurmd.%n.pid
SlurmdLogFile=$R/log/slurmd.%n.log
TmpFS=$R/tmp/%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,bf_interval=1,defer_batch,batch_sched_delay=1
MpiDefault=none
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=5
InactiveLimit=0
KillWait=2
JobRequeue=1
MailProg=/bin/true
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
NodeName=node[1-3] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + 3))] CPUs=1 RealMemory=2000
PartitionName=main Nodes=node[1-3] Default=YES PriorityTier=1 MaxTime=INFINITE
PartitionName=urgent Nodes=node[1-3] PriorityTier=10 PreemptMode=OFF
END
        setsid slurmctld -D -c >"$R/log/slurmctld.out" 2>&1 &
        echo $! >"$R/pid/slurmctld"
        for n in node1 node2 node3; do node_up $n; done
        for _ in $(seq 100); do
            [ "$(sinfo -h -p main -t idle -o %D 2>/dev/null)" = 3 ] && exit 0
            sleep 0.2
        done
        cannot "its nodes do not register: $(tail -1 "$R/log/slurmctld.log")" ;;
    kill)
        mapfile -t processes < <(node_processes "$node")
        kill -9 "${processes[@]// /}" 2>/dev/null ;;
    revive) node_up "$node" ;;
    stop)
        for n in node1 node2 node3; do "$0" kill "$R" $n; done
        for file in "$R/pid/slurmctld" "$R/munge.pid"; do kill -9 "$(cat "$file")" 2>/dev/null; done
        rm -rf "$R" ;;
esac
exit 0
