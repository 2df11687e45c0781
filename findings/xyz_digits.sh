#!/usr/bin/env bash
# ASE 3.22.1, MDAnalysis 2.4.2, mdtraj 1.9.7 (Debian 12: python3-ase 3.22.1-3+deb12u1, python3-mdanalysis 2.4.2+dfsg1-1+b1,
# python3-mdtraj 1.9.7-6) writing a packing of soft discs as text: how many digits are left of overlaps and forces.
#
# Guess: numbers are written so that reading gives them back, to single precision at least.
# Seen: a fixed number of decimals, in every column. Extended XYZ of ASE has eight: of an overlap of 1e-9 and a force of 3e-9
# nothing is left, while numbers in the comment line keep all their digits. XYZ of MDAnalysis has five, its LAMMPS data file
# six, XYZ and LAMMPS dump of mdtraj three (of Angstrom): there an overlap of 1e-4 of a diameter is gone. (ASE's plain XYZ
# takes fmt="%.17g"; MDAnalysis's takes precision=.) Scale lengths and forces up before, or write the files yourself.
#   ASE extxyz, force 3e-9: 0.00000000
#   ASE extxyz, pressure 1.23456789e-09 in the comment: 1.23456789e-09
#   overlap 1e-4: ASE extxyz 0.00010000, MDAnalysis xyz 0.00010, mdtraj xyz 0.000, mdtraj lammpstrj 0.000
#   overlap 1e-9: ASE extxyz 0.00000000, MDAnalysis xyz 0.00000, mdtraj xyz 0.000, mdtraj lammpstrj 0.000
set -euo pipefail
for pair in python3-ase=3.22.1-3+deb12u1 python3-mdanalysis=2.4.2+dfsg1-1+b1 python3-mdtraj=1.9.7-6; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import re

import ase
import ase.io
import MDAnalysis
import mdtraj
import numpy

topology = mdtraj.Topology()
residue = topology.add_residue("disc", topology.add_chain())
for _ in range(2):
    topology.add_atom("A", None, residue)


def rows(path, column):
    lines = [line.split() for line in open(path).read().rstrip().split("\n")[-2:]]
    return [line[column] for line in lines]


def overlap(path, column):
    left, right = rows(path, column)
    decimals = len(left.split(".")[1])
    return f"{float(left) + 1 - float(right):.{decimals}f}"


def pair(gap):
    return numpy.array([[2.0, 0, 0], [3.0 - gap, 0, 0]])


atoms = ase.Atoms("H2", positions=pair(1e-9), cell=[20, 20, 20], pbc=True)
atoms.new_array("push", numpy.array([[3e-9, 0, 0], [-3e-9, 0, 0]]))
atoms.info["pressure"] = 1.23456789e-9
ase.io.write("one.xyz", atoms, format="extxyz")
print("ASE extxyz, force 3e-9:", rows("one.xyz", 4)[0])
print("ASE extxyz, pressure 1.23456789e-09 in the comment:", re.search(r"pressure=(\S+)", open("one.xyz").read()).group(1))
for gap in ("1e-4", "1e-9"):
    positions = pair(float(gap))
    ase.io.write("ase.xyz", ase.Atoms("H2", positions=positions, cell=[20, 20, 20], pbc=True), format="extxyz")
    universe = MDAnalysis.Universe.empty(2, trajectory=True)
    universe.add_TopologyAttr("name", ["A", "A"])
    universe.atoms.positions = positions
    universe.atoms.write("mdanalysis.xyz")
    trajectory = mdtraj.Trajectory(positions[None] / 10, topology, unitcell_lengths=[[2, 2, 2]], unitcell_angles=[[90, 90, 90]])
    for kind in ("xyz", "lammpstrj"):
        trajectory.save("mdtraj." + kind)
    print(f"overlap {gap}: ASE extxyz {overlap('ase.xyz', 1)}, MDAnalysis xyz {overlap('mdanalysis.xyz', 1)}, "
          f"mdtraj xyz {overlap('mdtraj.xyz', 1)}, mdtraj lammpstrj {overlap('mdtraj.lammpstrj', 2)}")
PYTHON
cat seen
diff seen - <<'SEEN'
ASE extxyz, force 3e-9: 0.00000000
ASE extxyz, pressure 1.23456789e-09 in the comment: 1.23456789e-09
overlap 1e-4: ASE extxyz 0.00010000, MDAnalysis xyz 0.00010, mdtraj xyz 0.000, mdtraj lammpstrj 0.000
overlap 1e-9: ASE extxyz 0.00000000, MDAnalysis xyz 0.00000, mdtraj xyz 0.000, mdtraj lammpstrj 0.000
SEEN
