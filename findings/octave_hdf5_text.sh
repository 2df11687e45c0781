#!/usr/bin/env bash
# GNU Octave 7.3.0 (Debian 12: octave 7.3.0-2) loading an HDF5 file with text among its numbers, written by h5py
# (python3-h5py 3.7.0-8).
#
# Guess: text comes as text, or is skipped with a warning like other types Octave does not know (an enumeration, a record).
# Seen: the first text of variable length, or marked as UTF-8, ends the reading: all that follows by name is not in what
# `load` returns, which is no error: a script goes on with what it has. In a sub-folder the whole folder is lost, and what
# follows. An enumeration is skipped. Write text of fixed length marked as ASCII (numpy.bytes_), or give it the last name.
#   fixed ascii:  a b c z
#   enumeration:  a c z
#   fixed utf-8:  a
#   variable:     a
#   in a folder:  a
set -euo pipefail
for pair in octave=7.3.0-2 python3-h5py=3.7.0-8; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import h5py
import numpy

kinds = {"ascii": ("b", numpy.bytes_("shear")), "enum": ("b", numpy.array([True, False])),
         "utf8": ("b", numpy.array(b"shear", dtype=h5py.string_dtype("utf-8", 5))), "variable": ("b", "shear"),
         "folder": ("b/text", "shear")}
for kind, (name, value) in kinds.items():
    with h5py.File(kind + ".h5", "w") as file:
        file["a"] = [1.0, 2.0]
        file[name] = value
        file["c"] = [3.0, 4.0]
        file["z/x"] = [5.0]
PYTHON
cat > read.m <<'OCTAVE'
1;
function show(label, path)
  printf("%s %s\n", label, strjoin(fieldnames(load(path))', " "));
end
show("fixed ascii: ", "ascii.h5");
show("enumeration: ", "enum.h5");
show("fixed utf-8: ", "utf8.h5");
show("variable:    ", "variable.h5");
show("in a folder: ", "folder.h5");
OCTAVE
octave --norc --quiet read.m > seen 2> messages
cat seen
grep '^warning' messages
diff seen - <<'SEEN'
fixed ascii:  a b c z
enumeration:  a c z
fixed utf-8:  a
variable:     a
in a folder:  a
SEEN
