#include "supple/core/text_columns.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace supple {
namespace {

TEST(TextColumns, WidthCountsCharactersNotBytes) {
  EXPECT_EQ(text_width("3 \u00b1 1 \u00b5m"), 8u);
  EXPECT_EQ(text_width(""), 0u);
}

TEST(TextColumns, LinesBreakBetweenPiecesAlone) {
  EXPECT_EQ(wrap_words("one two  three\nfour", 9), (std::vector<std::string>{"one two", "three", "four"}));
  EXPECT_EQ(wrap_pieces({"a b c d", "e"}, 3), (std::vector<std::string>{"a b c d", "e"}));
  EXPECT_EQ(wrap_words("", 9), std::vector<std::string>{""});
}

TEST(TextColumns, RowsStayOnThePageAndTheirColumnsBelowEachOther) {
  const std::string words =
      "some words that explain the number and are longer than what is left of the page beside it";
  std::string all;
  for (const char* name : {"short", "a_name_of_thirty_characters_ab"})
    all += table_row({name, "3 \u00b1 1"}, {30, 24}, words);
  std::istringstream lines(all);
  int starts = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(text_width(line), page_width) << line;
    if (const auto at = line.find("some words"); at != line.npos) {
      ++starts;
      EXPECT_EQ(text_width(line.substr(0, at)), page_width - 22) << line;
    }
  }
  EXPECT_EQ(starts, 2);
  EXPECT_EQ(table_row({"a", "b"}, {4, 4}, ""), "  a     b\n");
}

TEST(TextColumns, WhatIsTooLongForItsColumnHasItsWordsBelow) {
  EXPECT_EQ(hang_words("0123456789", "word", 6), "0123456789\n      word\n");
  EXPECT_EQ(hang_words("0123", "word", 6), "0123  word\n");
}

}  // namespace
}  // namespace supple
