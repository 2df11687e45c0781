#!/usr/bin/env bash
# rhdf5 2.42.0 of R (Debian 12: r-bioc-rhdf5 2.42.0+dfsg-1) reading a file of h5py 3.7.0 (python3-h5py 3.7.0-8): a radius and a
# flag (bool) for each of four particles, the flag as a mask; hdf5r 1.3.8 (r-cran-hdf5r 1.3.8+dfsg-1) beside it.
#
# Guess: flags are logical, as hdf5r reads them, or they cannot be an index.
# Seen: they are a factor, and an index by a factor takes its level numbers: radius[flag] is of the particles 2, 1, 2, 1, without
# a word, and as.numeric counts six flags that are set in place of two. In the column of a table it is the same. !flag gives a
# warning and NA, and a flag that is an attribute is NA, with a warning. Numbers of one byte are "raw", whose mean is NA, with a
# warning. Write flag == "TRUE" or as.logical(flag).
#   rhdf5: flag factor, radius[flag] 2 1 2 1, set 6; as.logical: radius[flag] 1 3, set 2
#   hdf5r: flag logical, radius[flag] 1 3, set 2
#   rhdf5: flag of a table factor, numbers of one byte raw
set -euo pipefail
for wanted in r-bioc-rhdf5=2.42.0+dfsg-1 r-cran-hdf5r=1.3.8+dfsg-1 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${wanted%%=*}" 2>/dev/null || true)
  [ "$version" = "${wanted#*=}" ] || { echo "needs ${wanted%%=*} ${wanted#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py
import numpy

with h5py.File("particles.h5", "w") as file:
    file["radius"] = [1.0, 2.0, 3.0, 4.0]
    file["flag"] = [True, False, True, False]
    file["kind"] = numpy.array([1, 2, 1, 2], "u1")
    file["table"] = numpy.array([(1.0, True)], dtype=[("radius", float), ("flag", bool)])
PYTHON
cat > flags.R <<'R'
suppressMessages(library(hdf5r))
read <- function(name) rhdf5::h5read("particles.h5", name)
radius <- as.numeric(read("radius"))
words <- function(flag) sprintf("radius[flag] %s, set %g", paste(radius[flag], collapse = " "), sum(as.numeric(flag)))
flag <- read("flag")
cat(sprintf("rhdf5: flag %s, %s; as.logical: %s\n", class(flag), words(flag), words(as.logical(flag))))
other <- H5File$new("particles.h5", "r")[["flag"]][]
cat(sprintf("hdf5r: flag %s, %s\n", class(other), words(other)))
cat(sprintf("rhdf5: flag of a table %s, numbers of one byte %s\n", class(read("table")$flag), typeof(read("kind"))))
R
Rscript --vanilla flags.R > seen 2>messages || { cat messages; exit 1; }
cat messages seen
diff seen - <<'SEEN'
rhdf5: flag factor, radius[flag] 2 1 2 1, set 6; as.logical: radius[flag] 1 3, set 2
hdf5r: flag logical, radius[flag] 1 3, set 2
rhdf5: flag of a table factor, numbers of one byte raw
SEEN
