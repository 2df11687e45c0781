#include "supple/contact/disc_contacts.hpp"

#include "supple/contact/coincident.hpp"

namespace supple {

namespace {

/// Sums of one chunk of sites.
struct ChunkSum {
  EnergyParts energy;
  Mat2 virial;
  ChunkSum& operator+=(const ChunkSum& b) {
    energy += b.energy;
    virial += b.virial;
    return *this;
  }
};

void add_force(Evaluation<2>& out, const PairForce<2>& p, double share_i, double share_j, std::int32_t i, std::int32_t j) {
  const Vec2 f = force_on_first(p);
  const double couple = p.tangential * p.distance;
  out.force[i] += f;
  out.force[j] -= f;
  out.torque[i] += couple * share_i;
  out.torque[j] += couple * share_j;
}

}  // namespace

void DiscContacts::evaluate(const System<2>& system, double dt, Detail detail, Evaluation<2>& out) {
  const PairTable& pairs = system.pairs;
  const auto rows = static_cast<std::size_t>(pairs.size());
  out.pair.resize(rows);
  out.trial_state.resize(rows);
  out.trial_history.resize(rows * static_cast<std::size_t>(pairs.width));
  std::visit([&](const auto& repulsion) { fill_rows(repulsion, system, dt, detail, out); }, repulsion_);
}

template <class R>
void DiscContacts::fill_rows(const R& repulsion, const System<2>& system, double dt, Detail detail, Evaluation<2>& out) {
  const PairTable& pairs = system.pairs;
  const State<2>& state = system.state;
  const Box<2>& box = system.box;
  const DiscLaw law = law_;
  const bool serial = thread_count() == 1 || chunk_count(state.size()) < 2 * thread_count();

  const auto one_row = [&](std::int32_t i, int row, ChunkSum& sum) {
    const std::int32_t j = pairs.second[row];
    PairForce<2>& p = out.pair[row];
    const double u = pairs.history[row];
    const bool linked = pairs.state[row] == ContactState::permanent;
    const double r_i = state.radius[i], r_j = state.radius[j], d0 = r_i + r_j;
    const auto s = box.separation(state.position[i], state.position[j]);
    const double d2 = dot(s.r, s.r);
    if (d2 >= d0 * d0 && !linked) {
      // A spring that is still wound up when the contact opens is lost to friction.
      if (detail == Detail::energies && u != 0 && dt > 0)
        sum.energy.sliding_power += 0.5 * law.contact.k_t * u * u / dt;
      p.active = false;
      out.trial_state[row] = ContactState::open;
      out.trial_history[row] = 0;
      return;
    }
    const double d = std::sqrt(d2), inverse_d0 = 1 / d0;
    const Vec2 n = d > 0 ? (1 / d) * s.r : arbitrary_direction(i, j), t = turned_left(n);
    const Vec2 v = state.velocity[j] - state.velocity[i] - box.velocity_jump(s.up);
    const double spin_speed = r_i * state.spin[i] + r_j * state.spin[j];
    const double v_t = dot(v, t) - (law.lever_arm == LeverArm::distance ? d * inverse_d0 * spin_speed : spin_speed);
    const PairMotion motion{d, d0, dot(v, n), v_t};
    const DiscResponse response = linked ? respond_link(repulsion, law, motion, u, dt)
                                         : respond_contact(repulsion, law, motion, u, dt);
    p = {n, d, response.elastic, response.viscous, response.tangential.force, s.up, s.crosses, true};
    out.trial_state[row] = response.tangential.state;
    out.trial_history[row] = response.tangential.elongation;
    if (serial) add_force(out, p, r_i * inverse_d0, r_j * inverse_d0, i, j);
    if (detail == Detail::energies) {
      const PairStiffness& k = linked ? law.link : law.contact;
      const double u_new = response.tangential.elongation;
      sum.energy.elastic += elastic_energy(repulsion, law, d, d0, linked);
      sum.energy.tangential += 0.5 * k.k_t * u_new * u_new;
      sum.energy.viscous_power += k.eta * motion.v_n * motion.v_n;
      const bool slides = out.trial_state[row] == ContactState::slip;
      const double viscous = slides && law.slip != Slip::clamp ? 0 : k.eta_t * v_t * v_t;
      sum.energy.tangential_viscous_power += viscous;
      if (slides && dt > 0)
        sum.energy.sliding_power += response.tangential.force * v_t - viscous - 0.5 * k.k_t * (u_new * u_new - u * u) / dt;
      sum.virial.add_outer(-d, force_on_first(p), n);
    }
  };

  const ChunkSum total = sum_chunks<ChunkSum>(state.size(), [&](std::int64_t begin, std::int64_t end) {
    ChunkSum sum;
    for (std::int32_t i = static_cast<std::int32_t>(begin); i < end; ++i)
      for (int row = pairs.begin[i]; row < pairs.begin[i + 1]; ++row) one_row(i, row, sum);
    return sum;
  });
  out.energy += total.energy;
  out.virial += total.virial;
  if (serial) return;
  index_back_rows(pairs, state.size());
  gather(system, out);
}

void DiscContacts::index_back_rows(const PairTable& pairs, int sites) {
  if (indexed_version_ == pairs.version && static_cast<int>(back_begin_.size()) == sites + 1 &&
      back_row_.size() == static_cast<std::size_t>(pairs.size()))
    return;
  back_begin_.assign(static_cast<std::size_t>(sites) + 1, 0);
  for (std::int32_t j : pairs.second) ++back_begin_[j + 1];
  for (int i = 0; i < sites; ++i) back_begin_[i + 1] += back_begin_[i];
  std::vector<std::int32_t> next(back_begin_.begin(), back_begin_.end() - 1);
  back_row_.resize(static_cast<std::size_t>(pairs.size()));
  for (int row = 0; row < pairs.size(); ++row) back_row_[next[pairs.second[row]]++] = row;
  indexed_version_ = pairs.version;
}

/// Each site adds its contacts in ascending order of the partner, as the serial scatter does: the same bits.
void DiscContacts::gather(const System<2>& system, Evaluation<2>& out) const {
  const PairTable& pairs = system.pairs;
  const std::vector<double>& radius = system.state.radius;
  for_chunks(system.state.size(), [&](std::int64_t, std::int64_t begin, std::int64_t end) {
    for (std::int32_t i = static_cast<std::int32_t>(begin); i < end; ++i) {
      const auto couple = [&](const PairForce<2>& p, std::int32_t a, std::int32_t b) {
        return p.tangential * p.distance * (radius[i] * (1 / (radius[a] + radius[b])));
      };
      for (std::int32_t k = back_begin_[i]; k < back_begin_[i + 1]; ++k) {
        const PairForce<2>& p = out.pair[back_row_[k]];
        if (!p.active) continue;
        out.force[i] -= force_on_first(p);
        out.torque[i] += couple(p, pairs.first[back_row_[k]], i);
      }
      for (std::int32_t row = pairs.begin[i]; row < pairs.begin[i + 1]; ++row) {
        const PairForce<2>& p = out.pair[row];
        if (!p.active) continue;
        out.force[i] += force_on_first(p);
        out.torque[i] += couple(p, i, pairs.second[row]);
      }
    }
  });
}

}  // namespace supple
