#include "tests/support/term_check.hpp"

#include <gtest/gtest-spi.h>

#include <string>

namespace supple {
namespace {

/// Terms that are wrong in one way each: the shared check must see every one of them.
struct Spring {
  static constexpr std::string_view name = "spring";
  static constexpr int arity = 2;
  struct Param {
    double stiffness;
  };
  template <class S>
  static S energy(const VecOf<S, 2> (&x)[2], const Param& p) {
    const VecOf<S, 2> r = x[1] - x[0];
    return 0.5 * p.stiffness * dot(r, r);
  }
};
struct WrongGradient : Spring {
  static double gradient(const Vec2 (&x)[2], const Param& p, Vec2 (&g)[2]) {
    g[1] = 1.01 * p.stiffness * (x[1] - x[0]);
    g[0] = -g[1];
    return energy(x, p);
  }
};
struct TiedToTheOrigin : Spring {
  template <class S>
  static S energy(const VecOf<S, 2> (&x)[2], const Param& p) {
    return 0.5 * p.stiffness * dot(x[0], x[0]);
  }
};
struct PrefersADirection : Spring {
  template <class S>
  static S energy(const VecOf<S, 2> (&x)[2], const Param& p) {
    const S along = x[1][0] - x[0][0];
    return 0.5 * p.stiffness * along * along;
  }
};
struct NoForce : Spring {
  template <class S>
  static S energy(const VecOf<S, 2> (&x)[2], const Param& p) {
    return 0.0 * x[0][0];
  }
};

void draw(RandomStream& stream, Vec2 (&x)[2], Spring::Param& p) {
  testing::draw_points(stream, x);
  p.stiffness = stream.uniform(1, 2);
}

/// Messages of the failures that the check reports for a term.
template <class Term>
std::string failures_of() {
  ::testing::TestPartResultArray results;
  {
    ::testing::ScopedFakeTestPartResultReporter reporter(
        ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    testing::TermCheck<Term, 2>(draw, 2).run();
  }
  std::string all;
  for (int k = 0; k < results.size(); ++k) all += results.GetTestPartResult(k).message();
  return all;
}

TEST(TermCheck, AcceptsARightTerm) { EXPECT_EQ(failures_of<Spring>(), ""); }

TEST(TermCheck, SeesEveryKindOfWrongTerm) {
  const auto expect = [](const std::string& failures, const char* what) {
    EXPECT_NE(failures.find(what), std::string::npos) << what << " not in: " << failures;
  };
  expect(failures_of<WrongGradient>(), "hand-written gradient");
  expect(failures_of<WrongGradient>(), "gradient, coordinate 0");
  expect(failures_of<TiedToTheOrigin>(), "net force");
  expect(failures_of<TiedToTheOrigin>(), "rigid motion");
  expect(failures_of<PrefersADirection>(), "net torque");
  expect(failures_of<NoForce>(), "nothing was checked");
}

}  // namespace
}  // namespace supple
