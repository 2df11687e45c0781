#!/usr/bin/env bash
# voro++ 0.4.6, the command (Debian 12: voro++ 0.5+revert-to-0.4.6+dfsg1-1): particles outside the container.
#
# Guess: a particle outside a container that is not periodic is an error or a warning.
# Seen: it vanishes from the output, exit 0 and no word; the cells left fill the container, so that the sum of volumes, the
# usual check, stays right. With -p the particle is wrapped, and the output has the wrapped position. Count the lines.
#   not periodic: 1 of 3 particles, volume 1
#   periodic:     3 of 3 particles, volume 1, particle 2 at 0.7
set -euo pipefail
version=$(dpkg-query -W -f='${Version}' voro++ 2>/dev/null || true)
[ "$version" = 0.5+revert-to-0.4.6+dfsg1-1 ] || { echo "needs voro++ 0.5+revert-to-0.4.6+dfsg1-1, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
printf '1 0.5 0.5 0.5\n2 1.7 0.5 0.5\n3 0.2 -0.3 0.5\n' > points
sum() { awk '{n++; v+=$NF} END {printf "%d of 3 particles, volume %.3g", n, v}' points.vol; }
voro++ -c "%i %x %v" 0 1 0 1 0 1 points; walls=$(sum)
voro++ -p -c "%i %x %v" 0 1 0 1 0 1 points; periodic="$(sum), particle 2 at $(awk '$1 == 2 {print $2}' points.vol)"
echo "not periodic: $walls"
echo "periodic:     $periodic"
[ "$walls" = "1 of 3 particles, volume 1" ] && [ "$periodic" = "3 of 3 particles, volume 1, particle 2 at 0.7" ]
