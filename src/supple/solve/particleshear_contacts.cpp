#include "supple/solve/particleshear_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "supple/contact/coincident.hpp"

namespace supple::particleshear {
namespace {

/// Rows of the pair table are handled in batches: gathered into arrays, computed in loops that vectorise, scattered.
constexpr int batch_size = 64;
using Lane = std::array<double, batch_size>;

/// body(begin, count) for each batch of rows.
template <class Body>
void for_batches(int rows, Body&& body) {
  for (int begin = 0; begin < rows; begin += batch_size) body(begin, std::min(batch_size, rows - begin));
}

/// Nearest images in [-L/2, L/2) of the sheared periodic cell.
struct Images {
  double width, height, per_width, per_height, shift, jump;

  explicit Images(const Box<2>& box)
      : width(box.length[flow]), height(box.length[gradient]), per_width(1 / width), per_height(1 / height),
        shift(height * box.strain), jump(height * box.strain_rate) {}
  double cells_up(double y) const { return std::floor(y * per_height + 0.5); }
  double cells_along(double x) const { return std::floor(x * per_width + 0.5); }
};

/// Sliding speed (v_j - v_i).t - (r_i w_i + r_j w_j), t = (-n_y, n_x).
double sliding_speed(double n_x, double n_y, double v_x, double v_y, double rolling) {
  return v_y * n_x - v_x * n_y - rolling;
}

/// Contacts of one batch; vectors are from `first` to `second`.
struct ForceBatch {
  Lane x, y, v_x, v_y;
  Lane rolling;  ///< r_i w_i + r_j w_j
  Lane d0, linked, elongation, elongation_back;
  Lane distance, up, along, n_x, n_y, active;
  Lane elastic, viscous, tangential, slips;
};

void gather(ForceBatch& b, int begin, int count, const System<2>& system) {
  const PairTable& pairs = system.pairs;
  const State<2>& s = system.state;
  for (int c = 0; c < count; ++c) {
    const int row = begin + c, i = pairs.first[row], j = pairs.second[row];
    b.x[c] = s.position[j][0] - s.position[i][0];
    b.y[c] = s.position[j][1] - s.position[i][1];
    b.v_x[c] = s.velocity[j][0] - s.velocity[i][0];
    b.v_y[c] = s.velocity[j][1] - s.velocity[i][1];
    b.rolling[c] = s.radius[i] * s.spin[i] + s.radius[j] * s.spin[j];
    b.d0[c] = s.radius[i] + s.radius[j];
    b.linked[c] = pairs.state[row] == ContactState::permanent;
    b.elongation[c] = pairs.history[2 * row];
    b.elongation_back[c] = pairs.history[2 * row + 1];
  }
}

/// Constants by value: the compiler then knows that no lane aliases them.
template <ParticleShearElastic elastic_law, ParticleShearTensile tensile_law>
void compute(ForceBatch& b, int count, const Images images, const ParticleShearConstants constants) {
  const Coefficients free = free_coefficients(constants), link = link_coefficients(constants);
  for (int c = 0; c < count; ++c) {
    const double up = images.cells_up(b.y[c]);
    const double y = b.y[c] - up * images.height;
    const double sheared = b.x[c] - up * images.shift;
    const double along = images.cells_along(sheared);
    const double x = sheared - along * images.width;
    const double distance = std::sqrt(x * x + y * y);
    const double inverse = 1 / (distance > 0 ? distance : 1.0);
    const double n_x = x * inverse, n_y = y * inverse;
    const double v_x = b.v_x[c] - up * images.jump;
    const bool linked = b.linked[c] != 0;
    const Contact contact{distance, b.d0[c], v_x * n_x + b.v_y[c] * n_y,
                          sliding_speed(n_x, n_y, v_x, b.v_y[c], b.rolling[c]), b.elongation[c], b.elongation_back[c]};
    const Force f = contact_force<elastic_law, tensile_law>(contact, linked, constants, free, link);
    const double active = linked | (distance < b.d0[c]) ? 1.0 : 0.0;
    b.distance[c] = active * distance;
    b.up[c] = active * up;
    b.along[c] = active * along;
    b.n_x[c] = active * n_x;
    b.n_y[c] = active * n_y;
    b.active[c] = active;
    b.elastic[c] = active * f.elastic;
    b.viscous[c] = active * f.viscous;
    b.tangential[c] = active * f.tangential;
    b.elongation[c] = active * f.elongation;
    b.elongation_back[c] = active * f.elongation_back;
    b.slips[c] = f.slips;
  }
}

using Compute = void (*)(ForceBatch&, int, Images, ParticleShearConstants);

Compute compute_for(const ParticleShearConstants& c) {
  using enum ParticleShearElastic;
  using enum ParticleShearTensile;
  if (c.elastic == divergent) return c.tensile == linear ? compute<divergent, linear> : compute<divergent, exponential>;
  return c.tensile == linear ? compute<plateau, linear> : compute<plateau, exponential>;
}

void scatter(const ForceBatch& b, int begin, int count, const System<2>& system, Evaluation<2>& e) {
  const PairTable& pairs = system.pairs;
  for (int c = 0; c < count; ++c) {
    const int row = begin + c, i = pairs.first[row], j = pairs.second[row];
    const bool active = b.active[c] != 0;
    const ContactState touching = b.slips[c] != 0 ? ContactState::slip : ContactState::stick;
    e.trial_state[row] = b.linked[c] != 0 ? ContactState::permanent : active ? touching : ContactState::open;
    e.trial_history[2 * row] = b.elongation[c];
    e.trial_history[2 * row + 1] = b.elongation_back[c];

    PairForce<2>& p = e.pair[row];
    p = {{b.n_x[c], b.n_y[c]}, b.distance[c], b.elastic[c], b.viscous[c], b.tangential[c],
         static_cast<std::int32_t>(b.up[c]), b.up[c] != 0 || b.along[c] != 0, active};
    if (active && p.distance == 0) p.normal = arbitrary_direction(i, j);

    const Vec2 force = force_on_first(p);
    const double couple = p.tangential * p.distance / b.d0[c];  // S1-3
    e.force[i] += force;
    e.force[j] -= force;
    e.torque[i] += couple * system.state.radius[i];
    e.torque[j] += couple * system.state.radius[j];
  }
}

/// What elongates the contacts of one batch; vectors are from `first` to `second`.
struct MoveBatch {
  Lane n_x, n_y, up;  ///< where both discs were
  Lane x, y;          ///< not yet the nearest image; `first` has moved
  Lane v_x, v_y, rolling;
  Lane follows;       ///< whether the contact sticks or is linked
  Lane elongation, elongation_back;
};

void gather(MoveBatch& b, int begin, int count, double dt, const System<2>& system, const Evaluation<2>& e) {
  const PairTable& pairs = system.pairs;
  const State<2>& s = system.state;
  for (int c = 0; c < count; ++c) {
    const int row = begin + c, i = pairs.first[row], j = pairs.second[row];
    const PairForce<2>& p = e.pair[row];
    const ContactState state = e.trial_state[row];
    b.n_x[c] = p.normal[0];
    b.n_y[c] = p.normal[1];
    b.up[c] = p.up;
    b.x[c] = s.position[j][0] - (s.position[i][0] + s.velocity[i][0] * dt);
    b.y[c] = s.position[j][1] - (s.position[i][1] + s.velocity[i][1] * dt);
    b.v_x[c] = s.velocity[j][0] - s.velocity[i][0];
    b.v_y[c] = s.velocity[j][1] - s.velocity[i][1];
    b.rolling[c] = s.radius[i] * s.spin[i] + s.radius[j] * s.spin[j];
    b.follows[c] = state == ContactState::stick || state == ContactState::permanent;
    b.elongation[c] = e.trial_history[2 * row];
    b.elongation_back[c] = e.trial_history[2 * row + 1];
  }
}

void compute(MoveBatch& b, int count, double dt, const Images images) {
  for (int c = 0; c < count; ++c) {
    const double v_x = b.v_x[c] - b.up[c] * images.jump;
    b.elongation[c] += b.follows[c] * dt * sliding_speed(b.n_x[c], b.n_y[c], v_x, b.v_y[c], b.rolling[c]);

    const double up = images.cells_up(b.y[c]);
    const double y = b.y[c] - up * images.height;
    const double sheared = b.x[c] - up * images.shift;
    const double x = sheared - images.cells_along(sheared) * images.width;
    const double distance = std::sqrt(x * x + y * y);
    const double inverse = 1 / (distance > 0 ? distance : 1.0);
    const double v_x_back = b.v_x[c] - up * images.jump;
    b.elongation_back[c] +=
        b.follows[c] * dt * sliding_speed(x * inverse, y * inverse, v_x_back, b.v_y[c], b.rolling[c]);
  }
}

}  // namespace

void evaluate_contacts(const System<2>& system, const ParticleShearConstants& constants, Evaluation<2>& out) {
  const int rows = system.pairs.size();
  out.pair.resize(rows);
  out.trial_state.resize(rows);
  out.trial_history.resize(2 * rows);
  const Images images(system.box);
  const Compute compute = compute_for(constants);
  ForceBatch batch;
  for_batches(rows, [&](int begin, int count) {
    gather(batch, begin, count, system);
    compute(batch, count, images, constants);
    scatter(batch, begin, count, system, out);
  });
}

void elongate_contacts(System<2>& system, const Evaluation<2>& evaluation, double dt) {
  PairTable& pairs = system.pairs;
  const Images images(system.box);
  MoveBatch batch;
  for_batches(pairs.size(), [&](int begin, int count) {
    gather(batch, begin, count, dt, system, evaluation);
    compute(batch, count, dt, images);
    for (int c = 0; c < count; ++c) {
      pairs.history[2 * (begin + c)] = batch.elongation[c];
      pairs.history[2 * (begin + c) + 1] = batch.elongation_back[c];
    }
  });
  std::copy(evaluation.trial_state.begin(), evaluation.trial_state.end(), pairs.state.begin());
}

}  // namespace supple::particleshear
