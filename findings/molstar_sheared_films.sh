#!/usr/bin/env bash
# Mol* 5.11.0 (npm: molstar) reading the cell of films of a sheared cell of strain 0.5, in DCD, NetCDF, XTC and TRR as mdtraj
# 1.9.7 (Debian 12: python3-mdtraj 1.9.7-6) wrote them.
#
# Guess: lengths of 10, 11.18 and 10, and angles of 90, 90 and 63.43 degrees in each; or none where a format is not understood.
# Seen: so from XTC and TRR. From DCD the first angle is 7e44 degrees, as it is read from the second byte of the length before
# it, and it would be in the wrong place if it were right; the angle of the shear is 90. From NetCDF all angles are 90, though
# the length of the leaning side is kept: the cell is upright and too large. No word of either. Upright cells are right. Convert
# films to XTC or TRR first.
#   dcd: lengths 10.00 11.18 10.00, angles 7.2e+44 90.00 90.00
#   nc: lengths 10.00 11.18 10.00, angles 90.00 90.00 90.00
#   xtc: lengths 10.00 11.18 10.00, angles 90.00 90.00 63.43
#   trr: lengths 10.00 11.18 10.00, angles 90.00 90.00 63.43
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
want=1.9.7-6
version=$(dpkg-query -W -f='${Version}' python3-mdtraj 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-mdtraj $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - >messages 2>&1 <<'PYTHON' || { cat messages; exit 1; }
import mdtraj
import numpy

particles = mdtraj.Topology()
chain = particles.add_chain()
for _ in range(2):
    particles.add_atom("A", mdtraj.element.argon, particles.add_residue("A", chain))
film = mdtraj.Trajectory(numpy.array([[[0, 0, 0], [0.1, 0.2, 0.3]]] * 2), particles)
film.unitcell_vectors = numpy.array([[[1, 0, 0], [0.5, 1, 0], [0, 0, 1.0]]] * 2)
for kind in ("dcd", "nc", "xtc", "trr"):
    film.save(f"film.{kind}")
PYTHON
npm install --silent --no-save --ignore-scripts --prefix . molstar@5.11.0 >/dev/null
cat > read.mjs <<'NODE'
import fs from 'fs';
const kinds = { dcd: ['dcd', 'Dcd'], nc: ['nctraj', 'Nctraj'], xtc: ['xtc', 'Xtc'], trr: ['trr', 'Trr'] };
for (const [kind, [folder, name]] of Object.entries(kinds)) {
  const parser = await import(`molstar/lib/mol-io/reader/${folder}/parser.js`);
  const format = await import(`molstar/lib/mol-model-formats/structure/${folder}.js`);
  const file = await parser[`parse${name}`](new Uint8Array(fs.readFileSync(`film.${kind}`))).run();
  const { size, anglesInRadians } = (await format[`coordinatesFrom${name}`](file.result).run()).frames[1].cell;
  const word = (x) => Math.abs(x) < 1000 ? x.toFixed(2) : x.toExponential(1);
  const degrees = Array.from(anglesInRadians, (angle) => word(angle * 180 / Math.PI));
  console.log(`${kind}: lengths ${Array.from(size, word).join(' ')}, angles ${degrees.join(' ')}`);
}
NODE
node read.mjs > seen
cat seen
diff seen - <<'SEEN'
dcd: lengths 10.00 11.18 10.00, angles 7.2e+44 90.00 90.00
nc: lengths 10.00 11.18 10.00, angles 90.00 90.00 90.00
xtc: lengths 10.00 11.18 10.00, angles 90.00 90.00 63.43
trr: lengths 10.00 11.18 10.00, angles 90.00 90.00 63.43
SEEN
