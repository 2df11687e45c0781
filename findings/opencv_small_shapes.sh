#!/usr/bin/env bash
# OpenCV 4.6 (Debian 12: python3-opencv 4.6.0+dfsg-12) on the corners of particles, by the size s of a particle, in units of s:
# the overlap of two hexagons (intersectConvexConvex), the smallest circle about one (minEnclosingCircle), its area
# (contourArea), and the overlap of two turned squares (rotatedRectangleIntersection). True are 0.5397, 1, 2.5981 and 0.7484.
#
# Guess: floats have seven digits at any size, and so have the answers, in metres, millimetres or pixels.
# Seen: 0.0001 is added to the radius of the circle, in whatever units, so that a grain of 1 mm in metres is a tenth too large and
# one of a micrometre 100 times. Hexagons of 1 mm do not overlap. The squares and the areas are right, and nothing is said.
#   s = 100: overlap 0.5397, circle 1.0000, area 2.5981, overlap of squares 0.7484
#   s = 1: overlap 0.5397, circle 1.0001, area 2.5981, overlap of squares 0.7484
#   s = 0.1: overlap 0.5397, circle 1.0010, area 2.5981, overlap of squares 0.7484
#   s = 0.01: overlap 0.5397, circle 1.0100, area 2.5981, overlap of squares 0.7484
#   s = 0.001: overlap 0.0000, circle 1.1000, area 2.5981, overlap of squares 0.7484
#   s = 0.0001: overlap 0.0000, circle 2.0000, area 2.5981, overlap of squares 0.7484
#   s = 1e-06: overlap 0.0000, circle 100.5000, area 2.5981, overlap of squares 0.7484
set -euo pipefail
want=4.6.0+dfsg-12
version=$(dpkg-query -W -f='${Version}' python3-opencv 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-opencv $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > shapes.py <<'PYTHON'
import cv2
import numpy


def hexagon(x, y, turn, size):
    angles = turn + 2 * numpy.pi * numpy.arange(6) / 6
    corners = numpy.stack([x + numpy.cos(angles), y + numpy.sin(angles)], axis=1)
    return (size * corners).astype(numpy.float32)


for size in (100, 1, 0.1, 0.01, 0.001, 1e-4, 1e-6):
    one, other = hexagon(0, 0, 0.1, size), hexagon(1.2, 0.3, 0.7, size)
    overlap = cv2.intersectConvexConvex(one, other)[0] / size**2
    radius = cv2.minEnclosingCircle(one)[1] / size
    area = cv2.contourArea(one) / size**2
    squares = [((place * size, 0), (size, size), turn) for place, turn in ((0, 0), (0.2, 45))]
    corners = cv2.rotatedRectangleIntersection(*squares)[1]
    square = cv2.contourArea(cv2.convexHull(corners)) / size**2
    print(f"s = {size:g}: overlap {overlap:.4f}, circle {radius:.4f}, area {area:.4f}, overlap of squares {square:.4f}")
PYTHON
timeout 60 /usr/bin/python3 shapes.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
s = 100: overlap 0.5397, circle 1.0000, area 2.5981, overlap of squares 0.7484
s = 1: overlap 0.5397, circle 1.0001, area 2.5981, overlap of squares 0.7484
s = 0.1: overlap 0.5397, circle 1.0010, area 2.5981, overlap of squares 0.7484
s = 0.01: overlap 0.5397, circle 1.0100, area 2.5981, overlap of squares 0.7484
s = 0.001: overlap 0.0000, circle 1.1000, area 2.5981, overlap of squares 0.7484
s = 0.0001: overlap 0.0000, circle 2.0000, area 2.5981, overlap of squares 0.7484
s = 1e-06: overlap 0.0000, circle 100.5000, area 2.5981, overlap of squares 0.7484
SEEN
