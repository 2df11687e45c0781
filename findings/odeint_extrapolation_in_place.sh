#!/usr/bin/env bash
# Boost.odeint 1.74 (Debian 12: libboost1.74-dev 1.74.0+ds1-21, compiled by g++): a stress that relaxes with time 1, from 1 to
# exp(-1) = 0.367879, by adams_bashforth<ORDER>, which makes its first steps by extrapolation_stepper<ORDER>.
#
# Guess: the error goes with the step to the power of the order.
# Seen: it goes with the step, at every order, and more of it the higher the order is. The stepper of the first steps, also on its
# own, is wrong where state and result are one vector, as they are in integrate_const, integrate_n_steps and
# do_step(system, x, t, dt): it keeps halfway results in the result and goes on from there. No error or warning. Into another
# vector, with runge_kutta4 for the first steps, or by adams_bashforth_moulton all is as it should be.
#   extrapolation_stepper, one step of 0.1: 0.788638 in place, 0.904837 into another vector, true 0.904837
#   adams_bashforth, order 4: 0.244186 in 10 steps, 0.300392 in 20, 0.332649 in 40
#   adams_bashforth, order 8: 0.006852 in 10 steps, 0.018815 in 20, 0.065949 in 40
#   order 4, first by runge_kutta4: 0.367890 in 10 steps, 0.367880 in 20, 0.367879 in 40
#   adams_bashforth_moulton, order 4: 0.367878 in 10 steps, 0.367879 in 20, 0.367879 in 40
set -euo pipefail
want=1.74.0+ds1-21
version=$(dpkg-query -W -f='${Version}' libboost1.74-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libboost1.74-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > relax.cpp <<'CPP'
#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/stepper/extrapolation_stepper.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

namespace odeint = boost::numeric::odeint;
using State = std::vector<double>;

void relax(const State& stress, State& rate, double) { rate[0] = -stress[0]; }

template <class Stepper>
double end(int steps) {
    State stress{1};
    odeint::integrate_n_steps(Stepper(), relax, stress, 0.0, 1.0 / steps, steps);
    return stress[0];
}

template <class Stepper>
void show(const char* name) {
    std::printf("%s: %.6f in 10 steps, %.6f in 20, %.6f in 40\n", name, end<Stepper>(10), end<Stepper>(20), end<Stepper>(40));
}

int main() {
    odeint::extrapolation_stepper<4, State> first;
    State one{1}, other(1);
    first.do_step(relax, one, 0.0, other, 0.1);
    first.do_step(relax, one, 0.0, 0.1);
    std::printf("extrapolation_stepper, one step of 0.1: %.6f in place, %.6f into another vector, true %.6f\n", one[0], other[0],
                std::exp(-0.1));
    show<odeint::adams_bashforth<4, State>>("adams_bashforth, order 4");
    show<odeint::adams_bashforth<8, State>>("adams_bashforth, order 8");
    show<odeint::adams_bashforth<4, State, double, State, double, odeint::range_algebra, odeint::default_operations,
                                 odeint::initially_resizer, odeint::runge_kutta4<State>>>("order 4, first by runge_kutta4");
    show<odeint::adams_bashforth_moulton<4, State>>("adams_bashforth_moulton, order 4");
}
CPP
g++ -std=c++17 -o relax relax.cpp
./relax > seen
cat seen
diff seen - <<'SEEN'
extrapolation_stepper, one step of 0.1: 0.788638 in place, 0.904837 into another vector, true 0.904837
adams_bashforth, order 4: 0.244186 in 10 steps, 0.300392 in 20, 0.332649 in 40
adams_bashforth, order 8: 0.006852 in 10 steps, 0.018815 in 20, 0.065949 in 40
order 4, first by runge_kutta4: 0.367890 in 10 steps, 0.367880 in 20, 0.367879 in 40
adams_bashforth_moulton, order 4: 0.367878 in 10 steps, 0.367879 in 20, 0.367879 in 40
SEEN
