#!/usr/bin/env bash
# MDAnalysis 2.4.2, mdtraj 1.9.7, ASE 3.22.1 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1, python3-mdtraj 1.9.7-6,
# python3-ase 3.22.1-3+deb12u1) reading LAMMPS text dumps: scaled coordinates, which `dump atom` writes by default.
#
# Guess: "xs ys zs" and "x y z" of one instant give the same positions.
# Seen: in a cell from (-5, -4, -3) to (5, 4, 3) the atom at (-4, -3.5, 0) comes back as below. mdtraj takes fractions of the
# cell for lengths (in Angstrom, so divided by ten), where also distances are wrong. MDAnalysis moves the origin to 0 for
# "x y z", and for "xs ys zs" by the same again: apart by the origin. ASE keeps "x y z" where it was, and puts the origin of
# "xs ys zs" at 0. Write x y z (dump_modify scale no), and compare distances, not positions.
#   mdtraj     x [-0.4, -0.35, 0.0]   xs [0.01, 0.0063, 0.05]
#   MDAnalysis x [1.0, 0.5, 3.0]   xs [6.0, 4.5, 6.0]
#   ASE        x [-4.0, -3.5, 0.0]   xs [1.0, 0.5, 3.0]
set -euo pipefail
for pair in python3-mdanalysis=2.4.2+dfsg1-1+b1 python3-mdtraj=1.9.7-6 python3-ase=3.22.1-3+deb12u1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
dump() {  # columns, atom 1, atom 2
  printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n-5.0 5.0\n-4.0 4.0\n-3.0 3.0\n'
  printf 'ITEM: ATOMS id type %s\n1 1 %s\n2 1 %s\n' "$@"
}
dump "x y z" "-4.0 -3.5 0.0" "3.0 -3.0 0.0" > "$folder/x.lammpstrj"
dump "xs ys zs" "0.1 0.0625 0.5" "0.8 0.125 0.5" > "$folder/xs.lammpstrj"

/usr/bin/python3 -W ignore - "$folder" <<'PYTHON'
import sys
import ase.io
import MDAnalysis
import mdtraj

topology = mdtraj.Topology()
residue = topology.add_residue("disc", topology.add_chain())
for _ in range(2):
    topology.add_atom("A", None, residue)


def first(read):
    return [[round(float(x), 4) + 0.0 for x in read(f"{sys.argv[1]}/{kind}.lammpstrj")[0]] for kind in ("x", "xs")]


seen = {
    "mdtraj": first(lambda path: mdtraj.load(path, top=topology).xyz[0]),
    "MDAnalysis": first(lambda path: MDAnalysis.Universe(path, format="LAMMPSDUMP", topology_format="LAMMPSDUMP").atoms.positions),
    "ASE": first(lambda path: ase.io.read(path, format="lammps-dump-text").positions),
}
for reader, (x, xs) in seen.items():
    print(f"{reader:10} x {x}   xs {xs}")
sys.exit(0 if seen == {"mdtraj": [[-0.4, -0.35, 0.0], [0.01, 0.0063, 0.05]],
                       "MDAnalysis": [[1.0, 0.5, 3.0], [6.0, 4.5, 6.0]],
                       "ASE": [[-4.0, -3.5, 0.0], [1.0, 0.5, 3.0]]} else 1)
PYTHON
