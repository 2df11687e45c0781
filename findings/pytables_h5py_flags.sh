#!/usr/bin/env bash
# PyTables 3.7.0 (Debian 12: python3-tables 3.7.0-5) reading a file of h5py 3.7.0 (python3-h5py 3.7.0-8): a radius and a flag
# (bool) for each of four particles, the flag as a mask, radius[flag].
#
# Guess: the flag is read as bool, as h5py reads it; or there is a warning that the type is unknown.
# Seen: it is int8, and NumPy then takes it as numbers of particles, not as a mask: radius[flag] has four entries, those of the
# particles 0 and 1 over and over, and ~flag is -1 and -2, the last two particles. Flags that PyTables wrote are bool. A flag in
# the column of a table is int8 likewise, a flag as an attribute is None, with a warning. Add .astype(bool).
#   h5py: flag bool, radius[flag] [1.0, 3.0], radius[~flag] [2.0, 4.0]
#   PyTables: flag int8, radius[flag] [2.0, 1.0, 2.0, 1.0], radius[~flag] [3.0, 4.0, 3.0, 4.0]
#   PyTables: flag of a table int8, flag as an attribute None
set -euo pipefail
for wanted in python3-tables=3.7.0-5 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${wanted%%=*}" 2>/dev/null || true)
  [ "$version" = "${wanted#*=}" ] || { echo "needs ${wanted%%=*} ${wanted#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import h5py
import numpy
import tables

flags = numpy.array([True, False, True, False])
with h5py.File("particles.h5", "w") as file:
    file["radius"] = [1.0, 2.0, 3.0, 4.0]
    file["flag"] = flags
    file["table"] = numpy.array([(1.0, True)], dtype=[("radius", float), ("flag", bool)])
    file.attrs["sheared"] = True


def report(name, radius, flag):
    print(f"{name}: flag {flag.dtype}, radius[flag] {radius[flag].tolist()}, radius[~flag] {radius[~flag].tolist()}")


with h5py.File("particles.h5") as file:
    report("h5py", file["radius"][:], file["flag"][:])
with tables.open_file("particles.h5") as file:
    report("PyTables", file.root.radius[:], file.root.flag[:])
    column = file.root.table[:]["flag"]
    print(f"PyTables: flag of a table {column.dtype}, flag as an attribute {file.root._v_attrs['sheared']}")
PYTHON
cat seen
diff seen - <<'SEEN'
h5py: flag bool, radius[flag] [1.0, 3.0], radius[~flag] [2.0, 4.0]
PyTables: flag int8, radius[flag] [2.0, 1.0, 2.0, 1.0], radius[~flag] [3.0, 4.0, 3.0, 4.0]
PyTables: flag of a table int8, flag as an attribute None
SEEN
