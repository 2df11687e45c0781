#!/usr/bin/env bash
# HDF5 1.10.8 by h5py (Debian 12: python3-h5py 3.7.0-8): a thousand lists of a thousand zeros each, as corners of bodies or
# contacts of grains are kept, with gzip of the highest level.
#
# Guess: a few kilobytes, as for the same numbers in a plain dataset of two dimensions.
# Seen: eight megabytes, as without gzip: the filter works on the references to the lists, and the lists themselves lie
# elsewhere, not compressed. The dataset still says `compression: gzip`, and its storage size is that of the references. Short
# lists of six numbers take more than the numbers do. Store all lists in one plain dataset, and where each begins in another.
#   table, gzip: below 0.1 MB in the file
#   lists, gzip: above 8 MB in the file, compression gzip, storage size below 0.1 MB
#   10000 lists of six, gzip: 1.4 times their numbers
set -euo pipefail
want=3.7.0-8
version=$(dpkg-query -W -f='${Version}' python3-h5py 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-h5py $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - > seen <<'PYTHON'
import os

import h5py
import numpy


def lists(number, length):
    result = numpy.empty(number, object)
    for i in range(number):
        result[i] = numpy.zeros(length)
    return result


def stored(data, **options):
    with h5py.File("lists.h5", "w") as file:
        dataset = file.create_dataset("x", data=data, compression="gzip", compression_opts=9, **options)
        said = dataset.compression, dataset.id.get_storage_size()
    return os.path.getsize("lists.h5"), *said


def megabytes(size):
    return "above 8 MB" if size > 8e6 else "below 0.1 MB" if size < 1e5 else f"{size / 1e6:.1f} MB"


kind = h5py.vlen_dtype("f8")
print(f"table, gzip: {megabytes(stored(numpy.zeros((1000, 1000)))[0])} in the file")
size, compression, storage = stored(lists(1000, 1000), dtype=kind)
print(f"lists, gzip: {megabytes(size)} in the file, compression {compression}, storage size {megabytes(storage)}")
print(f"10000 lists of six, gzip: {stored(lists(10000, 6), dtype=kind)[0] / 480000:.1f} times their numbers")
PYTHON
cat seen
diff seen - <<'SEEN'
table, gzip: below 0.1 MB in the file
lists, gzip: above 8 MB in the file, compression gzip, storage size below 0.1 MB
10000 lists of six, gzip: 1.4 times their numbers
SEEN
