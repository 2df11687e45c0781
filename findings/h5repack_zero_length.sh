#!/usr/bin/env bash
# h5repack of HDF5 1.10.8 (Debian 12: hdf5-tools 1.10.8+repack1-1) compressing a file in which a table has no rows, as a list
# of contacts of a system that is not jammed (written by python3-h5py 3.7.0-8).
#
# Guess: `h5repack -f GZIP=1` leaves a dataset of no elements as it is, or gives it a filter that has nothing to do.
# Seen: "Error occurred while repacking" and exit status 1 where the dataset is contiguous, as h5py and others write it without
# further arguments. What is left behind is a valid HDF5 file that opens, with the datasets up to there: mind the status. A
# chunked one of no rows is no trouble, nor is repacking without a filter.
#   plain, contiguous:  status 0: a contacts z
#   GZIP=1, contiguous: status 1: a
#   GZIP=1, chunked:    status 0: a contacts z
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

for path, more in (("contiguous.h5", {}), ("chunked.h5", {"chunks": (64, 3), "maxshape": (None, 3)})):
    with h5py.File(path, "w") as file:
        file["a"] = numpy.arange(1000.0)
        file.create_dataset("contacts", data=numpy.zeros((0, 3)), **more)
        file["z"] = numpy.arange(1000.0)
PYTHON
repack() {  # label, input, options
  status=0
  h5repack "${@:3}" "$2" out.h5 >messages 2>&1 || status=$?
  echo "$1 status $status: $(/usr/bin/python3 -c 'import h5py; print(*h5py.File("out.h5", "r"))')"
  rm -f out.h5
}
{
  repack "plain, contiguous: " contiguous.h5
  repack "GZIP=1, contiguous:" contiguous.h5 -f GZIP=1
  repack "GZIP=1, chunked:   " chunked.h5 -f GZIP=1
} > seen
cat seen
diff seen - <<'SEEN'
plain, contiguous:  status 0: a contacts z
GZIP=1, contiguous: status 1: a
GZIP=1, chunked:    status 0: a contacts z
SEEN
