#!/usr/bin/env bash
# ml-savitzky-golay-generalized 5.0.0 (npm), which takes the values of x where they are not equally spaced: the derivative of
# y = x, of degree 3, from four decades of x with 10 points each, as a viscosity from a flow curve, and from x = 0, 1 … 40 each moved by
# up to 0.3, as times of output are.
#
# Guess: 1 at every point, as a polynomial of degree 3 holds a straight line.
# Seen: the polynomial is that of equal steps, over the mean step of the window. Over decades a window of 9 points has 0.87, another
# number towards both ends, and 15 points, which should smooth, are worse, 0.66. Over moved points the derivative scatters by
# 30% though there is no noise in y. The manual calls it an approximation for almost equal steps. Take log y over log x, which is
# equally spaced.
#   equal steps, window 9: 1.00 to 1.00, inside 1.00 to 1.00
#   10 a decade, window 5: 0.80 to 1.24, inside 0.97 to 0.97
#   10 a decade, window 9: 0.68 to 1.48, inside 0.87 to 0.87
#   10 a decade, window 15: 0.45 to 1.80, inside 0.66 to 0.66
#   moved, window 5: 0.69 to 1.42, inside 0.69 to 1.42
#   moved, window 9: 0.74 to 1.26, inside 0.88 to 1.18
#   moved, window 15: 0.93 to 1.10, inside 0.95 to 1.10
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . ml-savitzky-golay-generalized@5.0.0 >/dev/null
cat > slope.mjs <<'NODE'
import { sgg } from 'ml-savitzky-golay-generalized';
const show = (name, x, windowSize) => {
  const slopes = sgg(x, x, { derivative: 1, windowSize, polynomial: 3 });
  const inside = slopes.slice(windowSize, -windowSize);
  const range = (list) => `${Math.min(...list).toFixed(2)} to ${Math.max(...list).toFixed(2)}`;
  console.log(`${name}, window ${windowSize}: ${range(slopes)}, inside ${range(inside)}`);
};
const numbers = [...Array(41).keys()];
let state = 1;
const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
const decades = numbers.map((n) => 10 ** (n / 10 - 2));
const moved = numbers.map((n) => n + 0.6 * (random() - 0.5));
show('equal steps', numbers, 9);
for (const windowSize of [5, 9, 15]) show('10 a decade', decades, windowSize);
for (const windowSize of [5, 9, 15]) show('moved', moved, windowSize);
NODE
node slope.mjs > seen
cat seen
diff seen - <<'SEEN'
equal steps, window 9: 1.00 to 1.00, inside 1.00 to 1.00
10 a decade, window 5: 0.80 to 1.24, inside 0.97 to 0.97
10 a decade, window 9: 0.68 to 1.48, inside 0.87 to 0.87
10 a decade, window 15: 0.45 to 1.80, inside 0.66 to 0.66
moved, window 5: 0.69 to 1.42, inside 0.69 to 1.42
moved, window 9: 0.74 to 1.26, inside 0.88 to 1.18
moved, window 15: 0.93 to 1.10, inside 0.95 to 1.10
SEEN
