/// Sites that have got inside another body.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

struct SiteInside {
  std::int32_t site, body;
  friend bool operator==(const SiteInside&, const SiteInside&) = default;
};

/// Every site that lies inside the polygon of another body, through any periodic image, by body and site;
/// empty in a valid state. However deep, unlike BodyContacts::sites_inside(). Bodies that cross with no
/// vertex of either inside the other are not found. Costs one comparison of bounding boxes per pair of bodies
/// and image.
std::vector<SiteInside> find_sites_inside(const System<2>& system);

}  // namespace supple
