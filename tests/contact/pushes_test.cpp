#include "supple/contact/pushes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/random.hpp"

namespace supple {
namespace {

struct Pull {
  std::int32_t first, second, third;
  double size;
};

/// Numbers of very different size: each site that added them in another order would get other bits.
std::vector<Pull> random_pulls(std::int32_t sites) {
  std::vector<Pull> pulls;
  for (std::int32_t i = 0; i < 4 * sites; ++i) {
    RandomStream draw(1, Purpose::test, static_cast<std::uint64_t>(i));
    const auto site = [&] { return static_cast<std::int32_t>(draw.uniform(0, sites)); };
    pulls.push_back({site(), site(), site(), std::pow(10, draw.uniform(-9, 9))});
  }
  return pulls;
}

TEST(Pushes, AddTheBitsOfOneThreadOnEverySite) {
  constexpr std::int32_t sites = 3000;
  const std::vector<Pull> pulls = random_pulls(sites);
  std::vector<double> expected(sites, 0);
  for (const Pull& p : pulls) {
    expected[p.first] += p.size;
    expected[p.second] -= 0.7 * p.size;
    expected[p.third] += 0.3 * p.size;
  }
  Pushes<Pull> pushes;
  for (const int threads : {2, 3, 7, 2}) {  // and what is left of the loop before is gone
    const WithThreads some(threads);
    const auto n = static_cast<std::int64_t>(pulls.size());
    pushes.begin(chunk_count(n), sites);
    for_chunks(n, [&](std::int64_t chunk, std::int64_t begin, std::int64_t end) {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
        pushes.keep(chunk, pulls[k], std::array{pulls[k].first, pulls[k].second, pulls[k].third});
    });
    std::vector<double> sum(sites, 0);
    pushes.add([&](const Pull& p, const auto& here) {
      if (here(p.first)) sum[p.first] += p.size;
      if (here(p.second)) sum[p.second] -= 0.7 * p.size;
      if (here(p.third)) sum[p.third] += 0.3 * p.size;
    });
    EXPECT_EQ(sum, expected) << threads;
  }
}

}  // namespace
}  // namespace supple
