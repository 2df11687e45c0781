#!/usr/bin/env bash
# MDAnalysis 2.4.2 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1), MDAnalysis.units.convert: a velocity of 1 Angstrom per
# picosecond, 100 m/s, in other units, and back to m/s.
#
# Guess: 100 m/s from each of them, as for the units of length and time themselves.
# Seen: Angstrom per fs, us and ms have their factors upside down: 1 A/ps is 1000 A/fs, for 0.001, and 1e-6 A/us, for 1e6. A
# velocity of 1 m/s, given as 1e4 A/us, is 1e12 m/s, and so would be a drift in A/us of a colloid. There and back again within
# the same unit is 1, so that a test of that kind does not see it. A/ps, nm/ps, nm/ns, pm/ps and m/s are right.
#   1 A/ps is 0.1 nm/ps, by length and time 0.1; 0.1 nm/ps is 100 m/s
#   1 A/ps is 100 nm/ns, by length and time 100; 100 nm/ns is 100 m/s
#   1 A/ps is 100 pm/ps, by length and time 100; 100 pm/ps is 100 m/s
#   1 A/ps is 1000 A/fs, by length and time 0.001; 0.001 A/fs is 0.0001 m/s
#   1 A/ps is 1e-06 A/us, by length and time 1e+06; 1e+06 A/us is 1e+14 m/s
#   1 A/ps is 1e-09 A/ms, by length and time 1e+09; 1e+09 A/ms is 1e+20 m/s
set -euo pipefail
want=2.4.2+dfsg1-1+b1
version=$(dpkg-query -W -f='${Version}' python3-mdanalysis 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-mdanalysis $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > speeds.py <<'PYTHON'
from MDAnalysis.units import convert

for unit in ("nm/ps", "nm/ns", "pm/ps", "A/fs", "A/us", "A/ms"):
    length, time = unit.split("/")
    length = {"A": "Angstrom"}.get(length, length)
    true = convert(1, "Angstrom", length) / convert(1, "ps", time)
    seen = convert(1, "A/ps", unit)
    back = convert(true, unit, "m/s")
    print(f"1 A/ps is {seen:.4g} {unit}, by length and time {true:.4g}; {true:.4g} {unit} is {back:.4g} m/s")
PYTHON
/usr/bin/python3 speeds.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
1 A/ps is 0.1 nm/ps, by length and time 0.1; 0.1 nm/ps is 100 m/s
1 A/ps is 100 nm/ns, by length and time 100; 100 nm/ns is 100 m/s
1 A/ps is 100 pm/ps, by length and time 100; 100 pm/ps is 100 m/s
1 A/ps is 1000 A/fs, by length and time 0.001; 0.001 A/fs is 0.0001 m/s
1 A/ps is 1e-06 A/us, by length and time 1e+06; 1e+06 A/us is 1e+14 m/s
1 A/ps is 1e-09 A/ms, by length and time 1e+09; 1e+09 A/ms is 1e+20 m/s
SEEN
