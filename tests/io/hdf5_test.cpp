#include <gmock/gmock.h>
#include <hdf5.h>

#include <cmath>
#include <thread>

#include "supple/core/random.hpp"
#include "supple/io/hdf5/hdf5.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple::h5 {
namespace {

using supple::testing::content_of;
using supple::testing::file_error_of;
using supple::testing::write_content;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
class Hdf5 : public supple::testing::TemporaryFolder {};

bool is_compressed(const Group& group, const std::string& name) {
  const Object dataset = group.open_dataset(name), list(H5Dget_create_plist(dataset.id()));
  unsigned int flags = 0, configuration = 0;
  std::size_t values = 0;
  return H5Pget_filter_by_id(list.id(), H5Z_FILTER_DEFLATE, &flags, &values, nullptr, 0, nullptr,
                             &configuration) >= 0;
}

TEST_F(Hdf5, ValuesAndAttributesComeBackAsTheyWere) {
  const std::string path = in_folder("a.h5");
  {
    Group root = create_file("a.h5");
    Object x = root.write<double>("x", std::vector<double>{0.1, -0.0, 1e-310, 3}, {2, 2});
    x.set("unit", std::string("µm"));
    x.set("names", std::vector<std::string>{"one", "", "three"});
    x.set("number", 0.1);
    x.set("integer", std::int64_t{1} << 60);
    root.write("bytes", std::vector<std::uint8_t>{0, 255});
    root.write("texts", std::vector<std::string>{"a", "größer"});
    root.write("none", std::vector<double>{}, {0, 3});
    root.write_scalar("long", std::string(70000, 'x'));
    save(root, path);
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
  EXPECT_EQ(root.read_scalar<std::string>("long"), std::string(70000, 'x'));
  EXPECT_THAT(root.names(), ElementsAre("x", "bytes", "texts", "none", "long")) << "in the order of creation";
}

TEST_F(Hdf5, RowsAreReadInParts) {
  Group root = create_file("a.h5");
  root.write("v", std::vector<double>{1, 2, 3, 4, 5, 6}, {3, 2});
  EXPECT_THAT(root.read_rows<double>("v", 1, 2), ElementsAre(3, 4, 5, 6));
  for (const std::uint64_t count : {std::uint64_t{2}, ~std::uint64_t{1}})
    EXPECT_THAT(file_error_of([&] { root.read_rows<double>("v", 2, count); }), HasSubstr("rows are missing"));
}

TEST_F(Hdf5, RowsOfOtherFilesAreJoinedWithTheirAttributes) {
  Group from = create_file("from.h5"), to = create_file("to.h5");
  from.write("speed", std::vector<double>{1, 2, 3, 4}, {2, 2}).set("unit", "m/s");
  from.write("large", std::vector<double>(10000, 1.5), {5000, 2});
  for (const std::string name : {"speed", "large"}) {
    const std::uint64_t rows = from.shape(name)[0];
    const Object joined = to.create_like(from, name, 2 * rows);
    from.copy_rows(name, joined, 0);
    from.copy_rows(name, joined, rows);
    EXPECT_THAT(file_error_of([&] { from.copy_rows(name, joined, rows + 1); }),
                HasSubstr("has another shape"));
  }
  EXPECT_THAT(to.read<double>("speed"), ElementsAre(1, 2, 3, 4, 1, 2, 3, 4));
  EXPECT_EQ(to.read<double>("large"), std::vector<double>(20000, 1.5));
  EXPECT_EQ(to.open_dataset("speed").text("unit"), "m/s");
}

/// Noise stays as it is, whichever way it comes into a file.
TEST_F(Hdf5, WhatDoesNotBecomeSmallerIsNotCompressed) {
  std::vector<double> noise, slow;
  for (std::uint64_t k = 0; k < 10000; ++k) {
    noise.push_back(std::pow(10, RandomStream(1, Purpose::test, k).uniform(-99, 99)));
    slow.push_back(static_cast<double>(k));
  }
  Group root = create_file("a.h5"), joined = create_file("b.h5");
  root.write("noise", noise);
  root.write("slow", slow);
  root.write("rows", noise, {10, 1000});
  for (const std::string name : {"noise", "slow", "rows"})
    root.copy_rows(name, joined.create_like(root, name, root.shape(name)[0]), 0);
  for (const Group* file : {&root, &joined}) {
    EXPECT_FALSE(is_compressed(*file, "noise"));
    EXPECT_TRUE(is_compressed(*file, "slow"));
    EXPECT_FALSE(is_compressed(*file, "rows"));
    EXPECT_EQ(file->read<double>("noise"), noise);
    EXPECT_EQ(file->read<double>("slow"), slow);
  }
}

/// What is soon merged into another file is not compressed; what stays is.
TEST_F(Hdf5, APlainFileHoldsItsNumbersAsTheyAre) {
  constexpr std::size_t bytes = 80000;
  Group compressed = create_file("compressed.h5"), plain = create_file("plain.h5", Storage::plain);
  for (Group* root : {&compressed, &plain})
    root->create_group("within").write("x", std::vector<double>(bytes / sizeof(double), 1.5));
  EXPECT_LT(bytes_of(compressed).size(), bytes / 10);
  EXPECT_GT(bytes_of(plain).size(), bytes);
  EXPECT_EQ(plain.open_group("within").read<double>("x"), compressed.read<double>("within/x"));

  plain.open_group("within").set("unit", std::string("m"));
  plain.open_group("within").write("none", std::vector<double>{});
  Group copied = create_file("copied.h5");
  copied.copy(plain, "within");
  EXPECT_LT(bytes_of(copied).size(), bytes / 10);
  EXPECT_EQ(copied.read<double>("within/x"), plain.read<double>("within/x"));
  EXPECT_EQ(copied.open_group("within").text("unit"), "m");
  EXPECT_THAT(copied.open_group("within").names(), ElementsAre("x", "none"));
}

TEST_F(Hdf5, ErrorsTellMissingForeignAndTruncatedFilesApart) {
  EXPECT_THAT(file_error_of([&] { open_file(in_folder("none.h5")); }), HasSubstr("No such file"));

  write_content(in_folder("text.h5"), "this is a text, long enough to be looked at as a file of some kind");
  EXPECT_THAT(file_error_of([&] { open_file(in_folder("text.h5")); }), HasSubstr("is not an HDF5 file"));

  write_content(in_folder("empty.h5"), "");
  EXPECT_THAT(file_error_of([&] { open_file(in_folder("empty.h5")); }),
              HasSubstr("empty.h5 is empty (it was copied in part"));
}

/// The reasons stand in our words; those of HDF5 at most in brackets at the end.
TEST_F(Hdf5, AFileThatIsCutOffIsSaidToBe) {
  Group made = create_file("whole.h5");
  made.write("x", std::vector<double>(10000, 1.5));
  save(made, in_folder("whole.h5"));
  const std::string whole = content_of(in_folder("whole.h5"));
  for (std::size_t bytes = 100; bytes < whole.size(); bytes += whole.size() / 20) {
    write_content(in_folder("cut.h5"), whole.substr(0, bytes));
    ::testing::internal::CaptureStderr();
    const std::string message = file_error_of([&] { open_file(in_folder("cut.h5")); });
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "HDF5 must not print";
    EXPECT_THAT(message,
                ::testing::StartsWith("cannot read " + in_folder("cut.h5") +
                                      " (the file ends before its own data: " + std::to_string(bytes) +
                                      " of its " + std::to_string(whole.size()) + " bytes are there); "));
    EXPECT_THAT(message, HasSubstr("copy it anew from where it was written [HDF5: truncated file"));
  }
}

TEST_F(Hdf5, WhatAFileLacksIsSaidToBeMissing) {
  Group root = create_file("a.h5");
  EXPECT_THAT(file_error_of([&] { root.read<double>("speed"); }),
              HasSubstr("cannot open speed in a.h5 (the file has no such thing); the file is damaged, or of "
                        "another version of Supple [HDF5: "));
  EXPECT_THAT(file_error_of([&] { root.open_group("frames"); }), HasSubstr("(the file has no such thing)"));
  EXPECT_THAT(file_error_of([&] { root.text("format"); }), HasSubstr("(the file has no such thing)"));
  EXPECT_FALSE(root.has("frames"));
  EXPECT_FALSE(root.has("frames/step"));
  EXPECT_FALSE(root.has_attribute("format"));
}

TEST_F(Hdf5, ErrorsNameFileAndObject) {
  Group root = create_file("a.h5");
  EXPECT_THAT(file_error_of([&] { root.read<double>("missing"); }), HasSubstr("a.h5"));
  EXPECT_THAT(file_error_of([&] { root.read<double>("missing"); }), HasSubstr("missing"));
  EXPECT_THAT(file_error_of([&] { root.text("format"); }), HasSubstr("format"));
  EXPECT_THAT(file_error_of([&] { save(root, in_folder("no/folder.h5")); }), HasSubstr("cannot create"));
}

/// HDF5 asks every thread by itself whether it prints, and a program may want it to.
TEST_F(Hdf5, PrintsNothingInAnyThreadAndLeavesThatToTheProgram) {
  write_content(in_folder("cut.h5"), "\211HDF\r\n\032\n and no more");
  H5E_auto2_t before = nullptr, after = nullptr;
  void *data = nullptr, *data_after = nullptr;
  ::testing::internal::CaptureStderr();
  std::thread([&] {
    H5Eget_auto2(H5E_DEFAULT, &before, &data);
    EXPECT_THROW(open_file(in_folder("cut.h5")), Error);
    Group root = create_file("a.h5");
    EXPECT_THROW(root.open_group("nothing"), Error);
    EXPECT_THROW(root.number("nothing"), Error);
    EXPECT_THROW(root.read<double>("nothing"), Error);
    H5Eget_auto2(H5E_DEFAULT, &after, &data_after);
  }).join();
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_NE(before, nullptr);
  EXPECT_EQ(after, before);
  EXPECT_EQ(data_after, data);
}

}  // namespace
}  // namespace supple::h5
