#!/usr/bin/env bash
# Slurm 22.05.8 (Debian 12: slurm-wlm 22.05.8-4+deb12u3), without accounting: a shear run submitted with --dependency=afterok on
# a preparation that failed.
#
# Guess: it never starts, whenever it is submitted; or sbatch refuses a job it does not know.
# Seen: so it is while the controller remembers the failure. MinJobAge after the preparation ended (300 s unless set; 2 s here)
# it is forgotten, and then afterok counts as fulfilled: the run starts at once, and so does one submitted with afternotok, or
# after a number that no job ever had. sbatch says nothing. Submit a chain in one go, and have each step ask whether the result
# of the one before is there.
#   soon after: afterok PENDING (DependencyNeverSatisfied)
#   later: afterok ran, afternotok ran, afterok of a job that never was: ran
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
MinJobAge=2
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
wait_for() { for _ in $(seq 150); do ! eval "$1" 2>/dev/null || return 0; sleep 0.1; done; echo "waited in vain: $1"; exit 1; }
wait_for '[ "$(sinfo -h -o %T)" = idle ]'
run_after() { sbatch --parsable --dependency="$1" --output=/dev/null --wrap "touch $folder/$2"; }
preparation=$(sbatch --parsable --output=/dev/null --wrap 'exit 1')
wait_for "squeue -h -t FAILED -j $preparation | grep -q ."
soon=$(run_after "afterok:$preparation" soon)
wait_for "squeue -h -j $soon -o %r | grep -q Never"
echo "soon after: afterok $(squeue -h -j "$soon" -o '%T (%r)')" > seen
scancel "$soon"
wait_for "! scontrol show job $preparation >/dev/null"
run_after "afterok:$preparation" ok > numbers
run_after "afternotok:$preparation" notok >> numbers
run_after "afterok:123456" never >> numbers
wait_for '[ -e ok ] && [ -e notok ] && [ -e never ]'
echo "later: afterok ran, afternotok ran, afterok of a job that never was: ran" >> seen
cat seen
diff seen - <<'SEEN'
soon after: afterok PENDING (DependencyNeverSatisfied)
later: afterok ran, afternotok ran, afterok of a job that never was: ran
SEEN
