#include "supple/draw/scene/cell_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "supple/model/evaluation.hpp"

namespace supple {

namespace {

/// Cuts the outline by the line normal . (x - origin) = offset and keeps the side below [Sutherland & Hodgman
/// 1974].
void cut_outline(SceneDisc& disc, const Vec2& normal, double offset, std::int32_t beyond) {
  std::vector<Vec2> kept;
  std::vector<std::int32_t> across;
  const std::size_t n = disc.outline.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 a = disc.outline[k], b = disc.outline[(k + 1) % n];
    const double above_a = dot(normal, a - disc.centre) - offset,
                 above_b = dot(normal, b - disc.centre) - offset;
    if (above_a <= 0) {
      kept.push_back(a);
      across.push_back(disc.across[k]);
    }
    if ((above_a <= 0) != (above_b <= 0)) {
      kept.push_back(a + (above_a / (above_a - above_b)) * (b - a));
      across.push_back(above_a <= 0 ? beyond : disc.across[k]);
    }
  }
  disc.outline = std::move(kept);
  disc.across = std::move(across);
}

void start_circle(SceneDisc& disc, double radius, int points) {
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * k / points;
    disc.outline.push_back(disc.centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  disc.across.assign(disc.outline.size(), -1);
}

/// Flattens every disc against those that it overlaps; radical line at (d^2 + r_i^2 - r_j^2) / (2 d) from i.
void flatten(std::vector<SceneDisc>& discs, std::span<const double> radius) {
  const double reach = 2 * *std::max_element(radius.begin(), radius.end());
  std::vector<std::size_t> order(discs.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return discs[a].centre[0] < discs[b].centre[0]; });
  for (std::size_t s = 0; s < order.size(); ++s)
    for (std::size_t t = s + 1; t < order.size(); ++t) {
      SceneDisc &a = discs[order[s]], &b = discs[order[t]];
      const Vec2 r = b.centre - a.centre;
      if (r[0] > reach) break;
      const double d = norm(r), ra = radius[a.site], rb = radius[b.site];
      if (d >= ra + rb || d == 0) continue;
      const double from_a = (d * d + ra * ra - rb * rb) / (2 * d);
      cut_outline(a, (1 / d) * r, from_a, b.site);
      cut_outline(b, (-1 / d) * r, d - from_a, a.site);
    }
}

/// Vector from the first disc of a contact to the image of the second that it is about. That is the nearest
/// one, but a link that has become longer than half the cell keeps its own: the one along which its force has
/// the parts of the row.
Vec2 contact_arm(const Box<2>& box, const Vec2& from, const Vec2& to, const ContactRow& row) {
  const Vec2 nearest = box.displacement(from, to);
  if (row.state != ContactState::permanent) return nearest;
  const auto mismatch = [&](const Vec2& arm) {
    return norm(force_on_first(row.normal_force, row.tangential_force, (1 / norm(arm)) * arm) - row.force);
  };
  constexpr double rounding = 1e-6;
  Vec2 best = nearest;
  double least = mismatch(nearest) - rounding * norm(row.force);
  if (!(least > 0) || row.force == Vec2{}) return nearest;
  for (const Vec2& shift : neighbour_cells(box))
    if (const double here = mismatch(nearest + shift); here < least) {
      least = here;
      best = nearest + shift;
    }
  return best;
}

/// Every image of a contact that shows; its arm is its own, not the one within the cell.
void lay_out_contacts(CellScene& scene, const Box<2>& box, const std::vector<ContactRow>& contacts,
                      const std::vector<Vec2>& shifts, double margin) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec2 from = scene.discs[contacts[c].first].centre;
    const Vec2 arm = contact_arm(box, from, scene.discs[contacts[c].second].centre, contacts[c]);
    for (const Vec2& shift : shifts) {
      const std::array<Vec2, 2> ends{from + shift, from + shift + arm};
      if (comes_near(scene.corner, ends[0] + 0.5 * arm, margin + 0.5 * norm(arm)))
        scene.lines.push_back({ends[0], ends[1], c, lies_in(scene.corner, ends)});
    }
  }
}

}  // namespace

CellScene lay_out_cell(const Box<2>& box, std::span<const double> radius, const Frame& frame, double margin) {
  const std::size_t n = radius.size();
  CellScene scene;
  scene.corner = cell_corners(box);
  if (n == 0) return scene;
  for (std::size_t i = 0; i < n; ++i)
    scene.discs.push_back({static_cast<std::int32_t>(i), into_cell(box, frame.position[i]), {}, {}});

  // Images one radius further out than what shows flatten the discs that do show.
  const double largest = *std::max_element(radius.begin(), radius.end());
  const std::vector<Vec2> shifts = neighbour_cells(box);
  for (std::size_t s = 1; s < shifts.size(); ++s)
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 centre = scene.discs[i].centre + shifts[s];
      if (comes_near(scene.corner, centre, margin + radius[i] + largest))
        scene.discs.push_back({static_cast<std::int32_t>(i), centre, {}, {}});
    }
  const int points = n > 3000 ? 24 : 72;
  for (SceneDisc& disc : scene.discs) start_circle(disc, radius[disc.site], points);
  flatten(scene.discs, radius);
  const auto hidden = std::remove_if(
      scene.discs.begin() + static_cast<std::ptrdiff_t>(n), scene.discs.end(),
      [&](const SceneDisc& d) { return !comes_near(scene.corner, d.centre, margin + radius[d.site]); });
  scene.discs.erase(hidden, scene.discs.end());

  for (SceneDisc& disc : scene.discs) disc.lies = lies_in(scene.corner, disc.outline);
  lay_out_contacts(scene, box, frame.contacts, shifts, margin);
  return scene;
}

}  // namespace supple
