/// Forces that threads have found, added as one thread would have added them.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "supple/core/parallel.hpp"

namespace supple {

/// What the chunks of a loop over contacts found. Each thread then adds what acts on its own stretch of
/// sites: chunk after chunk, so that each site adds up its contacts in the order of the loop in one thread,
/// with the same bits. Each chunk has a list for each stretch: cores that are far apart exchange only what
/// concerns both.
template <class Push>
class Pushes {
 public:
  /// Empty lists for a loop of this many chunks over contacts of this many sites.
  void begin(std::int64_t chunks, std::int64_t sites) {
    stretches_ = thread_count();
    lists_.resize(static_cast<std::size_t>(chunks * stretches_));
    for (std::vector<Push>& list : lists_) list.clear();
    const std::int64_t pieces = chunk_count(sites);
    stretch_.resize(static_cast<std::size_t>(pieces));
    for (std::int64_t k = 0; k < pieces; ++k)
      stretch_[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(k * stretches_ / pieces);
  }

  /// Keeps what acts on these sites.
  template <std::size_t n>
  void keep(std::int64_t chunk, const Push& push, const std::array<std::int32_t, n>& sites) {
    std::vector<Push>* lists = &lists_[static_cast<std::size_t>(chunk * stretches_)];
    for (std::size_t k = 0; k < n; ++k) {
      const std::int32_t stretch = stretch_of(sites[k]);
      bool is_there = false;
      for (std::size_t before = 0; before < k; ++before) is_there |= stretch_of(sites[before]) == stretch;
      if (!is_there) lists[stretch].push_back(push);
    }
  }

  /// add(push, here) for what acts on each stretch: `here(site)` is whether the site is part of it.
  template <class Add>
  void add(const Add& add) const {
    for_each_thread([&](std::int64_t stretch) {
      const auto here = [&](std::int32_t site) { return stretch_of(site) == stretch; };
      for (auto k = static_cast<std::size_t>(stretch); k < lists_.size();
           k += static_cast<std::size_t>(stretches_))
        for (const Push& push : lists_[k]) add(push, here);
    });
  }

 private:
  std::int32_t stretch_of(std::int32_t site) const {
    return stretch_[static_cast<std::size_t>(site / static_cast<std::int32_t>(chunk_size))];
  }

  std::int64_t stretches_ = 1;
  std::vector<std::vector<Push>> lists_;  ///< of each stretch, of each chunk
  std::vector<std::int32_t> stretch_;     ///< of each chunk of sites
};

}  // namespace supple
