#!/usr/bin/env bash
# netCDF4 1.6.2 of Python (Debian 12: python3-netcdf4 1.6.2-1+b1) reading an HDF5 file of h5py 3.7.0 (python3-h5py 3.7.0-8).
#
# Guess: what cannot be read is listed and an error where it is asked for, or there is a warning when the file is opened.
# Seen: datasets of bool and of complex numbers, tables (compound, even of a type that is in the file) and lists of variable
# length are not among the variables, without a word, and so for attributes of bool: as if they had never been written. And
# 2^32 - 1, which marks "no particle" in 32 bits, is masked where it is read, so means leave it out and comparisons with it find
# nothing; with set_auto_mask(False) it is there. Read files of h5py with h5py.
#   written: contact, flag, mode, neighbours, partner, radius; sheared, unit
#   read: partner, radius; unit
#   partner: [1, None, 0], unmasked [1, 4294967295, 0]
set -euo pipefail
for wanted in python3-netcdf4=1.6.2-1+b1 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${wanted%%=*}" 2>/dev/null || true)
  [ "$version" = "${wanted#*=}" ] || { echo "needs ${wanted%%=*} ${wanted#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import h5py
import netCDF4
import numpy

kind = numpy.dtype([("i", "i4"), ("overlap", "f8")])
with h5py.File("packing.h5", "w") as file:
    file["radius"] = [1.0, 2.0, 3.0]
    file["partner"] = numpy.array([1, 2**32 - 1, 0], "u4")
    file["flag"] = [True, False, True]
    file["mode"] = numpy.array([1 + 2j, 0, 0])
    file["kind"] = kind
    file.create_dataset("contact", data=numpy.array([(1, 0.5)], kind), dtype=file["kind"])
    file.create_dataset("neighbours", (1,), h5py.vlen_dtype("i4"))[0] = [1, 2]
    file.attrs["sheared"] = True
    file.attrs["unit"] = "d"
    names = sorted(name for name in file if isinstance(file[name], h5py.Dataset))
    print(f"written: {', '.join(names)}; {', '.join(file.attrs)}")
with netCDF4.Dataset("packing.h5") as file:
    print(f"read: {', '.join(sorted(file.variables))}; {', '.join(file.ncattrs())}")
    partner = file["partner"][:].tolist()
    file["partner"].set_auto_mask(False)
    print(f"partner: {partner}, unmasked {file['partner'][:].tolist()}")
PYTHON
cat messages seen
diff seen - <<'SEEN'
written: contact, flag, mode, neighbours, partner, radius; sheared, unit
read: partner, radius; unit
partner: [1, None, 0], unmasked [1, 4294967295, 0]
SEEN
