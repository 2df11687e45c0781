#!/usr/bin/env bash
# h5wasm 0.10.3 (npm) reading a dataset compressed with LZF, the fast filter of h5py (python3-h5py 3.7.0-8), which it does not
# have; jsfive 0.4.2 beside it.
#
# Guess: an exception, as from h5py or jsfive where a filter is missing.
# Seen: `value` returns an array of the right length with whatever was in memory: none of the numbers of the file, no exception.
# The HDF5 library's complaint goes to the console alone. gzip is read. Write gzip, or compare `dataset.filters` first.
#   gzip: h5wasm 64 of 64 right, jsfive 64 of 64 right
#   lzf:  h5wasm 0 of 64 right, jsfive NotImplementedError("Filter with id:32000 not supported")
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

with h5py.File("packed.h5", "w") as file:
    for name in ("gzip", "lzf"):
        file.create_dataset(name, data=numpy.full(64, 1.25), compression=name, chunks=(64,))
PYTHON
npm install --silent --no-save --ignore-scripts --prefix . jsfive@0.4.2 h5wasm@0.10.3 >/dev/null
cat > read.mjs <<'NODE'
import fs from 'fs';
import * as jsfive from 'jsfive';
import h5wasm from 'h5wasm/node';
await h5wasm.ready;
const bytes = fs.readFileSync('packed.h5');
const files = [['h5wasm', new h5wasm.File('packed.h5', 'r')],
               ['jsfive', new jsfive.File(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), 'packed.h5')]];
for (const name of ['gzip', 'lzf']) {
  const parts = files.map(([reader, file]) => {
    try {
      const values = Array.from(file.get(name).value);
      return `${reader} ${values.filter((x) => x === 1.25).length} of ${values.length} right`;
    } catch (error) {
      return `${reader} ${error.message || error}`;
    }
  });
  console.log(`${(name + ':').padEnd(5)} ${parts.join(', ')}`);
}
NODE
node read.mjs > seen 2>messages
cat seen
diff seen - <<'SEEN'
gzip: h5wasm 64 of 64 right, jsfive 64 of 64 right
lzf:  h5wasm 0 of 64 right, jsfive NotImplementedError("Filter with id:32000 not supported")
SEEN
