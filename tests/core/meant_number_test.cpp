#include "supple/core/meant_number.hpp"

#include <gtest/gtest.h>

namespace supple {
namespace {

TEST(MeantNumber, IsSpeltAsCasesSpellIt) {
  const std::pair<const char*, const char*> cases[] = {{"0.2", "0.2"},
                                                       {".1", "0.1"},
                                                       {"-.5", "-0.5"},
                                                       {"1.", "1.0"},
                                                       {"+3", "3"},
                                                       {"010", "10"},
                                                       {"0,2", "0.2"},
                                                       {" 1,5e-3 ", "1.5e-3"},
                                                       {"1e+6", "1e6"},
                                                       {"\u22120.2", "-0.2"},
                                                       {"0", "0"},
                                                       {"00.5", "0.5"},
                                                       {"1,000", "1.000 or 1000"},
                                                       {"-12,345", "-12.345 or -12345"},
                                                       {"0,125", "0.125"}};
  for (const auto& [text, number] : cases) EXPECT_EQ(meant_number(text), number) << text;
}

TEST(MeantNumber, IsNoneWhereTheTextIsNoNumber) {
  for (const char* text :
       {"", ".", "-", "e5", "1e", "1.2.3", "1,2,3", "0x10", "nan", "5 um", "twenty", "1 2"})
    EXPECT_EQ(meant_number(text), std::nullopt) << text;
}

}  // namespace
}  // namespace supple
