/// What HDF5 meets, in our words: a file that is cut off, bytes that have changed, a member that is not
/// there.
#include "supple/io/hdf5/hdf5_calls.hpp"

namespace supple::h5 {
namespace {

/// The most specific message of HDF5's error stack.
std::string reason() {
  std::string text;
  const auto keep_first = [](unsigned n, const H5E_error2_t* error, void* out) -> herr_t {
    if (n == 0 && error->desc) *static_cast<std::string*>(out) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &text);
  return text;
}

bool says(const std::string& text, const char* word) { return text.find(word) != text.npos; }

/// "its first 1200 of 110447 bytes are there", from HDF5's "eof = 1200, ..., stored_eof = 110447".
std::string how_much(const std::string& text) {
  const auto number_behind = [&](const std::string& name) -> std::string {
    const auto at = text.find(name);
    if (at == text.npos) return "";
    const auto begin = at + name.size();
    return text.substr(begin, text.find_first_not_of("0123456789", begin) - begin);
  };
  const std::string there = number_behind(": eof = "), all = number_behind("stored_eof = ");
  if (there.empty() || all.empty()) return "";
  return ": " + there + " of its " + all + " bytes are there";
}

/// Why and what to do, by what HDF5 says.
struct Fault {
  std::string why, to_do;
};

Fault fault_of(const std::string& said) {
  const std::string copy_again = "copy it anew from where it was written";
  if (says(said, "truncated file"))
    return {"the file ends before its own data" + how_much(said),
            "it was copied in part, or what copied it was stopped: " + copy_again};
  if (says(said, "doesn't exist") || says(said, "can't locate attribute"))
    return {"the file has no such thing", "the file is damaged, or of another version of Supple"};
  if (says(said, "checksum"))
    return {"its bytes are not those that were written: the checksum differs",
            "the file is damaged: " + copy_again};
  if (says(said, "memory")) return {"there is not enough memory", ""};
  return {"it makes no sense as HDF5", "the file is damaged: " + copy_again};
}

Error error_after(const std::string& said, const std::string& action, const std::string& where) {
  const Fault f = fault_of(said);
  const std::string quote = said.empty() ? "" : " [HDF5: " + said + "]";
  return file_error("cannot " + action + " " + where, f.why, f.to_do + quote);
}

}  // namespace

Quiet::Quiet() : known_(H5Eget_auto2(H5E_DEFAULT, &print_, &data_) >= 0) {
  if (known_) H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Quiet::~Quiet() {
  if (known_) H5Eset_auto2(H5E_DEFAULT, print_, data_);
}

Error fault(const std::string& action, const std::string& where) {
  return error_after(reason(), action, where);
}

Error fault(const std::string& action, const Object& at) {
  const std::string said = reason();
  return error_after(said, action, at.where());
}

}  // namespace supple::h5
