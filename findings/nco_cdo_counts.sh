#!/usr/bin/env bash
# NCO 5.1.4 (Debian 12: nco 5.1.4-1+deb12u1) and CDO 2.1.1 (cdo 2.1.1-1+deb12u1): means over time of a trajectory in NetCDF
# (python3-netcdf4 1.6.2-1+b1) that holds the number of contacts of four grains, an integer, and a flag, a byte, whether it has more than 3.
#
# Guess: the mean number of contacts and the share of time with more than 3, as of any other variable.
# Seen: what ncra, ncwa and cdo timmean write has the type of what they read, so that means of integers are rounded: 2.67 contacts
# are 3, a share of 0.67 is 1 and one of 0.33 is 0. The distance to isostaticity, a tenth of a contact, is gone. Status 0, no
# word of it. The same numbers as float have their means. cdo output -fldmean, which prints, shows 3.75.
#   ncra, contacts: 3, 3, 3, 3
#   ncra, more: 0, 1, 1, 1
#   ncra, as_float: 2.667, 3.333, 2.667, 3.333
#   ncwa, contacts: 3
#   ncwa, more: 1
#   ncwa, as_float: 3
#   cdo timmean, contacts: 3, 3, 3, 3
#   cdo timmean, more: 0, 1, 1, 1
#   cdo timmean, as_float: 2.667, 3.333, 2.667, 3.333
#   cdo output -fldmean, contacts:  3.75 5 0.25 
set -euo pipefail
for pair in nco=5.1.4-1+deb12u1 cdo=2.1.1-1+deb12u1 netcdf-bin=1:4.9.0-3+b1 python3-netcdf4=1.6.2-1+b1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > write.py <<'PYTHON'
import netCDF4
import numpy

contacts = numpy.array([[3, 4, 4, 4], [5, 6, 4, 5], [0, 0, 0, 1]])
with netCDF4.Dataset("run.nc", "w", format="NETCDF3_64BIT_OFFSET") as file:
    file.createDimension("time", None)
    file.createDimension("grain", 4)
    for name, kind, values in (("contacts", "i4", contacts), ("more", "i1", contacts > 3), ("as_float", "f4", contacts)):
        file.createVariable(name, kind, ("time", "grain"))[:] = values
PYTHON
/usr/bin/python3 write.py
show() { # WHAT, FILE: the values in it, one variable after the other
  for name in contacts more as_float; do
    echo "$1, $name: $(ncdump -p 4 -v "$name" "$2" | tr -d '\n' | sed "s/.* $name = *//; s/ *;.*//")"
  done
}
{
  ncra -O run.nc means.nc
  show ncra means.nc
  ncwa -O run.nc mean.nc
  show ncwa mean.nc
  cdo -s timmean run.nc means.nc
  show "cdo timmean" means.nc
  echo "cdo output -fldmean, contacts: $(cdo -s output -fldmean -selname,contacts run.nc | tr -s ' \n' ' ')"
} > seen 2> messages || { cat seen messages; exit 1; }
cat seen
diff seen - <<'SEEN'
ncra, contacts: 3, 3, 3, 3
ncra, more: 0, 1, 1, 1
ncra, as_float: 2.667, 3.333, 2.667, 3.333
ncwa, contacts: 3
ncwa, more: 1
ncwa, as_float: 3
cdo timmean, contacts: 3, 3, 3, 3
cdo timmean, more: 0, 1, 1, 1
cdo timmean, as_float: 2.667, 3.333, 2.667, 3.333
cdo output -fldmean, contacts:  3.75 5 0.25 
SEEN
