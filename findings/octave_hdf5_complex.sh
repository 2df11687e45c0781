#!/usr/bin/env bash
# GNU Octave 7.3.0 (Debian 12: octave 7.3.0-2) loading an HDF5 file with a complex dataset written by h5py (python3-h5py
# 3.7.0-8), for example the bond-orientational order of each particle.
#
# Guess: the numbers, or a message that the type is not known (as for a compound of any other kind).
# Seen: a complex matrix of the right shape, all zeros, without a word. h5py names the parts of a complex number "r" and "i";
# Octave takes any compound of two floating-point numbers for complex, and fills it from "real" and "imag" alone. Write the
# parts as two datasets, or set h5py's names: h5py.get_config().complex_names = ("real", "imag").
#   named r, i:       psi6 = [0+0i 0+0i 0+0i] complex 1
#   named real, imag: psi6 = [1+2i 3-4i 0.5+0i] complex 1
set -euo pipefail
for pair in octave=7.3.0-2 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py

for path, names in (("short.h5", ("r", "i")), ("long.h5", ("real", "imag"))):
    h5py.get_config().complex_names = names
    with h5py.File(path, "w") as file:
        file["psi6"] = [1 + 2j, 3 - 4j, 0.5 + 0j]
PYTHON
cat > read.m <<'OCTAVE'
short = load("short.h5");
printf("named r, i:       psi6 = %s complex %d\n", mat2str(short.psi6), iscomplex(short.psi6));
long = load("long.h5");
printf("named real, imag: psi6 = %s complex %d\n", mat2str(long.psi6), iscomplex(long.psi6));
OCTAVE
octave --norc --quiet read.m > seen 2> messages
cat seen messages
diff seen - <<'SEEN'
named r, i:       psi6 = [0+0i 0+0i 0+0i] complex 1
named real, imag: psi6 = [1+2i 3-4i 0.5+0i] complex 1
SEEN
