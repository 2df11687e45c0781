/// Student's distribution: what few values say of their mean.
#pragma once

namespace supple {

/// P(|t| < x) for a whole number of degrees of freedom > 0 [Abramowitz & Stegun 26.7.3, 26.7.4].
double student_probability(double x, int freedom);

/// Half of the x for which P(|t| < x) = 0.9545, the probability of two standard deviations of a normal
/// distribution: 6.98 for one degree of freedom, 2.26 for two, towards 1 for many. For a standard error s of
/// a mean, 2 s times this factor covers 95.45 %.
double student_factor(int freedom);

}  // namespace supple
