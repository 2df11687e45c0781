#!/usr/bin/env bash
# jsfive 0.4.2 (npm), h5wasm 0.10.3 beside it: parts of a dataset that were never written.
#
# Guess: a reader gives the fill value of the dataset there, as the HDF5 library does.
# Seen: jsfive gives undefined, which arithmetic turns into NaN and a plot into a gap; a dataset of which nothing was
# written is undefined throughout. h5wasm gives the fill value. Write every element, or read the fill value yourself.
#   chunked    jsfive [null,null,1,2,null,null] h5wasm [7,7,1,2,7,7]
#   contiguous jsfive [null,null,null]          h5wasm [7,7,7]
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
/usr/bin/python3 -c 'import h5py' 2>/dev/null || { echo "needs python3-h5py"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py
with h5py.File("sparse.h5", "w") as file:
    chunked = file.create_dataset("chunked", shape=(6,), dtype="f8", chunks=(2,), fillvalue=7.0)
    chunked[2:4] = [1, 2]
    file.create_dataset("contiguous", shape=(3,), dtype="f8", fillvalue=7.0)
PYTHON
npm install --silent --no-save --prefix . jsfive@0.4.2 h5wasm@0.10.3 >/dev/null
cat > read.mjs <<'NODE'
import fs from 'fs';
import * as jsfive from 'jsfive';
import h5wasm from 'h5wasm/node';
await h5wasm.ready;
const bytes = fs.readFileSync('sparse.h5');
const pure = new jsfive.File(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), 'sparse.h5');
const library = new h5wasm.File('sparse.h5', 'r');
const text = (file, name) => JSON.stringify(Array.from(file.get(name).value));
const seen = ['chunked', 'contiguous'].map((name) => [name, text(pure, name), text(library, name)]);
for (const [name, a, b] of seen) console.log(name, 'jsfive', a, 'h5wasm', b);
const expected = [['chunked', '[null,null,1,2,null,null]', '[7,7,1,2,7,7]'],
                  ['contiguous', '[null,null,null]', '[7,7,7]']];
process.exit(JSON.stringify(seen) === JSON.stringify(expected) ? 0 : 1);
NODE
node read.mjs
