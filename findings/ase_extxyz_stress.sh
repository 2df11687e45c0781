#!/usr/bin/env bash
# ASE 3.22.1 (Debian 12: python3-ase 3.22.1-3+deb12u1) reading and writing an extended XYZ file with a stress that is not
# symmetric, as frictional grains have, or that has six components.
#
# Guess: nine numbers are kept, six are taken for xx yy zz yz xz xy, as ASE's own stress has them.
# Seen: nine come as the transpose of their rows in `info` (the format counts down columns), and as six from one triangle of
# it: get_stress() has the fourth number of the file for xy, not the mean and not the second. Reading and writing makes the
# file symmetric with these: the second, third and sixth number are gone, without a word. Six numbers make the file
# unreadable (ValueError). Under another name nine numbers stay nine, in their order: do not call it stress (or virial).
#   stress, info: [[1, 4, 7], [2, 5, 8], [3, 6, 9]]
#   stress, get_stress: [1, 5, 9, 8, 7, 4]
#   stress, written again: 1.0 4.0 7.0 4.0 5.0 8.0 7.0 8.0 9.0
#   tension, info: [1, 2, 3, 4, 5, 6, 7, 8, 9]
#   tension, written again: 1 2 3 4 5 6 7 8 9
#   stress of six numbers: ValueError
set -euo pipefail
want=3.22.1-3+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-ase 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-ase $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen <<'PYTHON'
import re

import ase.io


def read(name, values):
    with open("one.xyz", "w") as file:
        file.write(f'1\nLattice="4 0 0 0 5 0 0 0 6" Properties=species:S:1:pos:R:3 {name}="{values}" pbc="T T F"\nH 1 1 0\n')
    return ase.io.read("one.xyz", format="extxyz")


def again(atoms, name):
    ase.io.write("two.xyz", atoms, format="extxyz")
    return re.search(f'{name}="([^"]*)"', open("two.xyz").read()).group(1)


nine = "1 2 3 4 5 6 7 8 9"
atoms = read("stress", nine)
print("stress, info:", atoms.info["stress"].tolist())
print("stress, get_stress:", [round(x) for x in atoms.get_stress()])
print("stress, written again:", again(atoms, "stress"))
atoms = read("tension", nine)
print("tension, info:", atoms.info["tension"].tolist())
print("tension, written again:", again(atoms, "tension"))
try:
    print("stress of six numbers:", read("stress", "1 2 3 4 5 6").info["stress"])
except Exception as error:
    print("stress of six numbers:", type(error).__name__)
PYTHON
cat seen
diff seen - <<'SEEN'
stress, info: [[1, 4, 7], [2, 5, 8], [3, 6, 9]]
stress, get_stress: [1, 5, 9, 8, 7, 4]
stress, written again: 1.0 4.0 7.0 4.0 5.0 8.0 7.0 8.0 9.0
tension, info: [1, 2, 3, 4, 5, 6, 7, 8, 9]
tension, written again: 1 2 3 4 5 6 7 8 9
stress of six numbers: ValueError
SEEN
