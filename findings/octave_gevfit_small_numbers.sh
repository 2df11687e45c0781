#!/usr/bin/env bash
# statistics 1.5.3 of Octave (Debian 12: octave-statistics 1.5.3-2), gevfit: 20 samples of 500 values of a generalized extreme
# value distribution of width 1 and place 3, as of the largest force in a packing, with shape 0.3 (a heavy tail), 0 and -0.3 (an
# end), in units u; the least and the largest of the 20 shapes, and of the widths in units of u.
#
# Guess: the fits are of maximum likelihood, so that the shape does not depend on the unit.
# Seen: where the values are of the order of 1e-9, as forces of colloids in N, every sample of every distribution has a shape of
# 0.00, heavy tails and ends alike, with a width up to nine times too large; at 1e-6 a heavy tail has anything from -0.19 to 1.63.
# No warning, unless one asks for the intervals of confidence, too. Scale the values to the order of 1 before.
#   shape 0.3, u = 1: shapes 0.02 to 0.38, widths 0.94 to 2.19
#   shape 0.3, u = 0.001: shapes 0.25 to 0.38, widths 0.94 to 1.09
#   shape 0.3, u = 1e-06: shapes -0.19 to 1.63, widths 1.93 to 8.96
#   shape 0.3, u = 1e-09: shapes -0.00 to -0.00, widths 2.79 to 9.41
#   shape 0.0, u = 1: shapes -0.03 to 0.04, widths 0.95 to 1.08
#   shape 0.0, u = 0.001: shapes -0.03 to 0.04, widths 0.95 to 1.08
#   shape 0.0, u = 1e-06: shapes -0.20 to 0.00, widths 1.02 to 2.07
#   shape 0.0, u = 1e-09: shapes -0.00 to -0.00, widths 1.45 to 2.07
#   shape -0.3, u = 1: shapes -0.35 to -0.28, widths 0.95 to 1.07
#   shape -0.3, u = 0.001: shapes -0.35 to -0.28, widths 0.95 to 1.07
#   shape -0.3, u = 1e-06: shapes -0.29 to -0.00, widths 0.90 to 0.99
#   shape -0.3, u = 1e-09: shapes -0.00 to -0.00, widths 0.90 to 1.00
set -euo pipefail
want=1.5.3-2
version=$(dpkg-query -W -f='${Version}' octave-statistics 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs octave-statistics $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > tail.m <<'OCTAVE'
warning("off", "Octave:shadowed-function");
pkg load statistics
for shape = [0.3, 0, -0.3]
  for u = [1, 1e-3, 1e-6, 1e-9]
    fits = zeros(20, 3);
    for sample = 1:20
      rand("twister", sample);
      p = rand(500, 1);
      if shape == 0
        values = 3 - log(-log(p));
      else
        values = 3 + ((-log(p)).^(-shape) - 1) / shape;
      end
      fits(sample, :) = gevfit(values * u);
    end
    printf("shape %.1f, u = %g: shapes %.2f to %.2f, widths %.2f to %.2f\n", shape, u, min(fits(:, 1)), max(fits(:, 1)), ...
      min(fits(:, 2)) / u, max(fits(:, 2)) / u);
  end
end
OCTAVE
octave-cli -qf --no-window-system tail.m > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
shape 0.3, u = 1: shapes 0.02 to 0.38, widths 0.94 to 2.19
shape 0.3, u = 0.001: shapes 0.25 to 0.38, widths 0.94 to 1.09
shape 0.3, u = 1e-06: shapes -0.19 to 1.63, widths 1.93 to 8.96
shape 0.3, u = 1e-09: shapes -0.00 to -0.00, widths 2.79 to 9.41
shape 0.0, u = 1: shapes -0.03 to 0.04, widths 0.95 to 1.08
shape 0.0, u = 0.001: shapes -0.03 to 0.04, widths 0.95 to 1.08
shape 0.0, u = 1e-06: shapes -0.20 to 0.00, widths 1.02 to 2.07
shape 0.0, u = 1e-09: shapes -0.00 to -0.00, widths 1.45 to 2.07
shape -0.3, u = 1: shapes -0.35 to -0.28, widths 0.95 to 1.07
shape -0.3, u = 0.001: shapes -0.35 to -0.28, widths 0.95 to 1.07
shape -0.3, u = 1e-06: shapes -0.29 to -0.00, widths 0.90 to 0.99
shape -0.3, u = 1e-09: shapes -0.00 to -0.00, widths 0.90 to 1.00
SEEN
