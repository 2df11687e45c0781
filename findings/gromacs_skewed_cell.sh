#!/usr/bin/env bash
# GROMACS 2022.5 (Debian 12: gromacs 2022.5-2): distances across a sheared periodic cell, by `gmx pairdist`.
#
# Guess: the least distance over all images at any tilt, as a cell sheared by 0.6 and one by -0.4 are the same lattice; or an error.
# Seen: right up to a tilt of half the cell. Beyond, the cell counts as not periodic at all: two particles 1.414 apart across the
# boundary are 11.402 apart. "Warning: Triclinic box is too skewed" on stderr is all, and the exit status is 0. Flip the cell
# (tilt - 1) before.
#   tilt 0.4: 3.162, in truth 3.162
#   tilt 0.5: 2.236, in truth 2.236
#   tilt 0.6: 11.402, in truth 1.414
#   tilt -0.4, the same lattice: 1.414, in truth 1.414
set -euo pipefail
want=2022.5-2
version=$(dpkg-query -W -f='${Version}' gromacs 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs gromacs $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
export OMP_NUM_THREADS=1
for tilt in 0.4 0.5 0.6 -0.4; do
  {
    printf 'two\n2\n'
    printf '%5d%-5s%5s%5d%8.3f%8.3f%8.3f\n' 1 X A 1 1 0.5 1 2 X A 2 8 9.5 1
    printf '%10.5f%10.5f%10.5f%10.5f%10.5f%10.5f%10.5f%10.5f%10.5f\n' 10 10 5 0 0 "$(awk "BEGIN { print 10 * $tilt }")" 0 0 0
  } > two.gro
  gmx -nobackup -quiet pairdist -f two.gro -s two.gro -ref 'atomnr 1' -sel 'atomnr 2' -o distance.xvg > screen 2>&1
  true=$(awk "BEGIN { least = 99; for (i = -4; i <= 4; ++i) for (j = -2; j <= 1; ++j) {
    x = 7 + 10 * i + 10 * $tilt * j; y = 9 + 10 * j; r = sqrt(x * x + y * y); if (r < least) least = r }
    printf \"%.3f\", least }")
  note=""; [ "$tilt" != -0.4 ] || note=", the same lattice"
  echo "tilt $tilt$note: $(awk '!/^[#@]/ { print $2 }' distance.xvg), in truth $true"
done > seen
cat seen
diff seen - <<'SEEN'
tilt 0.4: 3.162, in truth 3.162
tilt 0.5: 2.236, in truth 2.236
tilt 0.6: 11.402, in truth 1.414
tilt -0.4, the same lattice: 1.414, in truth 1.414
SEEN
