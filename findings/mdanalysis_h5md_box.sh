#!/usr/bin/env bash
# MDAnalysis 2.4.2 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1) reading H5MD files (written by python3-h5py 3.7.0-8) with the
# three kinds of box edges that H5MD 1.1 has: a vector of lengths or a matrix, fixed or for every step.
#
# Guess: the rectangular cell (10, 8, 6) is read from each of them.
# Seen: only from matrices for every step. Lengths for every step are read as no cell at all, without a word, so that distances
# are no longer taken across the boundary (11.40 for 1.41). Edges that are fixed in time are a KeyError, "message type not
# found". Write matrices, for every step.
#   matrix, every step: cell [10.0, 8.0, 6.0, 90.0, 90.0, 90.0], distance 1.41
#   lengths, every step: cell None, distance 11.40
#   matrix, fixed: KeyError
#   lengths, fixed: KeyError
set -euo pipefail
for pair in python3-mdanalysis=2.4.2+dfsg1-1+b1 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import h5py
import MDAnalysis
import numpy
from MDAnalysis.lib.distances import distance_array

lengths = numpy.array([10.0, 8.0, 6.0])


def each_step(group, name, value):
    element = group.create_group(name)
    element["step"] = [0, 10]
    element["time"] = [0.0, 1.0]
    element["value"] = numpy.array([value, value])


for when in ("every step", "fixed"):
    for kind, edges in (("matrix", numpy.diag(lengths)), ("lengths", lengths)):
        path = f"{kind} {when}.h5md"
        with h5py.File(path, "w") as file:
            file.create_group("h5md").attrs["version"] = [1, 1]
            for name in ("author", "creator"):
                file.create_group("h5md/" + name).attrs["name"] = "someone"
            file["h5md/creator"].attrs["version"] = "1"
            particles = file.create_group("particles/all")
            box = particles.create_group("box")
            box.attrs["dimension"] = 3
            box.attrs["boundary"] = numpy.array([b"periodic"] * 3)
            each_step(particles, "position", [[0.5, 0.5, 0.0], [9.5, 7.5, 0.0]])
            if when == "fixed":
                box["edges"] = edges
            else:
                each_step(box, "edges", edges)
        try:
            universe = MDAnalysis.Universe.empty(2, trajectory=False)
            universe.load_new(path, convert_units=False)
            cell = universe.dimensions
            first, second = universe.atoms.positions
            distance = distance_array(first, second, box=cell)[0, 0]
            print(f"{kind}, {when}: cell {None if cell is None else cell.tolist()}, distance {distance:.2f}")
        except Exception as error:
            print(f"{kind}, {when}: {type(error).__name__}")
PYTHON
cat seen
diff seen - <<'SEEN'
matrix, every step: cell [10.0, 8.0, 6.0, 90.0, 90.0, 90.0], distance 1.41
lengths, every step: cell None, distance 11.40
matrix, fixed: KeyError
lengths, fixed: KeyError
SEEN
