#!/usr/bin/env bash
# Boost.Histogram of Boost 1.74 (Debian 12: libboost1.74-dev 1.74.0+ds1-21, compiled by g++): the variance of a stress that rises
# from 0 to 20 in a time of 10, with noise of variance 1, as a profile over time and as a single mean: of all values, of two
# halves that are added, of bins of the profile that are joined (rebin, project); and the sum of the profiles of two runs, with
# a mean stress of 1 and of 3, and noise of variance 0.01.
#
# Guess: means and variances of parts that are added are those of all their values, but for the last digits.
# Seen: counts and means are. The variances are those within the parts: what the means of the parts differ by is forgotten by
# operator+= of `mean` and `weighted_mean`, and so wherever bins or histograms are joined. Two runs with 1 and 3 have a standard
# deviation of 0.1, as if they agreed, and a profile that is projected has that of its narrowest bins. No warning.
#   mean, all values at once: count 100000, mean 9.999, variance 34.355
#   mean, two halves added: count 100000, mean 9.999, variance 9.309
#   weighted_mean, all values at once: mean 9.999, variance 34.355
#   weighted_mean, two halves added: mean 9.999, variance 9.309
#   profile of one bin: count 100000, mean 9.999, variance 34.355
#   profile of ten bins, rebin(10): count 100000, mean 9.999, variance 1.332
#   profile of ten bins and one kind of grains, project on the kind: count 100000, mean 9.999, variance 1.332
#   two runs in one profile: count 20000, mean 2.002, variance 1.010
#   profiles of two runs, added: count 20000, mean 2.002, variance 0.010
set -euo pipefail
want=1.74.0+ds1-21
version=$(dpkg-query -W -f='${Version}' libboost1.74-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libboost1.74-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > spread.cpp <<'CPP'
#include <boost/histogram.hpp>

#include <cstdio>
#include <random>
#include <vector>

namespace bh = boost::histogram;

template <class Accumulator>
void show(const char* name, const Accumulator& values) {
    std::printf("%s: count %.0f, mean %.3f, variance %.3f\n", name, values.count(), values.value(), values.variance());
}

void show(const char* name, const bh::accumulators::weighted_mean<>& values) {
    std::printf("%s: mean %.3f, variance %.3f\n", name, values.value(), values.variance());
}

int main() {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 1);

    bh::accumulators::mean<> all, early, late;
    bh::accumulators::weighted_mean<> weighted, weighted_early, weighted_late;
    auto one = bh::make_profile(bh::axis::regular<>(1, 0, 10));
    auto ten = bh::make_profile(bh::axis::regular<>(10, 0, 10));
    auto kinds = bh::make_profile(bh::axis::regular<>(10, 0, 10), bh::axis::integer<>(0, 1));
    for (int n = 0; n < 100000; ++n) {
        const double time = 10 * (n + 0.5) / 100000, stress = 2 * time + noise(random);
        all(stress);
        (time < 5 ? early : late)(stress);
        weighted(bh::weight(2), stress);
        (time < 5 ? weighted_early : weighted_late)(bh::weight(2), stress);
        one(time, bh::sample(stress));
        ten(time, bh::sample(stress));
        kinds(time, 0, bh::sample(stress));
    }
    early += late;
    weighted_early += weighted_late;
    show("mean, all values at once", all);
    show("mean, two halves added", early);
    show("weighted_mean, all values at once", weighted);
    show("weighted_mean, two halves added", weighted_early);
    show("profile of one bin", one.at(0));
    show("profile of ten bins, rebin(10)", bh::algorithm::reduce(ten, bh::algorithm::rebin(10)).at(0));
    show("profile of ten bins and one kind of grains, project on the kind",
         bh::algorithm::project(kinds, std::vector<int>{1}).at(0));

    auto both = bh::make_profile(bh::axis::integer<>(0, 1)), run = both, other_run = both;
    for (int n = 0; n < 10000; ++n) {
        const double stress = 1 + 0.1 * noise(random), other_stress = 3 + 0.1 * noise(random);
        run(0, bh::sample(stress));
        other_run(0, bh::sample(other_stress));
        both(0, bh::sample(stress));
        both(0, bh::sample(other_stress));
    }
    show("two runs in one profile", both.at(0));
    run += other_run;
    show("profiles of two runs, added", run.at(0));
}
CPP
g++ -std=c++17 -o spread spread.cpp
./spread > seen
cat seen
diff seen - <<'SEEN'
mean, all values at once: count 100000, mean 9.999, variance 34.355
mean, two halves added: count 100000, mean 9.999, variance 9.309
weighted_mean, all values at once: mean 9.999, variance 34.355
weighted_mean, two halves added: mean 9.999, variance 9.309
profile of one bin: count 100000, mean 9.999, variance 34.355
profile of ten bins, rebin(10): count 100000, mean 9.999, variance 1.332
profile of ten bins and one kind of grains, project on the kind: count 100000, mean 9.999, variance 1.332
two runs in one profile: count 20000, mean 2.002, variance 1.010
profiles of two runs, added: count 20000, mean 2.002, variance 0.010
SEEN
