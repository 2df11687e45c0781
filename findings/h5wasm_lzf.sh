#!/usr/bin/env bash
# h5wasm 0.10.3 (npm), the HDF5 library in a browser or Node, reading a dataset that h5py compressed with LZF (Debian 12:
# python3-h5py 3.7.0-8).
#
# Guess: an exception, as the filter is not part of it; or the right numbers.
# Seen: no exception: `value` is an array of the right length of numbers that are not in the file, whatever was in memory
# before. The messages of the library go to the console, past the caller, and a page plots the numbers. Datasets of gzip,
# shuffle and scale-offset in the same file are right. Look at `filters` of each dataset before its value, or store gzip.
#   gzip: 1000 numbers, right, filters shuffle deflate
#   scaleoffset: 1000 numbers, right, filters scaleoffset
#   lzf: 1000 numbers, not those of the file, filters lzf
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
want=3.7.0-8
version=$(dpkg-query -W -f='${Version}' python3-h5py 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-h5py $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py
import numpy

steps = numpy.arange(1, 1001)
with h5py.File("run.h5", "w") as file:
    file.create_dataset("gzip", data=steps / 8, compression="gzip", shuffle=True)
    file.create_dataset("scaleoffset", data=steps, scaleoffset=0, chunks=(1000,))
    file.create_dataset("lzf", data=steps / 8, compression="lzf")
PYTHON
npm install --silent --no-save --ignore-scripts --prefix . h5wasm@0.10.3 >/dev/null
cat > read.mjs <<'NODE'
import h5wasm from 'h5wasm/node';
await h5wasm.ready;
const file = new h5wasm.File('run.h5', 'r');
for (const [name, unit] of [['gzip', 8], ['scaleoffset', 1], ['lzf', 8]]) {
  try {
    const set = file.get(name);
    const right = Array.from(set.value).every((value, i) => Number(value) * unit === i + 1);
    const filters = set.filters.map((filter) => filter.name).join(' ');
    console.log(`${name}: ${set.value.length} numbers, ${right ? 'right' : 'not those of the file'}, filters ${filters}`);
  } catch (error) {
    console.log(`${name}: ${error}`);
  }
}
NODE
node read.mjs > seen 2>messages
cat seen
diff seen - <<'SEEN'
gzip: 1000 numbers, right, filters shuffle deflate
scaleoffset: 1000 numbers, right, filters scaleoffset
lzf: 1000 numbers, not those of the file, filters lzf
SEEN
