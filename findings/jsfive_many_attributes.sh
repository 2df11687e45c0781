#!/usr/bin/env bash
# jsfive 0.4.2 (npm) reading attributes of files in the newer format of HDF5 (h5py with track_order=True, which keeps the order
# of parameters, or libver="latest"; python3-h5py 3.7.0-8); h5wasm 0.10.3 beside it.
#
# Guess: attributes are read however many there are, or there is an exception.
# Seen: up to eight are read; with a ninth, `attrs` is empty, without a word: HDF5 then moves all of them out of the header of
# the object. In the older format, h5py's default, any number is read.
#   default: 8 of 8, 9 of 9 (h5wasm 8, 9)
#   ordered: 8 of 8, 0 of 9 (h5wasm 8, 9)
#   latest: 8 of 8, 0 of 9 (h5wasm 8, 9)
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
want=3.7.0-8
version=$(dpkg-query -W -f='${Version}' python3-h5py 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-h5py $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py

for kind, libver, order in (("default", None, False), ("ordered", None, True), ("latest", "latest", False)):
    with h5py.File(kind + ".h5", "w", libver=libver) as file:
        for count in (8, 9):
            group = file.create_group(f"parameters{count}", track_order=order)
            for i in range(count):
                group.attrs[f"key{i}"] = 0.5 * i
PYTHON
npm install --silent --no-save --ignore-scripts --prefix . jsfive@0.4.2 h5wasm@0.10.3 >/dev/null
cat > read.mjs <<'NODE'
import fs from 'fs';
import * as jsfive from 'jsfive';
import h5wasm from 'h5wasm/node';
await h5wasm.ready;
for (const kind of ['default', 'ordered', 'latest']) {
  const bytes = fs.readFileSync(kind + '.h5');
  const pure = new jsfive.File(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), kind);
  const library = new h5wasm.File(kind + '.h5', 'r');
  const count = (file, n) => Object.keys(file.get('parameters' + n).attrs).length;
  console.log(`${kind}: ${count(pure, 8)} of 8, ${count(pure, 9)} of 9 (h5wasm ${count(library, 8)}, ${count(library, 9)})`);
}
NODE
node read.mjs > seen
cat seen
diff seen - <<'SEEN'
default: 8 of 8, 9 of 9 (h5wasm 8, 9)
ordered: 8 of 8, 0 of 9 (h5wasm 8, 9)
latest: 8 of 8, 0 of 9 (h5wasm 8, 9)
SEEN
