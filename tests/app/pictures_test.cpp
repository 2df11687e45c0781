#include <gmock/gmock.h>

#include "tests/app/command.hpp"
#include "tests/paths.hpp"

namespace supple {
namespace {

class DrawnPictures : public CommandTest {
 protected:
  void die_when_drawing() {
#ifdef __SANITIZE_ADDRESS__
    const std::string sanitized = "ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0 ";
#else
    const std::string sanitized;
#endif
    set_prefix(sanitized + "LD_PRELOAD='" SUPPLE_DIE_AT "' DIE_DRAWING=1 ");
  }
};

TEST_F(DrawnPictures, NoneIsBegunUnasked) {
  write_small_case();
  die_when_drawing();
  EXPECT_EQ(supple("run small.toml --set output.plot=false --set output.snapshot=false").code, 0);
  EXPECT_EQ(supple("show small.h5").code, 0);
  EXPECT_EQ(supple("export small.h5 --to csv").code, 0);
  for (const std::string asked : {"output.plot=true", "output.snapshot=true", "output.images=1"})
    EXPECT_NE(supple("run small.toml --force --set " + asked).code, 0) << asked;
}

/// The figure and the cell have a mark of their case, which says how many threads.
TEST_F(DrawnPictures, HaveTheSameBytesEachTime) {
  write_small_case();
  const std::string asked = " --set output.plot=true --set output.snapshot=true --set output.images=3";
  ASSERT_EQ(supple("run small.toml -o a.h5" + asked).code, 0);
  ASSERT_EQ(supple("run small.toml -o b.h5" + asked).code, 0);
  ASSERT_EQ(supple("run small.toml -o c.h5 --threads 2" + asked).code, 0);
  const auto same = [&](const std::string& one, const std::string& other) {
    EXPECT_GT(read_text(path(one)).size(), 1000u) << one;
    EXPECT_TRUE(read_text(path(one)) == read_text(path(other))) << other;
  };
  for (const std::string name : {"_stress.png", "_cell.png"}) same("a" + name, "b" + name);
  for (const std::string name : {"_images/image0000000.png", "_images/image0000002.png"}) {
    same("a" + name, "b" + name);
    same("a" + name, "c" + name);
  }
}

}  // namespace
}  // namespace supple
