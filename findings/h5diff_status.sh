#!/usr/bin/env bash
# h5diff of HDF5 1.10.8 (Debian 12: hdf5-tools 1.10.8+repack1-1) comparing two results, as a test of reproducibility does (files by
# python3-h5py 3.7.0-8).
#
# Guess: the exit status is 1 where a dataset has another length, rank or type than in the other file.
# Seen: it is 0: "Some objects are not comparable", which is no difference; with -q nothing is printed either. A run that stopped
# early passes as equal to the whole one, a text as equal to numbers. A value that differs, and a dataset or an attribute that
# one file lacks, do give 1. Compare shapes and types first, or look for that line.
#   other value: status 1, -q says nothing
#   missing: status 1, -q says nothing
#   shorter: status 0, -q says nothing
#   other rank: status 0, -q says nothing
#   empty: status 0, -q says nothing
#   integers: status 0, -q says nothing
#   text: status 0, -q says nothing
set -euo pipefail
for pair in hdf5-tools=1.10.8+repack1-1 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py
import numpy

x = numpy.array([1.0, 2.0, 3.0])
others = {"other value": x + [0, 0, 1e-9], "missing": None, "shorter": x[:2], "other rank": x.reshape(1, 3), "empty": x[:0],
          "integers": x.astype("i8"), "text": numpy.array([b"a", b"b", b"c"])}
for path, value in {"first": x, **others}.items():
    with h5py.File(path + ".h5", "w") as file:
        file["time"] = [0.0, 1.0]
        if value is not None:
            file["energy"] = value
PYTHON
for other in "other value" missing shorter "other rank" empty integers text; do
  status=0
  h5diff first.h5 "$other.h5" > /dev/null 2>&1 || status=$?
  said=$(h5diff -q first.h5 "$other.h5" 2>&1 || true)
  echo "$other: status $status, -q says ${said:-nothing}"
done > seen
cat seen
diff seen - <<'SEEN'
other value: status 1, -q says nothing
missing: status 1, -q says nothing
shorter: status 0, -q says nothing
other rank: status 0, -q says nothing
empty: status 0, -q says nothing
integers: status 0, -q says nothing
text: status 0, -q says nothing
SEEN
