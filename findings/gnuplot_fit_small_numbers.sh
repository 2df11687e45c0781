#!/usr/bin/env bash
# gnuplot 5.4.4 (Debian 12: gnuplot-nox 5.4.4+dfsg1-2+b2), fit: a mean squared displacement of 0.4 t^0.8, with a scatter of 1%, in
# units u, by 4 D t^n from the start D = 1, n = 1, without error bars and with those of 1%; the latter by the same command once
# more, from its own answer; and a flow curve 1 + 0.4 rate^0.5, in units u, by a + b rate^m from a = b = 1, m = 0.4. D, a and b
# are printed in units of u. Each time gnuplot says that the fit converged.
#
# Guess: the fit is the same in each unit, or it does not converge where the start is far away.
# Seen: where the numbers are small, as lengths and forces in SI are, the exponent stays near the value it has when D has come
# down: with error bars 0.98 for 0.80, plain diffusion in place of subdiffusion, and 0.38 for 0.49 in the flow curve, with an
# error bar that leaves out the truth and FIT_CONVERGED set. The same command, given twice, has the right answer.
#   u = 1: n 0.797 +- 0.002; with error bars D 0.100, n 0.799 +- 0.001, again 0.799; flow a 0.996, b 0.406, m 0.491 +- 0.014
#   u = 0.001: n 0.797 +- 0.002; with error bars D 0.100, n 0.799 +- 0.001, again 0.799; flow a 0.996, b 0.406, m 0.491 +- 0.014
#   u = 1e-06: n 0.787 +- 0.003; with error bars D 0.100, n 0.799 +- 0.001, again 0.799; flow a 0.996, b 0.406, m 0.491 +- 0.014
#   u = 1e-09: n 0.787 +- 0.003; with error bars D 0.091, n 0.984 +- 0.032, again 0.799; flow a 0.862, b 0.559, m 0.381 +- 0.022
#   u = 1e-12: n 0.787 +- 0.003; with error bars D 0.091, n 0.984 +- 0.032, again 0.799; flow a 0.862, b 0.559, m 0.381 +- 0.022
set -euo pipefail
want=5.4.4+dfsg1-2+b2
version=$(dpkg-query -W -f='${Version}' gnuplot-nox 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs gnuplot-nox $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
LC_ALL=C awk 'BEGIN { for (n = 0; n < 40; ++n) { t = 0.1 * 100 ^ (n / 39); scatter = 1 + 0.014 * sin(1.7 * n * n)
  print t, 0.4 * t ^ 0.8 * scatter, (1 + 0.4 * t ^ 0.5) * scatter } }' > curves
cat > curves.gp <<'GNUPLOT'
set fit quiet errorvariables nologfile
msd(t) = 4 * D * t**n
flow(rate) = a + b * rate**m
array units[5] = [1., 1e-3, 1e-6, 1e-9, 1e-12]
set print 'seen'
do for [i = 1:5] {
  u = units[i]
  D = 1.; n = 1.
  fit msd(x) 'curves' using 1:($2 * u) via D, n
  good = FIT_CONVERGED
  plain = sprintf("n %.3f +- %.3f", n, n_err)
  D = 1.; n = 1.
  fit msd(x) 'curves' using 1:($2 * u):(0.01 * $2 * u) yerrors via D, n
  good = good && FIT_CONVERGED
  weighted = sprintf("D %.3f, n %.3f +- %.3f", D / u, n, n_err)
  fit msd(x) 'curves' using 1:($2 * u):(0.01 * $2 * u) yerrors via D, n
  again = sprintf("%.3f", n)
  a = 1.; b = 1.; m = 0.4
  fit flow(x) 'curves' using 1:($3 * u) via a, b, m
  good = good && FIT_CONVERGED
  print sprintf("u = %g%s: %s; with error bars %s, again %s; flow a %.3f, b %.3f, m %.3f +- %.3f", u, \
    good ? "" : " (not converged)", plain, weighted, again, a / u, b / u, m, m_err)
}
GNUPLOT
LC_ALL=C gnuplot curves.gp 2> messages || { cat messages; exit 1; }
cat messages seen
diff seen - <<'SEEN'
u = 1: n 0.797 +- 0.002; with error bars D 0.100, n 0.799 +- 0.001, again 0.799; flow a 0.996, b 0.406, m 0.491 +- 0.014
u = 0.001: n 0.797 +- 0.002; with error bars D 0.100, n 0.799 +- 0.001, again 0.799; flow a 0.996, b 0.406, m 0.491 +- 0.014
u = 1e-06: n 0.787 +- 0.003; with error bars D 0.100, n 0.799 +- 0.001, again 0.799; flow a 0.996, b 0.406, m 0.491 +- 0.014
u = 1e-09: n 0.787 +- 0.003; with error bars D 0.091, n 0.984 +- 0.032, again 0.799; flow a 0.862, b 0.559, m 0.381 +- 0.022
u = 1e-12: n 0.787 +- 0.003; with error bars D 0.091, n 0.984 +- 0.032, again 0.799; flow a 0.862, b 0.559, m 0.381 +- 0.022
SEEN
