#!/usr/bin/env bash
# netcdfjs 4.0.0 (npm) reading a trajectory in the classic format of NetCDF, written by SciPy 1.10.1 (Debian 12: python3-scipy
# 1.10.1-2): three particles, two frames, positions in float and types in short or byte; type -1 marks a particle left out.
#
# Guess: rows of three types, as SciPy and the NetCDF library read them, or an exception.
# Seen: a fourth particle, whose type is the filling between rows, -32767 or 129: rows that do not end on four bytes are read to
# the end of the filling. And -1 in a byte, which NetCDF takes with a sign, is 255. Counts by type and means over particles are
# wrong, without a word. A file whose only variable has such rows is read rightly, as are even numbers of shorts and multiples
# of four of bytes. Write types as int.
#   short: types [[1,-1,2,-32767],[1,-1,2,-32767]], SciPy [[1, -1, 2], [1, -1, 2]]
#   byte: types [[1,255,2,129],[1,255,2,129]], SciPy [[1, -1, 2], [1, -1, 2]]
#   int: types [[1,-1,2],[1,-1,2]], SciPy [[1, -1, 2], [1, -1, 2]]
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
want=1.10.1-2
version=$(dpkg-query -W -f='${Version}' python3-scipy 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-scipy $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - > scipy_rows <<'PYTHON'
from scipy.io import netcdf_file

for name, kind in (("short", "h"), ("byte", "b"), ("int", "i")):
    with netcdf_file(name + ".nc", "w", version=2) as file:
        for dimension, length in (("frame", None), ("atom", 3), ("spatial", 3)):
            file.createDimension(dimension, length)
        types = file.createVariable("types", kind, ("frame", "atom"))
        positions = file.createVariable("coordinates", "f", ("frame", "atom", "spatial"))
        for frame in range(2):
            types[frame] = [1, -1, 2]
            positions[frame] = [[frame, i, 0] for i in range(3)]
    with netcdf_file(name + ".nc", mmap=False) as file:
        print(file.variables["types"][:].tolist())
PYTHON
npm install --silent --no-save --ignore-scripts --prefix . netcdfjs@4.0.0 >/dev/null
cat > read.mjs <<'NODE'
import fs from 'fs';
import { NetCDFReader } from 'netcdfjs';
const scipy = fs.readFileSync('scipy_rows', 'utf8').split('\n');
['short', 'byte', 'int'].forEach((name, i) => {
  const rows = new NetCDFReader(fs.readFileSync(name + '.nc')).getDataVariable('types');
  console.log(`${name}: types ${JSON.stringify(rows)}, SciPy ${scipy[i]}`);
});
NODE
node read.mjs > seen
cat seen
diff seen - <<'SEEN'
short: types [[1,-1,2,-32767],[1,-1,2,-32767]], SciPy [[1, -1, 2], [1, -1, 2]]
byte: types [[1,255,2,129],[1,255,2,129]], SciPy [[1, -1, 2], [1, -1, 2]]
int: types [[1,-1,2],[1,-1,2]], SciPy [[1, -1, 2], [1, -1, 2]]
SEEN
