/// An object behind a pointer that is copied with its owner.
#pragma once
#include <memory>
#include <utility>

namespace supple {

/// Owns a T, of a class derived from it where T has clone(), or nothing. A copy has its own object.
template <class T>
class Owned {
 public:
  Owned() = default;
  Owned(std::unique_ptr<T> object) : object_(std::move(object)) {}  // NOLINT: it is the object
  Owned(const Owned& other) : object_(other.object_ ? copy_of(*other.object_) : nullptr) {}
  Owned(Owned&&) noexcept = default;
  Owned& operator=(Owned other) noexcept {
    object_ = std::move(other.object_);
    return *this;
  }

  explicit operator bool() const { return object_ != nullptr; }
  T& operator*() const { return *object_; }
  T* operator->() const { return object_.get(); }
  T* get() const { return object_.get(); }

 private:
  static std::unique_ptr<T> copy_of(const T& object) {
    if constexpr (requires { object.clone(); }) return object.clone();
    else return std::make_unique<T>(object);
  }

  std::unique_ptr<T> object_;
};

}  // namespace supple
