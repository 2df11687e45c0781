#!/usr/bin/env bash
# Packmol 20.14.0 (Debian 12: packmol 1:20.14.0-1) placing sixty grains of diameter 1, as a start of a simulation, by the unit
# of length.
#
# Guess: distances of at least a diameter, in any unit, wherever it prints "Success!".
# Seen: so in diameters, though grains leave their box by up to a hundredth. With the same packing in units of a hundredth it is
# a success too, with centres 0.3 diameters apart; with a millionth grains are on top of each other. `precision` in the same
# proportion changes nothing. Pack in diameters, and scale what comes.
#   diameter 1: Success, least distance 1.0 diameters
#   diameter 0.01: Success, least distance below 0.5 diameters
#   diameter 1e-06: Success, least distance below 0.5 diameters
set -euo pipefail
want=1:20.14.0-1
version=$(dpkg-query -W -f='${Version}' packmol 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs packmol $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
printf '1\n\nH 0 0 0\n' > grain.xyz
for diameter in 1 0.01 1e-06; do
  width=$(awk -v d="$diameter" 'BEGIN { printf "%.8f", 5 * d }')
  cat > pack.in <<IN
tolerance $(printf %.8f "$diameter")
filetype xyz
output packed.xyz
seed 1
structure grain.xyz
  number 60
  inside box 0. 0. 0. $width $width $width
end structure
IN
  packmol < pack.in > report
  said=$(grep -o "Success" report | head -1)
  awk -v d="$diameter" -v said="$said" 'NR > 2 { for (k = 2; k < 5; ++k) x[NR, k] = $k } END {
    least = 1e9
    for (i = 3; i <= NR; ++i) for (j = 3; j < i; ++j) {
      r = sqrt((x[i, 2] - x[j, 2])^2 + (x[i, 3] - x[j, 3])^2 + (x[i, 4] - x[j, 4])^2)
      if (r < least) least = r
    }
    printf "diameter %s: %s, least distance %s diameters\n", d, said, least < d / 2 ? "below 0.5" : sprintf("%.1f", least / d)
  }' packed.xyz
done > seen
cat seen
diff seen - <<'SEEN'
diameter 1: Success, least distance 1.0 diameters
diameter 0.01: Success, least distance below 0.5 diameters
diameter 1e-06: Success, least distance below 0.5 diameters
SEEN
