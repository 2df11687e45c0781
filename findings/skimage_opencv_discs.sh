#!/usr/bin/env bash
# scikit-image 0.19.3 (Debian 12: python3-skimage 0.19.3-8) and OpenCV 4.6 (python3-opencv 4.6.0+dfsg-12): shape of discs as
# they come out of an image, pixels being set whose centre lies within the radius; means over twenty places of the centre.
#
# Guess: area, perimeter and circularity (4 pi area / perimeter^2) of a disc get better with the number of pixels.
# Seen: the area does. Perimeters settle 5% too large, so that the circularity of a disc falls through 1 near a radius of 8 pixels
# and ends at 0.90: large grains look less round than small ones, and a mixture of sizes like one of shapes. OpenCV's area of a
# contour is that of the polygon through the centres of its pixels: half a pixel is missing all around, 18% of the area at
# radius 5, and the same goes for its ellipses. Take perimeter_crofton and the number of pixels, which are right
# to a percent from radius 3 on.
#   radius 3: area 1.01, perimeter 0.90, circularity 1.25, crofton 1.00; opencv: area 0.71, circularity 0.88, ellipse 0.88
#   radius 5: area 1.00, perimeter 0.97, circularity 1.07, crofton 1.00; opencv: area 0.82, circularity 0.88, ellipse 0.92
#   radius 10: area 1.00, perimeter 1.01, circularity 0.98, crofton 1.00; opencv: area 0.91, circularity 0.89, ellipse 0.96
#   radius 20: area 1.00, perimeter 1.03, circularity 0.94, crofton 1.00; opencv: area 0.96, circularity 0.90, ellipse 0.98
#   radius 50: area 1.00, perimeter 1.05, circularity 0.91, crofton 1.00; opencv: area 0.98, circularity 0.90, ellipse 0.99
#   radius 200: area 1.00, perimeter 1.05, circularity 0.90, crofton 1.00; opencv: area 1.00, circularity 0.90, ellipse 1.00
set -euo pipefail
for wanted in python3-skimage=0.19.3-8 python3-opencv=4.6.0+dfsg-12; do
  version=$(dpkg-query -W -f='${Version}' "${wanted%%=*}" 2>/dev/null || true)
  [ "$version" = "${wanted#*=}" ] || { echo "needs ${wanted%%=*} ${wanted#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen <<'PYTHON'
import cv2
import numpy
from skimage import measure


def look(radius, random):  # each by the value of a disc
    centre = radius + 5 + random.rand(2)
    rows, columns = numpy.mgrid[: 2 * radius + 12, : 2 * radius + 12]
    picture = (numpy.hypot(rows - centre[0], columns - centre[1]) < radius).astype(numpy.uint8)
    grain = measure.regionprops(picture)[0]
    contour = cv2.findContours(picture, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0][0]
    area, length, pi = cv2.contourArea(contour), cv2.arcLength(contour, True), numpy.pi
    return [grain.area / (pi * radius**2), grain.perimeter / (2 * pi * radius), 4 * pi * grain.area / grain.perimeter**2,
            grain.perimeter_crofton / (2 * pi * radius), area / (pi * radius**2), 4 * pi * area / length**2,
            numpy.mean(cv2.fitEllipse(contour)[1]) / (2 * radius)]


for radius in (3, 5, 10, 20, 50, 200):
    random = numpy.random.RandomState(0)
    words = [f"{x:.2f}" for x in numpy.mean([look(radius, random) for _ in range(20)], axis=0)]
    print(f"radius {radius}: area {words[0]}, perimeter {words[1]}, circularity {words[2]}, crofton {words[3]}; "
          f"opencv: area {words[4]}, circularity {words[5]}, ellipse {words[6]}")
PYTHON
cat seen
diff seen - <<'SEEN'
radius 3: area 1.01, perimeter 0.90, circularity 1.25, crofton 1.00; opencv: area 0.71, circularity 0.88, ellipse 0.88
radius 5: area 1.00, perimeter 0.97, circularity 1.07, crofton 1.00; opencv: area 0.82, circularity 0.88, ellipse 0.92
radius 10: area 1.00, perimeter 1.01, circularity 0.98, crofton 1.00; opencv: area 0.91, circularity 0.89, ellipse 0.96
radius 20: area 1.00, perimeter 1.03, circularity 0.94, crofton 1.00; opencv: area 0.96, circularity 0.90, ellipse 0.98
radius 50: area 1.00, perimeter 1.05, circularity 0.91, crofton 1.00; opencv: area 0.98, circularity 0.90, ellipse 0.99
radius 200: area 1.00, perimeter 1.05, circularity 0.90, crofton 1.00; opencv: area 1.00, circularity 0.90, ellipse 1.00
SEEN
