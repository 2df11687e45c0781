#include "supple/force/surface_hessian.hpp"

#include <algorithm>
#include <cmath>

#include "supple/force/triangulation.hpp"
#include "supple/geometry/hinge.hpp"

// In a triangle with the corners x_k, the edges d_k = x_(k+2) - x_(k+1) opposite to them, the unit normal n
// and the area a, let g_k = n x d_k/(2a) be the slope of the barycentric coordinate of corner k: normal to
// d_k, toward the corner, of the length 1/height. A move dx_k tilts the normal by dn = -g_k (n.dx_k), and
//   da/dx_k = a g_k,
//   d2a/dx_i dx_j = (d_i.d_j)/(4a) n n^T + s_ij [n]/2,   [n] y = n x y,
//   s_ij = 1 for j = i + 2, -1 for j = i + 1, 0 for j = i.
// A hinge at the edge from x_i to x_j of length l, opposite to corner k, gets from this triangle
//   dtheta/dx_q = n w_q,   w_k = -l/(2a),  w_i = cot_j/l,  w_j = cot_i/l.
// These weights depend on the triangle alone, so that derivatives of n w_q are sums over the two triangles:
//   d2theta/dx_p dx_q = -(w_q n g_p^T + w_p g_q n^T) + s (n m^T + m n^T)/(2 l^2),   m = g_k/|g_k|,
// s = 1 for p = q on the edge, -1 for the two ends of the edge, and 0 with corner k. (The last part of one
// triangle alone is n m^T; the antisymmetric halves of the two triangles cancel.) The same as the derivatives
// of Tamstorf & Grinspun [2013], by triangles.

namespace supple {

namespace {

/// The lower blocks of a surface: of all pairs in rows, or of each site, each edge, and, where hinges bend,
/// of the outer sites of each hinge. Pairs go by numbers in the body.
class SurfaceBlocks {
 public:
  enum class Pairs { all, edges, hinges };

  SurfaceBlocks(int first, const Triangulation& mesh, Pairs pairs, HessianBlocks<3>& blocks)
      : mesh_(mesh), pairs_(pairs), begin_(blocks.size()), blocks_(blocks) {
    const auto append = [&](int i, int j) {
      blocks.push_back({first + std::max(i, j), first + std::min(i, j), {}});
    };
    for (int i = 0; i < mesh.sites; ++i)
      for (int j = pairs == Pairs::all ? 0 : i; j <= i; ++j) append(i, j);
    if (pairs == Pairs::all) return;
    for (const auto& hinge : mesh.hinge) append(hinge[0], hinge[1]);
    if (pairs == Pairs::edges) return;
    for (const auto& hinge : mesh.hinge) append(hinge[2], hinge[3]);
  }

  bool all() const { return pairs_ == Pairs::all; }

  /// d2U/(dx_i dx_j), i >= j, where all pairs have blocks.
  Mat<3>& of_pair(int i, int j) { return at(static_cast<std::size_t>(i) * (i + 1) / 2 + j); }
  void add_site(int i, const Mat<3>& m) { (all() ? of_pair(i, i) : at(i)) += m; }
  /// Adds d2U/(dx_i dx_j) = m of the two ends, in some order, of the edge of hinge h.
  void add_edge(int h, int i, int j, const Mat<3>& m) { add(mesh_.sites + h, i, j, m); }
  /// The same of the outer sites of hinge h.
  void add_outer(int h, int i, int j, const Mat<3>& m) { add(mesh_.sites + mesh_.hinges + h, i, j, m); }

 private:
  Mat<3>& at(std::size_t k) { return blocks_[begin_ + k].h; }

  void add(int place, int i, int j, const Mat<3>& m) {
    Mat<3>& h = all() ? of_pair(std::max(i, j), std::min(i, j)) : at(static_cast<std::size_t>(place));
    if (i > j) h += m;
    else h += transposed(m);
  }
  static Mat<3> transposed(const Mat<3>& m) {
    Mat<3> t;
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) t[c][d] = m[d][c];
    return t;
  }

  const Triangulation& mesh_;
  Pairs pairs_;
  std::size_t begin_;
  HessianBlocks<3>& blocks_;
};

/// The matrix of n x.
Mat<3> cross_matrix(const Vec3& n) { return {{{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}}}; }

struct Triangle {
  Vec3 edge[3], normal, slope[3];  ///< d_k; n; g_k
  double area, cotangent[3];

  explicit Triangle(const Vec3 (&x)[3]) {
    for (int k = 0; k < 3; ++k) edge[k] = x[(k + 2) % 3] - x[(k + 1) % 3];
    const Vec3 across = cross(edge[1], edge[2]);
    const double twice = norm(across);
    area = 0.5 * twice;
    normal = (1 / twice) * across;
    for (int k = 0; k < 3; ++k) {
      slope[k] = (1 / twice) * cross(normal, edge[k]);
      cotangent[k] = -dot(edge[(k + 1) % 3], edge[(k + 2) % 3]) / twice;
    }
  }
};

/// A hinge as it is now: its moment dU/d(theta), and the slope of its angle by its four sites.
struct Hinge {
  double moment = 0;
  Vec3 slope[4];
};

/// The surface of one body with what its second derivatives are made of.
class SurfaceCurvature {
 public:
  SurfaceCurvature(const System<3>& system, int b, const Triangulation& mesh, SurfaceBlocks& out)
      : shape_(system.shape), k_(system.shape.stiffness[b]), mesh_(mesh), out_(out) {
    const Vec3 *const x = &system.state.position[system.topology.begin[b]], origin = x[0];
    for (int i = 0; i < mesh.sites; ++i) x_.push_back(x[i] - origin);
    for (const auto& [i, j, k] : mesh.facet) triangle_.emplace_back(Triangle({x_[i], x_[j], x_[k]}));
    rest_area_ = &shape_.rest_facet[system.topology.facet_begin[b]];
    rest_angle_ = &shape_.rest_hinge[system.topology.hinge_begin[b]];
    if (k_.hinge == 0) return;
    for (int h = 0; h < mesh.hinges; ++h) {
      const auto& s = mesh.hinge[h];
      const Vec3 corner[4] = {x_[s[0]], x_[s[1]], x_[s[2]], x_[s[3]]};
      hinge_.push_back({k_.hinge * (hinge_angle(corner) - rest_angle_[h]), {}});
    }
  }

  /// All but what comes from the volume.
  void add_triangles() {
    for (int t = 0; t < mesh_.facets; ++t) {
      Mat<3> h[3][3];
      add_area(t, h);
      for (int k = 0; k < 3 && k_.hinge != 0; ++k) add_bending(t, k, h);
      for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        out_.add_site(site(t, k), h[k][k]);
        out_.add_edge(hinge_of(t, k), site(t, i), site(t, j), h[i][j]);
      }
    }
    for (int h = 0; h < mesh_.hinges && k_.hinge != 0; ++h) add_slopes_of_angle(h);
  }

  double volume() const {
    double sum = 0;
    for (int t = 0; t < mesh_.facets; ++t)
      sum += dot(triangle_[t].normal, x_[site(t, 0)]) * triangle_[t].area / 3;
    return sum;
  }
  std::vector<Vec3> slope_of_volume() const {
    std::vector<Vec3> slope(x_.size());
    for (int t = 0; t < mesh_.facets; ++t)
      for (int k = 0; k < 3; ++k) slope[site(t, k)] += (triangle_[t].area / 3) * triangle_[t].normal;
    return slope;
  }
  /// p d2v/dx2. Of v = sum x_i.(x_j x x_k)/6 what the two triangles at an edge from x_i to x_j add to
  /// d2v/dx_i dx_j is that of their other corners, [x_d - x_c]/6.
  void add_pressure(double pressure) {
    for (int h = 0; h < mesh_.hinges; ++h) {
      const auto& [a, b, c, d] = mesh_.hinge[h];
      out_.add_edge(h, a, b, cross_matrix((pressure / 6) * (x_[d] - x_[c])));
    }
  }

 private:
  int site(int t, int k) const { return mesh_.facet[t][k]; }
  /// The hinge at the edge opposite to corner k.
  int hinge_of(int t, int k) const {
    return static_cast<int>(mesh_.corner_hinge[Triangulation::corner_number(t, k)]);
  }

  void add_area(int t, Mat<3> (&h)[3][3]) const {
    const Triangle& f = triangle_[t];
    const double pull = k_.facet * (f.area - rest_area_[t]) + k_.tension;
    const Mat<3> turned = (0.5 * pull) * cross_matrix(f.normal);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        h[i][j].add_outer(pull * dot(f.edge[i], f.edge[j]) / (4 * f.area), f.normal, f.normal);
        h[i][j].add_outer(k_.facet * f.area * f.area, f.slope[i], f.slope[j]);
      }
      h[i][(i + 2) % 3] += turned;
      h[i][(i + 1) % 3] += -1.0 * turned;
    }
  }

  /// What the triangle adds to the moment times d2theta/dx2 of the hinge opposite to its corner k, and to the
  /// slope of its angle.
  void add_bending(int t, int k, Mat<3> (&h)[3][3]) {
    const Triangle& f = triangle_[t];
    Hinge& hinge = hinge_[hinge_of(t, k)];
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double length = norm(f.edge[k]), height = 2 * f.area / length;
    double weight[3];
    weight[k] = -1 / height;
    weight[i] = f.cotangent[j] / length;
    weight[j] = f.cotangent[i] / length;
    for (int p = 0; p < 3; ++p)
      for (int q = 0; q < 3; ++q) {
        h[p][q].add_outer(-hinge.moment * weight[q], f.normal, f.slope[p]);
        h[p][q].add_outer(-hinge.moment * weight[p], f.slope[q], f.normal);
      }
    Mat<3> turning;  // of the edge in the plane of the triangle
    const double half = 0.5 * hinge.moment * height / (length * length);
    turning.add_outer(half, f.normal, f.slope[k]);
    turning.add_outer(half, f.slope[k], f.normal);
    h[i][i] += turning;
    h[j][j] += turning;
    h[i][j] += -1.0 * turning;
    h[j][i] += -1.0 * turning;
    const auto& sites = mesh_.hinge[hinge_of(t, k)];
    for (int q = 0; q < 3; ++q)
      hinge.slope[std::find(sites.begin(), sites.end(), site(t, q)) - sites.begin()] += weight[q] * f.normal;
  }

  /// k_b (dtheta/dx)(dtheta/dx)^T, once the triangles on both sides are known.
  void add_slopes_of_angle(int h) {
    const auto& s = mesh_.hinge[h];
    const auto product = [&, &slope = hinge_[h].slope](int p, int q) {
      Mat<3> m;
      m.add_outer(k_.hinge, slope[p], slope[q]);
      return m;
    };
    for (int p = 0; p < 4; ++p) out_.add_site(s[p], product(p, p));
    out_.add_edge(h, s[0], s[1], product(0, 1));
    out_.add_outer(h, s[2], s[3], product(2, 3));
    for (int side = 0; side < 2; ++side) {
      // The corner opposite to the hinge; the edges at it are those of other hinges.
      const int corner = opposite_corner(h, side), t = corner / 3, k = corner % 3, outer = 2 + side;
      for (int end = 0; end < 2; ++end) {
        const int ahead = (k + 1) % 3, behind = (k + 2) % 3;
        const int other = site(t, ahead) == s[end] ? behind : ahead;
        out_.add_edge(hinge_of(t, other), s[outer], s[end], product(outer, end));
      }
    }
  }

  /// Triangle times three plus corner.
  int opposite_corner(int h, int side) const {
    const int t = static_cast<int>(mesh_.hinge_facet[side][h] / 4);
    int k = 0;
    while (site(t, k) != mesh_.hinge[h][2 + side]) ++k;
    return 3 * t + k;
  }

  const Shape& shape_;
  const ShapeStiffness& k_;
  const Triangulation& mesh_;
  SurfaceBlocks& out_;
  std::vector<Vec3> x_;
  std::vector<Triangle> triangle_;
  std::vector<Hinge> hinge_;
  const double *rest_area_, *rest_angle_;
};

/// Whether a surface keeps its shape without its volume: hinges resist, and triangles resist a swelling more
/// than the volume does. Second derivatives by the logarithm of the size: 9 k_v v0^2 of the volume, 4 k_a sum
/// a0^2 of the triangles.
bool stiff_without_volume(const System<3>& system, int b) {
  const ShapeStiffness& k = system.shape.stiffness[b];
  double areas = 0;
  for (int f = system.topology.facet_begin[b]; f < system.topology.facet_begin[b + 1]; ++f)
    areas += 4 * k.facet * system.shape.rest_facet[f] * system.shape.rest_facet[f];
  const double v0 = system.shape.rest_volume[b];
  return k.hinge > 0 && 9 * k.volume * v0 * v0 <= areas;
}

}  // namespace

bool has_shape_energy(const System<3>& system, int b) {
  const Topology<3>& t = system.topology;
  const ShapeStiffness& k = system.shape.stiffness[b];
  return t.facet_begin[b] < t.facet_begin[b + 1] &&
         (k.volume != 0 || k.facet != 0 || k.hinge != 0 || k.tension != 0);
}

void add_surface_hessian(const System<3>& system, int b, HessianBlocks<3>& blocks, HessianKind kind,
                         OuterProducts<3>* products) {
  if (!has_shape_energy(system, b)) return;
  using Pairs = SurfaceBlocks::Pairs;
  const ShapeStiffness& k = system.shape.stiffness[b];
  const Triangulation& mesh = triangulation_of(system.topology, b);
  const bool left_out = kind == HessianKind::sparse && stiff_without_volume(system, b);
  const bool near = k.volume == 0 || left_out || products;
  const int first = system.topology.begin[b];
  SurfaceBlocks out(first, mesh, !near ? Pairs::all : k.hinge != 0 ? Pairs::hinges : Pairs::edges, blocks);
  SurfaceCurvature surface(system, b, mesh, out);
  surface.add_triangles();
  if (k.volume == 0) return;
  surface.add_pressure(k.volume * (surface.volume() - system.shape.rest_volume[b]));
  if (near && !products) return;
  std::vector<Vec3> slope = surface.slope_of_volume();
  if (products) {
    products->push_back({k.volume, first, std::move(slope)});
    return;
  }
  for (int i = 0; i < mesh.sites; ++i)
    for (int j = 0; j <= i; ++j) out.of_pair(i, j).add_outer(k.volume, slope[i], slope[j]);
}

}  // namespace supple
