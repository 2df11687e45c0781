#include "supple/compat/particleshear/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "supple/contact/coincident.hpp"
#include "supple/model/row_separation.hpp"

namespace supple {
namespace {

using namespace particleshear;

/// Rows of the pair table are handled in batches: gathered into arrays, computed in loops that vectorise,
/// scattered.
constexpr int batch_size = 64;
template <int n>
using Lanes = std::array<Vec<n>, batch_size>;
using Lane = std::array<double, batch_size>;

/// body(begin, count) for each batch of rows.
template <class Body>
void for_batches(int rows, Body&& body) {
  for (int begin = 0; begin < rows; begin += batch_size) body(begin, std::min(batch_size, rows - begin));
}

/// An image of a disc as another one sees it.
struct Image {
  double n_x, n_y, distance;
  double up;       ///< cells between them along the gradient
  double crosses;  ///< 0 if it is the disc itself
};

/// Nearest images in [-L/2, L/2) of the sheared periodic cell.
struct Images {
  double width, height, per_width, per_height, shift, jump;

  explicit Images(const Box<2>& box)
      : width(box.length[flow]),
        height(box.length[gradient]),
        per_width(1 / width),
        per_height(1 / height),
        shift(height * box.strain),
        jump(height * box.strain_rate) {}

  Image nearest(double x, double y) const {
    const double up = std::floor(y * per_height + 0.5);
    const double along = std::floor((x - up * shift) * per_width + 0.5);
    return at(x, y, along, up);
  }
  /// The image that many cells away.
  Image at(double x, double y, double along, double up) const {
    y -= up * height;
    x -= up * shift;
    x -= along * width;
    const double distance = std::sqrt(x * x + y * y), inverse = 1 / (distance > 0 ? distance : 1.0);
    return {x * inverse, y * inverse, distance, up, up * up + along * along};
  }
};

/// Sliding speed (v_j - v_i).t - (r_i w_i + r_j w_j), t = (-n_y, n_x).
double sliding_speed(double n_x, double n_y, double v_x, double v_y, double rolling) {
  return v_y * n_x - v_x * n_y - rolling;
}

/// Contacts of one batch; vectors are from `first` to `second`.
struct ForceBatch {
  Lanes<2> separation, velocity;  ///< not yet of the nearest image
  Lanes<2> rim;                   ///< r_i + r_j, r_i w_i + r_j w_j
  Lane linked, active;            ///< 1 or 0: permanent link; touching or linked
  Lane n_x, n_y, distance;
  Lane v_n, v_t;  ///< speeds of separation and of sliding
  Lane elastic, viscous, tangential;
  Lane f_x, f_y, couple;  ///< on first; couple over r_i + r_j
  Lane state;             ///< the number of its ContactState
  Lane up, crosses;       ///< as PairForce has them
};

void gather(ForceBatch& b, int begin, int count, const System<2>& system, const Vec2* rim) {
  const std::int32_t *first = &system.pairs.first[begin], *second = &system.pairs.second[begin];
  const ContactState* state = &system.pairs.state[begin];
  const Vec2 *position = system.state.position.data(), *velocity = system.state.velocity.data();
  for (int c = 0; c < count; ++c) {
    const int i = first[c], j = second[c];
    b.separation[c] = position[j] - position[i];
    b.velocity[c] = velocity[j] - velocity[i];
    b.rim[c] = rim[i] + rim[j];
    b.linked[c] = static_cast<double>(state[c] == ContactState::permanent);
  }
}

/// visit(c, image) for each row of a batch that keeps an image of its own: links, while there are long ones.
template <class Visit>
void for_kept_images(const PairTable& pairs, int begin, int count, const Lanes<2>& separation,
                     const Images& images, const Visit& visit) {
  if (pairs.image.empty()) return;
  for (int c = 0; c < count; ++c)
    if (const RowImage& row = pairs.image[begin + c]; row.kept)
      visit(c, images.at(separation[c][0], separation[c][1], row.cells[flow], row.cells[gradient]));
}

/// An image, and how it moves; all zero where the discs neither touch nor are linked.
[[gnu::always_inline]] inline void locate(ForceBatch& b, int c, const Image& image, double jump) {
  const double active = std::max(b.linked[c], image.distance < b.rim[c][0] ? 1.0 : 0.0);
  const double n_x = active * image.n_x, n_y = active * image.n_y;
  const double v_x = b.velocity[c][0] - image.up * jump, v_y = b.velocity[c][1];
  b.active[c] = active;
  b.n_x[c] = n_x;
  b.n_y[c] = n_y;
  b.distance[c] = image.distance;
  b.up[c] = active * image.up;
  b.crosses[c] = active * image.crosses;
  b.v_n[c] = v_x * n_x + v_y * n_y;
  b.v_t[c] = active * sliding_speed(n_x, n_y, v_x, v_y, b.rim[c][1]);
}

/// Numbers come by value: the compiler then knows that no lane aliases them.
void locate_all(ForceBatch& b, int begin, int count, const PairTable& pairs, const Images images) {
#pragma omp simd
  for (int c = 0; c < count; ++c)
    locate(b, c, images.nearest(b.separation[c][0], b.separation[c][1]), images.jump);
  for_kept_images(pairs, begin, count, b.separation, images,
                  [&](int c, const Image& image) { locate(b, c, image, images.jump); });
}

/// Forces, and elongations if the step is accepted.
template <ParticleShearElastic elastic_law, ParticleShearTensile tensile_law>
void respond(ForceBatch& b, int count, const double* __restrict history, double* __restrict trial_history,
             const ParticleShearConstants constants) {
  const Coefficients free = free_coefficients(constants), link = link_coefficients(constants);
#pragma omp simd
  for (int c = 0; c < count; ++c) {
    const double d0 = b.rim[c][0], active = b.active[c], linked = b.linked[c];
    const Contact contact{b.distance[c], d0, b.v_n[c], b.v_t[c], history[2 * c], history[2 * c + 1]};
    const Force f = contact_force<elastic_law, tensile_law>(contact, linked > 0, constants, free, link);
    const double elastic = active * f.elastic, tangential = active * f.tangential,
                 repulsion = elastic + f.viscous;
    b.elastic[c] = elastic;
    b.viscous[c] = f.viscous;
    b.tangential[c] = tangential;
    b.f_x[c] = -repulsion * b.n_x[c] - tangential * b.n_y[c];
    b.f_y[c] = -repulsion * b.n_y[c] + tangential * b.n_x[c];
    b.couple[c] = tangential * b.distance[c] / d0;
    b.state[c] = active * (1 + f.slips + 2 * linked);
    trial_history[2 * c] = active * f.elongation;
    trial_history[2 * c + 1] = active * f.elongation_back;
  }
}

using Respond = void (*)(ForceBatch&, int, const double*, double*, ParticleShearConstants);

Respond respond_for(const ParticleShearConstants& c) {
  using enum ParticleShearElastic;
  using enum ParticleShearTensile;
  if (c.elastic == divergent)
    return c.tensile == linear ? respond<divergent, linear> : respond<divergent, saturating>;
  return c.tensile == linear ? respond<plateau, linear> : respond<plateau, saturating>;
}

/// Coincident discs have no direction; without one they would stay together.
void push_apart(ForceBatch& b, int c, std::int32_t i, std::int32_t j) {
  const Vec2 n = arbitrary_direction(i, j);
  b.n_x[c] = n[0];
  b.n_y[c] = n[1];
  b.f_x[c] = -b.elastic[c] * n[0];
  b.f_y[c] = -b.elastic[c] * n[1];
}

void scatter(ForceBatch& b, int begin, int count, const PairTable& pairs, Evaluation<2>& e, Vec<4>* as_first,
             Vec<4>* as_second) {
  const std::int32_t *first = &pairs.first[begin], *second = &pairs.second[begin];
  ContactState* trial_state = &e.trial_state[begin];
  PairForce<2>* pair = &e.pair[begin];
  for (int c = 0; c < count; ++c) trial_state[c] = static_cast<ContactState>(static_cast<int>(b.state[c]));
  for (int c = 0; c < count; ++c) {
    const int i = first[c], j = second[c];
    const bool active = b.active[c] != 0;
    if (active & (b.distance[c] == 0)) push_apart(b, c, i, j);
    pair[c] = {{b.n_x[c], b.n_y[c]}, b.active[c] * b.distance[c],        b.elastic[c],      b.viscous[c],
               b.tangential[c],      static_cast<std::int32_t>(b.up[c]), b.crosses[c] != 0, active};
    const Vec<4> load{b.f_x[c], b.f_y[c], b.couple[c], 0};
    as_first[i] += load;
    as_second[j] += load;
  }
}

/// What elongates the contacts of one batch; vectors are from `first` to `second`.
struct MoveBatch {
  Lanes<2> separation, velocity;  ///< not yet of the nearest image; `first` has moved
  Lane rolling;                   ///< r_i w_i + r_j w_j
  Lane n_x, n_y, up;              ///< where both discs were
  Lane time;                      ///< dt if the contact sticks or is linked, else 0
};

void gather(MoveBatch& b, int begin, int count, double dt, const System<2>& system, const Evaluation<2>& e,
            const Vec2* rim) {
  const std::int32_t *first = &system.pairs.first[begin], *second = &system.pairs.second[begin];
  const Vec2 *position = system.state.position.data(), *velocity = system.state.velocity.data();
  const PairForce<2>* pair = &e.pair[begin];
  const ContactState* state = &e.trial_state[begin];
  for (int c = 0; c < count; ++c) {
    const int i = first[c], j = second[c];
    const PairForce<2>& p = pair[c];
    b.separation[c] = position[j] - (position[i] + dt * velocity[i]);
    b.velocity[c] = velocity[j] - velocity[i];
    b.rolling[c] = rim[i][1] + rim[j][1];
    b.n_x[c] = p.normal[0];
    b.n_y[c] = p.normal[1];
    b.up[c] = p.up;
    b.time[c] = dt * ((state[c] == ContactState::stick) | (state[c] == ContactState::permanent));
  }
}

/// Elongation as the second disc sees it, which is moved after the first.
[[gnu::always_inline]] inline double elongation_back(const MoveBatch& b, int c, const Image& image,
                                                     double jump) {
  const double v_x = b.velocity[c][0] - image.up * jump;
  return b.time[c] * sliding_speed(image.n_x, image.n_y, v_x, b.velocity[c][1], b.rolling[c]);
}

void add_elongation(MoveBatch& b, int begin, int count, const double* __restrict trial_history,
                    double* __restrict history, const PairTable& pairs, const Images images) {
#pragma omp simd
  for (int c = 0; c < count; ++c) {
    const double v_y = b.velocity[c][1], rolling = b.rolling[c];
    const double v_x = b.velocity[c][0] - b.up[c] * images.jump;
    history[2 * c] = trial_history[2 * c] + b.time[c] * sliding_speed(b.n_x[c], b.n_y[c], v_x, v_y, rolling);
    const Image image = images.nearest(b.separation[c][0], b.separation[c][1]);
    history[2 * c + 1] = trial_history[2 * c + 1] + elongation_back(b, c, image, images.jump);
  }
  for_kept_images(pairs, begin, count, b.separation, images, [&](int c, const Image& image) {
    history[2 * c + 1] = trial_history[2 * c + 1] + elongation_back(b, c, image, images.jump);
  });
}

}  // namespace

void ParticleShearContacts::collect(const State<2>& s) {
  rim_.resize(s.radius.size());
  for (std::size_t i = 0; i < rim_.size(); ++i) rim_[i] = {s.radius[i], s.radius[i] * s.spin[i]};
}

void ParticleShearContacts::evaluate(const System<2>& system, const ParticleShearConstants& constants,
                                     Evaluation<2>& out) {
  const PairTable& pairs = system.pairs;
  out.pair.resize(pairs.first.size());
  out.trial_state.resize(pairs.first.size());
  out.trial_history.resize(2 * pairs.first.size());
  collect(system.state);
  as_first_.assign(rim_.size(), {});
  as_second_.assign(rim_.size(), {});

  const Images images(system.box);
  const Respond respond = respond_for(constants);
  ForceBatch batch;
  for_batches(pairs.size(), [&](int begin, int count) {
    gather(batch, begin, count, system, rim_.data());
    locate_all(batch, begin, count, pairs, images);
    respond(batch, count, &pairs.history[2 * begin], &out.trial_history[2 * begin], constants);
    scatter(batch, begin, count, pairs, out, as_first_.data(), as_second_.data());
  });
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    const Vec<4>&a = as_first_[i], &b = as_second_[i];
    out.force[i] += Vec2{a[0] - b[0], a[1] - b[1]};
    out.torque[i] += system.state.radius[i] * (a[2] + b[2]);
  }
}

void ParticleShearContacts::elongate(System<2>& system, const Evaluation<2>& evaluation, double dt) {
  PairTable& pairs = system.pairs;
  collect(system.state);
  const Images images(system.box);
  MoveBatch batch;
  for_batches(pairs.size(), [&](int begin, int count) {
    gather(batch, begin, count, dt, system, evaluation, rim_.data());
    add_elongation(batch, begin, count, &evaluation.trial_history[2 * begin], &pairs.history[2 * begin],
                   pairs, images);
  });
  std::copy(evaluation.trial_state.begin(), evaluation.trial_state.end(), pairs.state.begin());
}

}  // namespace supple
