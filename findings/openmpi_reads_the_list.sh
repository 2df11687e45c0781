#!/usr/bin/env bash
# Open MPI 4.1.4 (Debian 12: openmpi-bin 4.1.4-3+b1): a sweep over the lines of a file, `while read seed; do ...; done < list`,
# where each run is started by `mpirun -n 1`, one of a program that reads nothing.
#
# Guess: four seeds, four runs.
# Seen: one run. mpirun hands its own standard input to the first process whether that reads or not, and so takes the rest of
# the list; the loop ends, with status 0. A program started without mpirun leaves the list alone. With `-stdin none`, or
# `< /dev/null`, all four are run; in a job script the last three runs of a sweep are just not there.
#   without mpirun: seeds 1 2 3 4, status 0
#   mpirun: seeds 1, status 0
#   mpirun -stdin none: seeds 1 2 3 4, status 0
#   mpirun < /dev/null: seeds 1 2 3 4, status 0
set -euo pipefail
want=4.1.4-3+b1
version=$(dpkg-query -W -f='${Version}' openmpi-bin 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs openmpi-bin $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
printf '%s\n' 1 2 3 4 > list
cat > simulate <<'SH'
#!/bin/sh
echo "$1" >> done
sleep 1
SH
chmod +x simulate
sweep() {
  rm -f done
  local name=$1 status=0
  shift
  while read -r seed; do "$@" ./simulate "$seed"; done < list || status=$?
  echo "$name: seeds $(paste -sd ' ' done), status $status"
}
closed() { mpirun -n 1 "$@" < /dev/null; }
{
  sweep "without mpirun"
  sweep "mpirun" mpirun -n 1
  sweep "mpirun -stdin none" mpirun -stdin none -n 1
  sweep "mpirun < /dev/null" closed
} > seen
cat seen
diff seen - <<'SEEN'
without mpirun: seeds 1 2 3 4, status 0
mpirun: seeds 1, status 0
mpirun -stdin none: seeds 1 2 3 4, status 0
mpirun < /dev/null: seeds 1 2 3 4, status 0
SEEN
