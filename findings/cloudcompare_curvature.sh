#!/usr/bin/env bash
# CloudCompare 2.11.3 (Debian 12: cloudcompare 2.11.3-7.1), from the command line: the mean and the Gaussian curvature (-CURV)
# at the 642 vertices of an icosphere of radius r, with neighbours within 0.3 r; means over the vertices, times r and r².
#
# Guess: 0.99 and 0.98 at any r, as the neighbours are the same ones.
# Seen: so from r = 0.5 on. At 0.2 they are 0.90 and 0.78, at 0.1 the mean curvature is 44 times too small, at 0.01 a sphere
# is flat. A sphere of 10 cm in metres is flat, the same in millimetres is right. It goes by the reach of the neighbours, too:
# within 0.5 r a sphere of 0.1 is still right, and one of 0.01 is not. No warning. Scale the points to a size of 100 first.
#   radius 100: mean 0.99, Gaussian 0.98
#   radius 1: mean 0.99, Gaussian 0.98
#   radius 0.2: mean 0.90, Gaussian 0.78
#   radius 0.1: mean 0.02, Gaussian 0.01
#   radius 0.01: mean 0.00, Gaussian 0.00
set -euo pipefail
want=2.11.3-7.1
version=$(dpkg-query -W -f='${Version}' cloudcompare 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs cloudcompare $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > sphere.py <<'PYTHON'
import sys

golden = (1 + 5**0.5) / 2
points = []
for one in (-1, 1):
    for other in (-golden, golden):
        points += [(0, one, other), (one, other, 0), (other, 0, one)]
near = lambda a, b: abs(sum((x - y)**2 for x, y in zip(a, b)) - 4) < 1e-9
faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b)
         if near(points[a], points[b]) and near(points[b], points[c]) and near(points[c], points[a])]
for _ in range(3):
    middles, finer = {}, []

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
            middles[key] = len(points) - 1
        return middles[key]

    points = [tuple(x / sum(y * y for y in p)**0.5 for x in p) for p in points]
    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    faces = finer
for p in points:
    print(*(float(sys.argv[1]) * x / sum(y * y for y in p)**0.5 for x in p))
PYTHON
curvature() {
  rm -f out.asc
  QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR=$folder CloudCompare -SILENT -AUTO_SAVE OFF -C_EXPORT_FMT ASC -PREC 12 -O in.asc \
    -CURV "$1" "$2" -SAVE_CLOUDS FILE out.asc > messages 2>&1 || { cat messages; exit 1; }
  awk -v scale="$3" '{ sum += scale * $NF } END { if (NR != 642) exit 1; printf "%.2f", sum / NR }' out.asc
}
for radius in 100 1 0.2 0.1 0.01; do
  /usr/bin/python3 sphere.py $radius > in.asc
  read -r within square < <(awk "BEGIN { print 0.3 * $radius, $radius^2 }")
  echo "radius $radius: mean $(curvature MEAN "$within" $radius), Gaussian $(curvature GAUSS "$within" "$square")"
done > seen
cat seen
diff seen - <<'SEEN'
radius 100: mean 0.99, Gaussian 0.98
radius 1: mean 0.99, Gaussian 0.98
radius 0.2: mean 0.90, Gaussian 0.78
radius 0.1: mean 0.02, Gaussian 0.01
radius 0.01: mean 0.00, Gaussian 0.00
SEEN
