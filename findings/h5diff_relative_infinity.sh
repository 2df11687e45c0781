#!/usr/bin/env bash
# h5diff -p of HDF5 1.10.8 (Debian 12: hdf5-tools 1.10.8+repack1-1): comparing two runs by a relative tolerance, one of which
# went to infinity (files by python3-h5py 3.7.0-8).
#
# Guess: an infinity equals an infinity of the same sign, and nothing else, in either order of the files.
# Seen: with -p an infinity in the first file equals every number in the second, 3 as well as the other infinity: the difference
# over the first value is not a number, and that is not more than the tolerance. A run that blew up passes against its reference
# if it is named first. The other order, -d and no option at all find it. nan is told from numbers each time.
#   inf against 3: -p status 0, -d status 1
#   3 against inf: -p status 1, -d status 1
#   inf against -inf: -p status 0, -d status 1
#   nan against 3: -p status 1, -d status 1
set -euo pipefail
for pair in hdf5-tools=1.10.8+repack1-1 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py

for name in ("3", "inf", "-inf", "nan"):
    with h5py.File(f"run{name}.h5", "w") as file:
        file["energy"] = [1.0, 2.0, float(name)]
PYTHON
status() { "$@" >/dev/null 2>&1 && echo 0 || echo $?; }
while read -r first second; do
  relative=$(status h5diff -p 1e-6 "run$first.h5" "run$second.h5")
  absolute=$(status h5diff -d 1e-6 "run$first.h5" "run$second.h5")
  echo "$first against $second: -p status $relative, -d status $absolute"
done > seen <<'CASES'
inf 3
3 inf
inf -inf
nan 3
CASES
cat seen
diff seen - <<'SEEN'
inf against 3: -p status 0, -d status 1
3 against inf: -p status 1, -d status 1
inf against -inf: -p status 0, -d status 1
nan against 3: -p status 1, -d status 1
SEEN
