#!/usr/bin/env bash
# MDAnalysis 2.4.2 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1) reading a data file of grains that LAMMPS 20220106 wrote
# (lammps 20220106.git7586adbb6a+ds1-2+b2, atom_style sphere; its rows are id, type, diameter, density, x, y, z, images).
#
# Guess: the line "Atoms # sphere" tells the columns, or an error asks for them: there is no charge in such a file.
# Seen: the rows are taken for those of molecules: the type is the molecule, the diameter is the type and the density is the
# charge, silently. "type 1" selects nothing, "type 1.4" selects the grains of that diameter. Give the columns: atom_style="id
# type diameter density x y z"; the diameter is dropped then.
#   types 0.7 1.4, charges 2.0 3.0, molecules 1 2; "type 1" selects 0
#   with atom_style given: types 1 2; "type 1" selects 1; diameters: none
set -euo pipefail
for pair in python3-mdanalysis=2.4.2+dfsg1-1+b1 lammps=20220106.git7586adbb6a+ds1-2+b2; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > grains.in <<'IN'
units lj
atom_style sphere
region cell block 0 4 0 4 -2 2
create_box 2 cell
create_atoms 1 single 0.5 0.5 0
create_atoms 2 single 3 3.5 0
set type 1 diameter 0.7 density 2
set type 2 diameter 1.4 density 3
pair_style zero 1
pair_coeff * *
run 0
write_data grains.data
IN
lmp -in grains.in -log none -screen none
/usr/bin/python3 -W ignore - > seen <<'PYTHON'
import MDAnalysis

words = lambda values: " ".join(str(value) for value in values)
atoms = MDAnalysis.Universe("grains.data").atoms
print(f"types {words(atoms.types)}, charges {words(atoms.charges)}, molecules {words(atoms.resids)}; "
      f'"type 1" selects {len(atoms.select_atoms("type 1"))}')
atoms = MDAnalysis.Universe("grains.data", atom_style="id type diameter density x y z").atoms
print(f'with atom_style given: types {words(atoms.types)}; "type 1" selects {len(atoms.select_atoms("type 1"))}; '
      f"diameters: {'some' if hasattr(atoms, 'diameters') or hasattr(atoms, 'radii') else 'none'}")
PYTHON
cat seen
diff seen - <<'SEEN'
types 0.7 1.4, charges 2.0 3.0, molecules 1 2; "type 1" selects 0
with atom_style given: types 1 2; "type 1" selects 1; diameters: none
SEEN
