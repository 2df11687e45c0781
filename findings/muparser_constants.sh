#!/usr/bin/env bash
# muParser 2.3.3 (Debian 12: libmuparser-dev 2.3.3-0.1, compiled by g++): expressions with numbers in them, as given for a drive
# or a profile.
#
# Guess: _pi is pi to the last bit, and 0.5 is true in `x && 0.5` and in `0.5 && 0.7` alike.
# Seen: _pi has twelve decimals (3.141592653589): sin(_pi) is 8e-13, and a drive cos(2*_pi*t) is behind by a turn's 2e-13 each
# period; _e is right. Numbers on both sides of && or || are cut to integers before they are combined, a variable is not: the
# value of an expression changes when a variable is replaced by its number. acos(-1) is pi.
#   _pi - pi = -7.93e-13
#   _e - e = 0
#   x && 0.5 = 1, with x = 0.5
#   0.5 && 0.5 = 0
#   0.5 || 0 = 0
#   x || 0 = 1, with x = 0.5
set -euo pipefail
want=2.3.3-0.1
version=$(dpkg-query -W -f='${Version}' libmuparser-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libmuparser-dev $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > values.cpp <<'CPP'
#include <muParser.h>

#include <cmath>
#include <cstdio>

double value(const char* expression) {
  double x = 0.5;
  mu::Parser parser;
  parser.DefineVar("x", &x);
  parser.SetExpr(expression);
  return parser.Eval();
}

int main() {
  std::printf("_pi - pi = %.3g\n_e - e = %.3g\n", value("_pi") - std::acos(-1.0), value("_e") - std::exp(1.0));
  for (const char* expression : {"x && 0.5", "0.5 && 0.5", "0.5 || 0", "x || 0"})
    std::printf("%s = %g%s\n", expression, value(expression), *expression == 'x' ? ", with x = 0.5" : "");
}
CPP
g++ values.cpp -o values -lmuparser
./values > seen
cat seen
diff seen - <<'SEEN'
_pi - pi = -7.93e-13
_e - e = 0
x && 0.5 = 1, with x = 0.5
0.5 && 0.5 = 0
0.5 || 0 = 0
x || 0 = 1, with x = 0.5
SEEN
