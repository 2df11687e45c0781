#!/usr/bin/env bash
# Boost.Random 1.74 (Debian 12: libboost1.74-dev 1.74.0+ds1-21) and GSL 2.7.1 (libgsl-dev 2.7.1+dfsg-5+deb12u1): an ensemble with
# the seeds 1 to 1000, numbers 21 to 26 of each stream.
#
# Guess: a thousand streams that have nothing to do with each other.
# Seen: taus88 drops the last bit of its seed, so that the seeds 2k and 2k + 1 are one stream, from its first number on. Half of
# the ensemble is counted twice, and error bars come out too small by the root of two. uni32 of GSL pairs 2k - 1 with 2k, ranf is
# like taus88, and slatec has eight streams in all. With lagged_fibonacci607, ecuyer1988 and ran3 the numbers of three seeds in a
# row are evenly spaced, modulo 1, like those of a bare linear congruence: seed 12 is known from 10 and 11. Nothing says so. Use
# mt19937, or seeds that are drawn themselves, and compare a few streams.
#   boost taus88: 500 streams, seed 42 is seed 43; off even spacing by 0.5
#   boost lagged_fibonacci607: 1000 streams; off even spacing by 8e-06
#   boost ecuyer1988: 1000 streams; off even spacing by 8e-08
#   boost mt19937: 1000 streams; off even spacing by 0.5
#   gsl slatec: 8 streams; off even spacing by 0
#   gsl uni32: 500 streams; off even spacing by 0.5
#   gsl ranf: 501 streams, seed 42 is seed 43; off even spacing by 0.4
#   gsl ran3: 1000 streams; off even spacing by 1e-16
#   gsl mt19937: 1000 streams; off even spacing by 0.5
set -euo pipefail
for wanted in libboost1.74-dev=1.74.0+ds1-21 libgsl-dev=2.7.1+dfsg-5+deb12u1; do
  version=$(dpkg-query -W -f='${Version}' "${wanted%%=*}" 2>/dev/null || true)
  [ "$version" = "${wanted#*=}" ] || { echo "needs ${wanted%%=*} ${wanted#*=}, found '${version:-none}'"; exit 77; }
done
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > seeds.cpp <<'CPP'
#include <algorithm>
#include <boost/random.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <gsl/gsl_rng.h>
#include <set>
#include <vector>

using Numbers = std::vector<double>;  // the first 26 of a stream

void look(const char* name, const std::function<Numbers(unsigned)>& numbers) {
  std::set<Numbers> streams;
  for (unsigned seed = 1; seed <= 1000; ++seed) streams.insert(numbers(seed));
  double uneven = 0;
  for (int k = 20; k < 26; ++k) {
    double second = numbers(12)[k] - 2 * numbers(11)[k] + numbers(10)[k];
    uneven = std::max(uneven, std::abs(second - std::round(second)));
  }
  std::printf("%s: %zu streams%s; off even spacing by %.0g\n", name, streams.size(),
              numbers(42) == numbers(43) ? ", seed 42 is seed 43" : "", uneven);
}

template <class Generator> void look_boost(const char* name) {
  look(name, [](unsigned seed) {
    Generator generator(seed);
    boost::random::uniform_01<double> uniform;
    Numbers all(26);
    for (double& number : all) number = uniform(generator);
    return all;
  });
}

void look_gsl(const char* name, const gsl_rng_type* type) {
  look(name, [type](unsigned seed) {
    gsl_rng* generator = gsl_rng_alloc(type);
    gsl_rng_set(generator, seed);
    Numbers all(26);
    for (double& number : all) number = gsl_rng_uniform(generator);
    gsl_rng_free(generator);
    return all;
  });
}

int main() {
  look_boost<boost::random::taus88>("boost taus88");
  look_boost<boost::random::lagged_fibonacci607>("boost lagged_fibonacci607");
  look_boost<boost::random::ecuyer1988>("boost ecuyer1988");
  look_boost<boost::random::mt19937>("boost mt19937");
  look_gsl("gsl slatec", gsl_rng_slatec);
  look_gsl("gsl uni32", gsl_rng_uni32);
  look_gsl("gsl ranf", gsl_rng_ranf);
  look_gsl("gsl ran3", gsl_rng_ran3);
  look_gsl("gsl mt19937", gsl_rng_mt19937);
}
CPP
g++ -std=c++17 -O0 -w seeds.cpp -o seeds -lgsl -lgslcblas
./seeds > seen
cat seen
diff seen - <<'SEEN'
boost taus88: 500 streams, seed 42 is seed 43; off even spacing by 0.5
boost lagged_fibonacci607: 1000 streams; off even spacing by 8e-06
boost ecuyer1988: 1000 streams; off even spacing by 8e-08
boost mt19937: 1000 streams; off even spacing by 0.5
gsl slatec: 8 streams; off even spacing by 0
gsl uni32: 500 streams; off even spacing by 0.5
gsl ranf: 501 streams, seed 42 is seed 43; off even spacing by 0.4
gsl ran3: 1000 streams; off even spacing by 1e-16
gsl mt19937: 1000 streams; off even spacing by 0.5
SEEN
