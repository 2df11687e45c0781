#!/usr/bin/env bash
# Slurm 22.05.8 (Debian 12: slurm-wlm 22.05.8-4+deb12u3), without accounting: `sbatch --wait`, by whose exit status a script or a
# Makefile sees whether a job or all tasks of a sweep went well.
#
# Guess: 0 if all ran to their end with 0, as the manual has it: the highest exit code of any task, 1 after a signal.
# Seen: 0 as well where a job was cancelled before it began, that is, where nothing was run (1 if it was running). And 0 for a
# sweep with a task that failed, if that task ended longer than MinJobAge before the last one did (300 s unless set; 2 s in the
# last line): by then it is forgotten, and only the codes of those that are still known count. Have each task write a file when
# it is done, and count the files.
#   job cancelled while it ran: 1
#   job cancelled before it began: 0
#   array, first task fails with 3: 3
#   the same array, last task is long: 0
set -euo pipefail
want=22.05.8-4+deb12u3
for package in slurmctld slurmd slurm-client; do
  version=$(dpkg-query -W -f='${Version}' $package 2>/dev/null || true)
  [ "$version" = "$want" ] || { echo "needs $package $want, found '${version:-none}'"; exit 77; }
done
command -v munged >/dev/null && command -v mungekey >/dev/null || { echo "needs munge"; exit 77; }
[ "$(id -u)" = 0 ] || { echo "needs root for a Slurm of its own"; exit 77; }
folder=$(mktemp -d)
stop() {
  for daemon in slurmctld slurmd munged; do [ ! -s "$folder/$daemon.pid" ] || kill "$(cat "$folder/$daemon.pid")" || true; done
  for _ in $(seq 50); do ls "$folder"/*.pid >/dev/null 2>&1 || break; sleep 0.1; done
  rm -rf "$folder"
}
trap stop EXIT
cd "$folder"
mkdir state spool
mungekey --create --keyfile=key
munged --force --key-file="$folder/key" --socket="$folder/munge" --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" \
  --seed-file="$folder/seed" 2>messages
host=$(hostname -s)
read -r control daemon < <(/usr/bin/python3 -c '
import socket
sockets = [socket.socket() for _ in range(2)]
for each in sockets: each.bind(("127.0.0.1", 0))
print(*[each.getsockname()[1] for each in sockets])')
cat > slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$control
SlurmdPort=$daemon
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
MpiDefault=none
MinJobAge=300
SchedulerParameters=sched_interval=1
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
NodeName=$host NodeAddr=127.0.0.1 CPUs=1
PartitionName=main Nodes=$host Default=YES
CONF
export SLURM_CONF=$folder/slurm.conf
slurmctld
slurmd
wait_for() { for _ in $(seq 300); do ! eval "$1" 2>/dev/null || return 0; sleep 0.1; done; echo "waited in vain: $1"; exit 1; }
wait_for '[ "$(sinfo -h -o %T)" = idle ]'
wait_on() { code=0; sbatch --quiet --wait --output=/dev/null "${@:2}" 2>>messages || code=$?; echo "$1: $code"; }
wait_on "job cancelled while it ran" --wrap 'sleep 1; scancel $SLURM_JOB_ID; sleep 60' > ran &
wait_on "job cancelled before it began" --job-name=later --begin=now+3600 --wrap 'exit 3' > began &
wait_on "array, first task fails with 3" --array=0-1 --wrap '[ $SLURM_ARRAY_TASK_ID = 1 ] || exit 3' > short &
wait_for 'squeue -h -n later | grep -q .'
scancel --name=later
wait $(jobs -p)
sed -i s/MinJobAge=300/MinJobAge=2/ slurm.conf
scontrol reconfigure
wait_on "the same array, last task is long" --array=0-1 --wrap 'if [ $SLURM_ARRAY_TASK_ID = 0 ]; then exit 3; fi
  while scontrol show job ${SLURM_ARRAY_JOB_ID}_0; do sleep 0.5; done' > long
cat ran began short long > seen
cat seen
diff seen - <<'SEEN'
job cancelled while it ran: 1
job cancelled before it began: 0
array, first task fails with 3: 3
the same array, last task is long: 0
SEEN
