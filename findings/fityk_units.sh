#!/usr/bin/env bash
# fityk 1.3.2 (Debian 12: fityk 1.3.2-2+b2), its program cfityk: a straight line through eight stresses over strain, two columns of
# text without error bars, in Pa, kPa and MPa.
#
# Guess: one and the same line, up to the unit, that of least squares: slope 1015.5 Pa.
# Seen: each point is given the error bar sqrt(y), or 1 where y is below 1, as if the stress were a number of counted photons. The
# large stresses count less, how much less depends on the unit, and only where all are below 1, as in MPa, the line is that of
# least squares. The message "Set as sqrt(y)" says so. Its error bars, too, depend on the unit. `S = 1` gives all the same weight.
#   in Pa: slope 1024.4 +- 36.8 Pa
#   in kPa: slope 1023.3 +- 37.3 Pa
#   in MPa: slope 1015.5 +- 44.0 Pa
#   in Pa, S = 1: slope 1015.5 +- 44.0 Pa
#   in kPa, S = 1: slope 1015.5 +- 44.0 Pa
set -euo pipefail
want=1.3.2-2+b2
version=$(dpkg-query -W -f='${Version}' fityk 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs fityk $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
export QT_QPA_PLATFORM=offscreen
fit() { # UNIT, VALUE OF IT IN Pa, MORE COMMANDS
  printf '%s\n' '1 900' '2 2200' '3 2900' '4 4300' '5 4800' '6 6400' '7 6700' '8 8300' \
    | awk -v unit="$2" '{ printf "%d %.10g\n", $1, $2 / unit }' > stress.txt
  printf '%s\n' "@0 < 'stress.txt:1:2::'" "${3:-}" 'guess Linear' fit 'info errors' > line.fit
  cfityk line.fit < /dev/null 2>&1 | awk -v unit="$1" -v value="$2" -v more="${3:-}" '
    $1 == "$_2" { printf "in %s%s: slope %.1f +- %.1f Pa\n", unit, more == "" ? "" : ", " more, $3 * value, $5 * value }'
}
{ fit Pa 1; fit kPa 1000; fit MPa 1000000; fit Pa 1 'S = 1'; fit kPa 1000 'S = 1'; } > seen
cat seen
diff seen - <<'SEEN'
in Pa: slope 1024.4 +- 36.8 Pa
in kPa: slope 1023.3 +- 37.3 Pa
in MPa: slope 1015.5 +- 44.0 Pa
in Pa, S = 1: slope 1015.5 +- 44.0 Pa
in kPa, S = 1: slope 1015.5 +- 44.0 Pa
SEEN
