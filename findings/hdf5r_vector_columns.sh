#!/usr/bin/env bash
# hdf5r 1.3.8 of R (Debian 12: r-cran-hdf5r 1.3.8+dfsg-1) reading a table of particles whose column `position` holds two numbers
# a row (a compound type with an array in it, written by python3-h5py 3.7.0-8).
#
# Guess: a data frame with a matrix of three rows and two columns as its column, or one column for each component.
# Seen: a data frame of three rows whose column has six numbers: all x, then all y. A row shows x alone; rows taken by number
# drop y (sorted ones too), rows taken by a condition have more numbers than rows. No warning. matrix(d$position, ncol = 2) has
# both.
#   rows 3, position 1 3 5 2 4 6
#   row 2: id 2 position 3 radius 0.2
#   rows of radius above 0.15: position 3 5 4 6, row 2 and 3: 3 5
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

rows = [(1, (1, 2), 0.1), (2, (3, 4), 0.2), (3, (5, 6), 0.3)]
with h5py.File("particles.h5", "w") as file:
    file["particles"] = numpy.array(rows, dtype=[("id", "i4"), ("position", "f8", 2), ("radius", "f8")])
PYTHON
cat > read.R <<'R'
suppressMessages(library(hdf5r))
d <- H5File$new("particles.h5", "r")[["particles"]][]
cat(paste0("rows ", nrow(d), ", position"), d$position, "\n")
row <- d[2, ]
cat("row 2: id", row$id, "position", row$position, "radius", row$radius, "\n")
cat("rows of radius above 0.15: position", d[d$radius > 0.15, ]$position)
cat(", row 2 and 3:", d[2:3, ]$position, "\n")
R
Rscript --vanilla read.R 2>messages | sed 's/ *$//' > seen
cat seen messages
[ ! -s messages ]
diff seen - <<'SEEN'
rows 3, position 1 3 5 2 4 6
row 2: id 2 position 3 radius 0.2
rows of radius above 0.15: position 3 5 4 6, row 2 and 3: 3 5
SEEN
