#!/usr/bin/env bash
# TetGen 1.5.0 (Debian 12: tetgen 1.5.0-5): the boundary faces it writes (.face) for closed surfaces given as OFF, by themselves
# (-p), with a refined interior (-pqa) and with the surface left as it is (-pY). Volumes of the tetrahedra, and of the surface.
#
# Guess: the faces are turned as they were in the input, outwards, and have the volume of the tetrahedra.
# Seen: all faces look inwards, those of the surface that -Y is to preserve as well, so that the volume of the surface is
# -1 for a cube, whichever way the input was turned; a pressure or a contact force along their normals has the wrong sign. The
# tetrahedra have positive volumes. Exchange two corners of each face.
#   outwards, -p: input 1.000, tetrahedra 1.000, 12 faces -1.000
#   outwards, -pq1.4a0.01: input 1.000, tetrahedra 1.000, 372 faces -1.000
#   outwards, -pY: input 1.000, tetrahedra 1.000, 12 faces -1.000
#   inwards, -p: input -1.000, tetrahedra 1.000, 12 faces -1.000
#   inwards, -pq1.4a0.01: input -1.000, tetrahedra 1.000, 378 faces -1.000
#   inwards, -pY: input -1.000, tetrahedra 1.000, 12 faces -1.000
set -euo pipefail
want=1.5.0-5
version=$(dpkg-query -W -f='${Version}' tetgen 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs tetgen $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
volumes() { # NAME: of the input, of the tetrahedra and of the faces of TetGen, whose indices are from 0 as in OFF
  awk '
    function six(a, b, c) {
      return x[a] * (y[b] * z[c] - z[b] * y[c]) + y[a] * (z[b] * x[c] - x[b] * z[c]) + z[a] * (x[b] * y[c] - y[b] * x[c])
    }
    /^#/ || FNR == 1 { next }
    FILENAME ~ /node$/ { x[$1] = $2; y[$1] = $3; z[$1] = $4 }
    FILENAME ~ /face$/ { faces++; surface += six($2, $3, $4) / 6 }
    FILENAME ~ /ele$/ { inside += (six($3, $4, $5) - six($2, $4, $5) + six($2, $3, $5) - six($2, $3, $4)) / 6 }
    FILENAME ~ /off$/ && FNR > 10 { given += six($2, $3, $4) / 6 }
    END { printf "input %.3f, tetrahedra %.3f, %d faces %.3f\n", given, inside, faces, surface }
  ' "$1.1.node" "$1.off" "$1.1.ele" "$1.1.face"
}
cube() { # ORDER of the corners of each triangle
  printf 'OFF\n8 12 0\n0 0 0\n0 0 1\n0 1 0\n0 1 1\n1 0 0\n1 0 1\n1 1 0\n1 1 1\n'
  for side in "0 1 3 2" "4 6 7 5" "0 4 5 1" "2 3 7 6" "0 2 6 4" "1 5 7 3"; do
    set -- "$1" $side
    if [ "$1" = outwards ]; then printf '3 %d %d %d\n3 %d %d %d\n' "$2" "$3" "$4" "$2" "$4" "$5"
    else printf '3 %d %d %d\n3 %d %d %d\n' "$2" "$4" "$3" "$2" "$5" "$4"; fi
  done
}
for order in outwards inwards; do
  for options in -p -pq1.4a0.01 -pY; do
    rm -f cube.*
    cube "$order" > cube.off
    tetgen "$options" cube.off > messages
    echo "$order, $options: $(volumes cube)"
  done
done > seen
cat seen
diff seen - <<'SEEN'
outwards, -p: input 1.000, tetrahedra 1.000, 12 faces -1.000
outwards, -pq1.4a0.01: input 1.000, tetrahedra 1.000, 372 faces -1.000
outwards, -pY: input 1.000, tetrahedra 1.000, 12 faces -1.000
inwards, -p: input -1.000, tetrahedra 1.000, 12 faces -1.000
inwards, -pq1.4a0.01: input -1.000, tetrahedra 1.000, 378 faces -1.000
inwards, -pY: input -1.000, tetrahedra 1.000, 12 faces -1.000
SEEN
