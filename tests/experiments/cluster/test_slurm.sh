#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: test_slurm.sh SPREAD PROGRAM. Starts a Slurm of two nodes on this machine, as the user who
# runs the test, submits an array, cancels one of its tasks, kills a process of another one, and
# compares the table with that of a sweep that was not spread. Exit code 77 where Slurm is missing.
set -euo pipefail
PATH=$PATH:/usr/sbin:/sbin
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null && continue
  echo "skipped: $program is missing (Debian: munge slurmctld slurmd slurm-client)"
  [[ -z ${CLIPSCOPE_REQUIRE_SLURM:-} ]] || exit 1
  exit 77
done
# shellcheck source=tests/experiments/cluster/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
spread=$1
set_sweep "$2"

show_logs() {
  tail -n 15 "$work"/*.log "$results"/log/*.txt >&2 || true
}
stop() {
  local status=$? pid
  [[ $status -eq 0 ]] || show_logs
  for pid in "$work"/*.pid; do
    [[ -s $pid ]] && kill "$(cat "$pid")" 2>/dev/null
  done
  sleep 0.5
  for pid in "$work"/*.pid; do
    [[ -s $pid ]] && kill -9 "$(cat "$pid")" 2>/dev/null
  done
  rm -rf "$work"
  exit "$status"
}
trap stop EXIT

# Three ports that nobody listens on.
port=$((20000 + $$ % 10000 * 4))
[[ $port -lt 60000 ]] || port=$((port - 20000))
export SLURM_CONF=$work/slurm.conf
user=$(id -un)
cat >"$SLURM_CONF" <<END
ClusterName=clipscope
SlurmctldHost=localhost
SlurmctldPort=$port
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool.%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SchedulerParameters=bf_interval=1,sched_interval=1,sched_min_interval=100000
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName=n[0-1] NodeHostname=localhost Port=[$((port + 1))-$((port + 2))] CPUs=1
PartitionName=main Nodes=ALL Default=YES
END
chmod 755 "$work"
mkdir "$work/state"
dd if=/dev/urandom of="$work/munge.key" bs=64 count=1 2>/dev/null
chmod 600 "$work/munge.key"
munged --force --socket="$work/munge.socket" --key-file="$work/munge.key" \
  --log-file="$work/munged.log" --pid-file="$work/munged.pid" --seed-file="$work/munge.seed"
slurmctld -f "$SLURM_CONF"
slurmd -N n0 -f "$SLURM_CONF"
slurmd -N n1 -f "$SLURM_CONF"
both_idle() { [[ $(sinfo --noheader --format=%D --states=idle) == 2 ]]; }
wait_for 30 "two idle nodes" both_idle

"$spread" slurm "$results" 6 "${mishaps[@]}"
array=$(squeue --noheader --array --name=clipscope --format=%F | head -1)
wait_for 60 "a running shard 0" test -e "$work/stands_still"
scancel "${array}_0"
wait_for 150 "the merged results" test -e "$results/whole/lattice_small.csv"
check_same_table
arrays=$(find "$results/log" -name '*_*.txt' ! -name 'merge_*' -printf '%f\n' | cut -d_ -f1 | sort -u)
[[ $(wc -l <<<"$arrays") -ge 2 ]] || fail "nothing was submitted again: $arrays"
echo "six shards by two nodes, one cancelled and one killed: the same table"
