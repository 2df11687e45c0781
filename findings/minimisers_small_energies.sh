#!/usr/bin/env bash
# optim, nlm and nlminb of R 4.2.2 (Debian 12: r-base-core 4.2.2.20221110-2) and Ceres 2.1.0 (libceres-dev
# 2.1.0+really2.1.0+dfsg-1, compiled by g++), all at their defaults and with the exact gradient, nlm without it: four grains in
# a row between two that are fixed, which all overlap, of diameter s and energy k overlap^2 / 2. Printed is the largest force on a
# grain over that of an overlap of a tenth; it is 3.0 at the start and 0 in equilibrium. A question mark is put where the
# minimiser does not say success.
#
# Guess: the problem is quadratic but for contacts that open, and all tolerances are relative, so that k and s change nothing.
# Seen: at an energy scale of 1e-8 four of the six of R end with success where they began, nlminb among them, though its
# tolerances are relative: it stops by "X-convergence", as its second step is as short as the force is small. For grains
# of a micrometre with 1 N/m nlm and CG have done nothing and L-BFGS-B two thirds of the way, with success as well. Ceres stops at
# a gradient of 1e-10, whatever the units. In optim `fnscale` of the size of the energy, with a smaller `reltol`, helps.
#   k = 1, s = 1: BFGS 1.0e-05, CG 1.6e-05, L-BFGS-B 3.8e-11, Nelder-Mead 1.6e-03, nlm 1.2e-06, nlminb 4.6e-07
#   k = 0.0001, s = 1: BFGS 6.8e-03, CG 1.2e+00?, L-BFGS-B 7.6e-03, Nelder-Mead 1.6e-03, nlm 8.4e-03, nlminb 1.4e-08
#   k = 1e-08, s = 1: BFGS 3.0e+00, CG 3.0e+00, L-BFGS-B 1.4e+00, Nelder-Mead 2.5e-03, nlm 3.0e+00, nlminb 3.0e+00
#   k = 1e-12, s = 1: BFGS 3.0e+00, CG 3.0e+00, L-BFGS-B 2.9e+00, Nelder-Mead 2.1e-01, nlm 3.0e+00, nlminb 3.0e+00
#   k = 1, s = 0.001: BFGS 1.0e-05, CG 1.2e-02, L-BFGS-B 1.3e+00, Nelder-Mead 1.6e-03, nlm 1.6e-02, nlminb 4.6e-07
#   k = 1, s = 1e-06: BFGS 5.4e-03, CG 3.0e+00, L-BFGS-B 1.0e+00, Nelder-Mead 2.1e-01, nlm 3.0e+00, nlminb 4.6e-07
#   k = 1, s = 1: Ceres 9.1e-04
#   k = 1e-08, s = 1: Ceres 3.6e-02
#   k = 1e-12, s = 1: Ceres 3.0e+00
set -euo pipefail
for pair in r-base-core=4.2.2.20221110-2 libceres-dev=2.1.0+really2.1.0+dfsg-1; do
  name=${pair%%=*} want=${pair#*=}
  version=$(dpkg-query -W -f='${Version}' "$name" 2>/dev/null || true)
  [ "$version" = "$want" ] || { echo "needs $name $want, found '${version:-none}'"; exit 77; }
done
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > row.R <<'R'
for (scale in list(c(1, 1), c(1e-4, 1), c(1e-8, 1), c(1e-12, 1), c(1, 1e-3), c(1, 1e-6))) {
  k <- scale[1]
  s <- scale[2]
  start <- c(1, 1.7, 2.6, 3.4) * s
  overlaps <- function(x) pmax(0, s - diff(c(0, x, 4.5 * s)))
  energy <- function(x) k * sum(overlaps(x)^2) / 2
  gradient <- function(x) k * diff(overlaps(x))
  show <- function(name, x, success) {
    sprintf("%s %.1e%s", name, max(abs(gradient(x))) / (0.1 * k * s), if (success) "" else "?")
  }
  words <- c()
  for (method in c("BFGS", "CG", "L-BFGS-B", "Nelder-Mead")) {
    end <- optim(start, energy, if (method != "Nelder-Mead") gradient, method = method, control = list(maxit = 2000))
    words <- c(words, show(method, end$par, end$convergence == 0))
  }
  end <- nlm(energy, start)
  words <- c(words, show("nlm", end$estimate, end$code == 1))
  end <- nlminb(start, energy, gradient)
  words <- c(words, show("nlminb", end$par, end$convergence == 0))
  cat(sprintf("k = %g, s = %g: %s\n", k, s, paste(words, collapse = ", ")))
}
R
cat > row.cpp <<'CPP'
#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

struct Contact {
    double k, s;
    template <class T>
    bool operator()(const T* left, const T* right, T* answer) const {
        const T overlap = T(s) - (*right - *left);
        *answer = overlap > T(0) ? T(std::sqrt(k)) * overlap : T(0);
        return true;
    }
};

int main() {
    for (const double k : {1.0, 1e-8, 1e-12}) {
        double x[6] = {0, 1, 1.7, 2.6, 3.4, 4.5};
        ceres::Problem problem;
        for (int n = 0; n < 5; ++n)
            problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Contact, 1, 1, 1>(new Contact{k, 1}), nullptr, x + n,
                                     x + n + 1);
        problem.SetParameterBlockConstant(x);
        problem.SetParameterBlockConstant(x + 5);
        ceres::Solver::Options options;
        options.logging_type = ceres::SILENT;
        ceres::Solver::Summary summary;
        ceres::Solve(options, &problem, &summary);
        double force = 0;
        const auto overlap = [&](int n) { return std::max(0.0, 1 - (x[n + 1] - x[n])); };
        for (int n = 1; n < 5; ++n) force = std::max(force, std::abs(overlap(n) - overlap(n - 1)) / 0.1);
        const bool success = summary.termination_type == ceres::CONVERGENCE;
        std::printf("k = %g, s = 1: Ceres %.1e%s\n", k, force, success ? "" : "?");
    }
}
CPP
g++ -std=c++17 -I/usr/include/eigen3 -o row row.cpp -lceres -lglog
{ Rscript --vanilla row.R && ./row; } > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
k = 1, s = 1: BFGS 1.0e-05, CG 1.6e-05, L-BFGS-B 3.8e-11, Nelder-Mead 1.6e-03, nlm 1.2e-06, nlminb 4.6e-07
k = 0.0001, s = 1: BFGS 6.8e-03, CG 1.2e+00?, L-BFGS-B 7.6e-03, Nelder-Mead 1.6e-03, nlm 8.4e-03, nlminb 1.4e-08
k = 1e-08, s = 1: BFGS 3.0e+00, CG 3.0e+00, L-BFGS-B 1.4e+00, Nelder-Mead 2.5e-03, nlm 3.0e+00, nlminb 3.0e+00
k = 1e-12, s = 1: BFGS 3.0e+00, CG 3.0e+00, L-BFGS-B 2.9e+00, Nelder-Mead 2.1e-01, nlm 3.0e+00, nlminb 3.0e+00
k = 1, s = 0.001: BFGS 1.0e-05, CG 1.2e-02, L-BFGS-B 1.3e+00, Nelder-Mead 1.6e-03, nlm 1.6e-02, nlminb 4.6e-07
k = 1, s = 1e-06: BFGS 5.4e-03, CG 3.0e+00, L-BFGS-B 1.0e+00, Nelder-Mead 2.1e-01, nlm 3.0e+00, nlminb 4.6e-07
k = 1, s = 1: Ceres 9.1e-04
k = 1e-08, s = 1: Ceres 3.6e-02
k = 1e-12, s = 1: Ceres 3.0e+00
SEEN
