#!/usr/bin/env bash
# h5repack of HDF5 1.10.8 (Debian 12: hdf5-tools 1.10.8+repack1-1) compressing a file in which one dataset has the filter LZF of
# h5py (python3-h5py 3.7.0-8), which these tools do not have.
#
# Guess: the dataset is copied as it is, as without an option, or the program fails.
# Seen: status 0, a warning, and the new file lacks the dataset. A script that compresses results and puts them in place of the
# old ones loses it. Compare the lists of datasets before the old file goes, or set HDF5_PLUGIN_PATH to where the filter is.
#   no option: status 0, says nothing; holds energy position
#   -f GZIP=4: status 0, says Warning: dataset </position> cannot be read, user defined filter is not available; holds energy
set -euo pipefail
for pair in hdf5-tools=1.10.8+repack1-1 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
export HDF5_PLUGIN_PATH="$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py
import numpy

with h5py.File("run.h5", "w") as file:
    file["energy"] = numpy.arange(1000.0)
    file.create_dataset("position", data=numpy.arange(1000.0), compression="lzf")
PYTHON
for option in "" "-f GZIP=4"; do
  rm -f packed.h5
  status=0
  # shellcheck disable=SC2086
  said=$(h5repack $option run.h5 packed.h5 2>&1) || status=$?
  echo "${option:-no option}: status $status, says ${said:-nothing}; holds $(h5ls packed.h5 | awk '{print $1}' | paste -sd' ')"
done > seen
cat seen
diff seen - <<'SEEN'
no option: status 0, says nothing; holds energy position
-f GZIP=4: status 0, says Warning: dataset </position> cannot be read, user defined filter is not available; holds energy
SEEN
