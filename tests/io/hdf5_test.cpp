#include <gmock/gmock.h>

#include "supple/io/hdf5.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple::h5 {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using supple::testing::content_of;
using supple::testing::file_error_of;
using supple::testing::write_content;
class Hdf5 : public supple::testing::TemporaryFolder {};

TEST_F(Hdf5, ValuesAndAttributesComeBackAsTheyWere) {
  const std::string path = in_folder("a.h5");
  {
    Group root = create_file(path);
    Object x = root.write<double>("x", std::vector<double>{0.1, -0.0, 1e-310, 3}, {2, 2});
    x.set("unit", std::string("µm"));
    x.set("names", std::vector<std::string>{"one", "", "three"});
    x.set("number", 0.1);
    x.set("integer", std::int64_t{1} << 60);
    root.write("bytes", std::vector<std::uint8_t>{0, 255});
    root.write("texts", std::vector<std::string>{"a", "größer"});
    root.write("none", std::vector<double>{}, {0, 3});
  }
  const Group root = open_file(path);
  const auto x = root.read<double>("x");
  EXPECT_THAT(x, ElementsAre(0.1, 0.0, 1e-310, 3));
  EXPECT_TRUE(std::signbit(x[1]));
  EXPECT_THAT(root.shape("x"), ElementsAre(2, 2));
  EXPECT_EQ(root.open_dataset("x").text("unit"), "µm");
  EXPECT_THAT(root.open_dataset("x").texts("names"), ElementsAre("one", "", "three"));
  EXPECT_EQ(root.open_dataset("x").number("number"), 0.1);
  EXPECT_EQ(root.open_dataset("x").integer("integer"), std::int64_t{1} << 60);
  EXPECT_THAT(root.read<std::uint8_t>("bytes"), ElementsAre(0, 255));
  EXPECT_THAT(root.read<std::string>("texts"), ElementsAre("a", "größer"));
  EXPECT_THAT(root.shape("none"), ElementsAre(0, 3));
  EXPECT_THAT(root.names(), ElementsAre("x", "bytes", "texts", "none")) << "in the order of creation";
}

TEST_F(Hdf5, RowsGrowAndAreReadInParts) {
  Group root = create_file(in_folder("a.h5"));
  root.create_rows<double>("v", {2});
  root.append_rows("v", std::vector<double>{1, 2});
  root.append_rows("v", std::vector<double>{});
  root.append_rows("v", std::vector<double>{3, 4, 5, 6});
  EXPECT_THAT(root.shape("v"), ElementsAre(3, 2));
  EXPECT_THAT(root.read_rows<double>("v", 1, 2), ElementsAre(3, 4, 5, 6));
  EXPECT_THAT(file_error_of([&] { root.read_rows<double>("v", 2, 2); }), HasSubstr("rows are missing"));
}

TEST_F(Hdf5, RowsOfAnotherFileAreAppendedWithTheirAttributes) {
  Group from = create_file(in_folder("from.h5")), to = create_file(in_folder("to.h5"));
  from.create_rows<std::string>("warnings").set("unit", std::string("none"));
  from.append_rows("warnings", std::vector<std::string>{"first", "second"});
  to.create_rows_like(from, "warnings");
  to.append_rows_of(from, "warnings");
  to.append_rows_of(from, "warnings");
  EXPECT_THAT(to.read<std::string>("warnings"), ElementsAre("first", "second", "first", "second"));
  EXPECT_EQ(to.open_dataset("warnings").text("unit"), "none");
}

TEST_F(Hdf5, ErrorsTellMissingForeignAndTruncatedFilesApart) {
  EXPECT_THAT(file_error_of([&] { open_file(in_folder("none.h5")); }), HasSubstr("No such file"));

  write_content(in_folder("text.h5"), "this is a text, long enough to be looked at as a file of some kind");
  EXPECT_THAT(file_error_of([&] { open_file(in_folder("text.h5")); }), HasSubstr("is not an HDF5 file"));

  { create_file(in_folder("whole.h5")).write("x", std::vector<double>(10000, 1.5)); }
  const std::string whole = content_of(in_folder("whole.h5"));
  write_content(in_folder("cut.h5"), whole.substr(0, whole.size() / 2));
  ::testing::internal::CaptureStderr();
  const std::string message = file_error_of([&] { open_file(in_folder("cut.h5")); });
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "HDF5 must not print";
  EXPECT_THAT(message, HasSubstr("cut.h5"));
  EXPECT_THAT(message, HasSubstr("truncated"));
}

TEST_F(Hdf5, ErrorsNameFileAndObject) {
  const Group root = create_file(in_folder("a.h5"));
  EXPECT_THAT(file_error_of([&] { root.read<double>("missing"); }), HasSubstr("a.h5"));
  EXPECT_THAT(file_error_of([&] { root.read<double>("missing"); }), HasSubstr("missing"));
  EXPECT_THAT(file_error_of([&] { root.text("format"); }), HasSubstr("format"));
  EXPECT_THAT(file_error_of([&] { create_file(in_folder("no/folder.h5")); }), HasSubstr("cannot create"));
}

}  // namespace
}  // namespace supple::h5
