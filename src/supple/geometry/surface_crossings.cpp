#include "supple/geometry/surface_crossings.hpp"

#include <algorithm>
#include <utility>

#include "supple/geometry/box_tree.hpp"

namespace supple {

namespace {

BoxTree tree_of(const SurfaceView& surface) {
  std::vector<Extent> boxes;
  boxes.reserve(surface.face.size());
  for (const auto& [a, b, c] : surface.face) {
    Extent box{surface.vertex[a], surface.vertex[a]};
    for (const std::int32_t k : {b, c}) box.include({surface.vertex[k], surface.vertex[k]});
    boxes.push_back(box);
  }
  return BoxTree(std::move(boxes));
}

/// Collects pairs that meet.
class Meetings {
 public:
  Meetings(const SurfaceView& first, const SurfaceView& second) : first_(first), second_(second) {}

  void look_at(std::int32_t i, std::int32_t j) {
    Vec3 p[3], q[3];
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = first_.vertex[first_.face[i][k]];
      q[k] = second_.vertex[second_.face[j][k]];
    }
    if (const TriangleMeeting meeting = meeting_of(p, q); meeting != TriangleMeeting::none)
      found_.push_back({i, j, meeting});
  }
  std::vector<MeetingTriangles> sorted() && {
    std::sort(found_.begin(), found_.end(), [](const MeetingTriangles& a, const MeetingTriangles& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    return std::move(found_);
  }

 private:
  SurfaceView first_, second_;
  std::vector<MeetingTriangles> found_;
};

}  // namespace

std::vector<MeetingTriangles> self_crossings(const SurfaceView& surface) {
  Meetings meetings(surface, surface);
  tree_of(surface).for_pairs([&](std::int32_t i, std::int32_t j) { meetings.look_at(i, j); });
  return std::move(meetings).sorted();
}

std::vector<MeetingTriangles> crossings_between(const SurfaceView& first, const SurfaceView& second) {
  Meetings meetings(first, second);
  tree_of(first).for_pairs_with(tree_of(second),
                                [&](std::int32_t i, std::int32_t j) { meetings.look_at(i, j); });
  return std::move(meetings).sorted();
}

}  // namespace supple
