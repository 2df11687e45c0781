#!/usr/bin/env bash
# hdf5r 1.3.8 of R (Debian 12: r-cran-hdf5r 1.3.8+dfsg-1) reading unsigned 64-bit integers, such as the seeds of runs or the state of
# a counter-based generator (written by python3-h5py 3.7.0-8).
#
# Guess: numbers from 2^63 on come as rounded doubles, as R has no such type, or are an error or NA.
# Seen: each of them is 9223372036854775807, exactly, without a word: all large seeds are the same. Signed ones and smaller ones
# are right to the last digit. Write seeds as text, or as two 32-bit numbers.
#   unsigned: 9223372036854775807 9223372036854775807 9223372036854775807 7
#   signed: 9007199254740993 -9223372036854775807
set -euo pipefail
for pair in r-cran-hdf5r=1.3.8+dfsg-1 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py
import numpy

with h5py.File("seeds.h5", "w") as file:
    file["unsigned"] = numpy.array([2**63, 2**63 + 5, 2**64 - 1, 7], dtype="u8")
    file["signed"] = numpy.array([2**53 + 1, -(2**63 - 1)], dtype="i8")
PYTHON
cat > read.R <<'R'
suppressMessages(library(hdf5r))
file <- H5File$new("seeds.h5", "r")
for (name in c("unsigned", "signed")) cat(paste0(name, ":"), as.character(file[[name]][]), "\n")
R
Rscript --vanilla read.R 2>messages | sed 's/ *$//' > seen
cat seen messages
diff seen - <<'SEEN'
unsigned: 9223372036854775807 9223372036854775807 9223372036854775807 7
signed: 9007199254740993 -9223372036854775807
SEEN
