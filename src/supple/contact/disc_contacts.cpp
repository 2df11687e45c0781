#include "supple/contact/disc_contacts.hpp"

#include <array>

#include "supple/contact/coincident.hpp"
#include "supple/model/row_separation.hpp"

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

// Rows are taken in batches, each gathered into lanes, computed in loops that vectorise, and scattered. Only
// rows that touch meet the law; which ones do in a dense packing cannot be predicted, so they are sorted out
// without branches.
constexpr int batch_size = 64;
using Lane = std::array<double, batch_size>;

/// Rows of the table: vector to the image that they are about, cells between the discs, d0 and d^2.
struct Candidates {
  int begin, count;
  Lane x, y, along, up, d0, d2;
};

/// Rows that touch: contacts in the front lanes, links in the back ones.
struct Touching {
  int contacts = 0, links = 0, count = 0;
  std::array<std::int32_t, batch_size> candidate;  ///< of each lane
  std::array<std::int32_t, batch_size> lane;       ///< of each touching row, in the order of the table
  Lane x, y, d0, elongation;
  Lane v_x, v_y, rolling;          ///< relative velocity and r_i w_i + r_j w_j, of the state
  Lane now_x, now_y, now_rolling;  ///< the same of the instant of the positions
  Lane distance, n_x, n_y, slid, elastic, viscous, tangential, new_elongation;
  std::array<ContactState, batch_size> state;
  Lane f_x, f_y, twist;  ///< on the first disc; torque per radius

  int links_begin() const { return batch_size - links; }
};

void separate(const System<2>& system, const Lattice<2> images, Candidates& c) {
  const State<2>& s = system.state;
  for (int k = 0; k < c.count; ++k) {
    const auto i = system.pairs.first[c.begin + k], j = system.pairs.second[c.begin + k];
    c.x[k] = s.position[j][0] - s.position[i][0];
    c.y[k] = s.position[j][1] - s.position[i][1];
    c.d0[k] = s.radius[i] + s.radius[j];
  }
  for (int k = 0; k < c.count; ++k) {
    Vec2 r{c.x[k], c.y[k]};
    const Vec2 cells = images.reduce(r);
    c.x[k] = r[0];
    c.y[k] = r[1];
    c.along[k] = cells[flow];
    c.up[k] = cells[gradient];
    c.d2[k] = dot(r, r);
  }
  if (system.pairs.image.empty()) return;
  for (int k = 0; k < c.count; ++k) {
    const RowImage& image = system.pairs.image[c.begin + k];
    if (!image.kept) continue;
    const Vec2 r = row_separation(system, c.begin + k).r;
    c.x[k] = r[0];
    c.y[k] = r[1];
    c.along[k] = image.cells[flow];
    c.up[k] = image.cells[gradient];
    c.d2[k] = dot(r, r);
  }
}

/// `range`: distance at which contacts end, over d0.
void select_touching(const PairTable& pairs, double range, const Candidates& c, Touching& t) {
  const double square = range * range;
  for (int k = 0; k < c.count; ++k) {
    const bool linked = pairs.state[c.begin + k] == ContactState::permanent;
    const bool touches = linked | (c.d2[k] < square * (c.d0[k] * c.d0[k]));
    const int lane = linked ? t.links_begin() - 1 : t.contacts;
    t.candidate[lane] = k;
    t.lane[t.count] = lane;
    t.links += linked;
    t.contacts += touches & !linked;
    t.count += touches;
  }
}

void gather_motion(const System<2>& system, const PresentMotion<2>& motion, const Candidates& c,
                   Touching& t) {
  const State<2>& s = system.state;
  const Vec2* velocity = motion.empty() ? s.velocity.data() : motion.velocity.data();
  const double* spin = motion.empty() ? s.spin.data() : motion.spin.data();
  const double jump = system.box.velocity_jump(1)[flow],
               jump_now = motion.empty() ? jump : motion.strain_rate * system.box.length[gradient];
  for (int a = 0; a < t.count; ++a) {
    const int lane = t.lane[a], k = t.candidate[lane], row = c.begin + k;
    const auto i = system.pairs.first[row], j = system.pairs.second[row];
    t.x[lane] = c.x[k];
    t.y[lane] = c.y[k];
    if (c.d2[k] == 0) [[unlikely]] {  // coincident centres are taken to be barely apart
      const Vec2 n = arbitrary_direction(i, j);
      t.x[lane] = 1e-150 * n[0];
      t.y[lane] = 1e-150 * n[1];
    }
    t.d0[lane] = c.d0[k];
    t.v_x[lane] = s.velocity[j][0] - s.velocity[i][0] - c.up[k] * jump;
    t.v_y[lane] = s.velocity[j][1] - s.velocity[i][1];
    t.rolling[lane] = s.radius[i] * s.spin[i] + s.radius[j] * s.spin[j];
    t.now_x[lane] = velocity[j][0] - velocity[i][0] - c.up[k] * jump_now;
    t.now_y[lane] = velocity[j][1] - velocity[i][1];
    t.now_rolling[lane] = s.radius[i] * spin[i] + s.radius[j] * spin[j];
    t.elongation[lane] = system.pairs.history[row];
  }
}

/// respond(motion, elongation) in lanes [begin, end), after a step of dt. Everything by value: the compiler
/// then knows that no lane aliases it.
template <class Respond>
void apply_law(int begin, int end, const LeverArm lever_arm, const double dt, Touching& t,
               const Respond respond) {
  const double share = lever_arm == LeverArm::distance ? 1 : 0;
  for (int k = begin; k < end; ++k) {
    const double d = std::sqrt(t.x[k] * t.x[k] + t.y[k] * t.y[k]);
    const Vec2 n{t.x[k] / d, t.y[k] / d}, v{t.v_x[k], t.v_y[k]}, now{t.now_x[k], t.now_y[k]};
    const double arm = share * (d / t.d0[k]) + (1 - share);
    const double slid = way_slid(d, t.d0[k], dot(v, n), dot(v, turned_left(n)), t.rolling[k], lever_arm, dt);
    const PairMotion motion{d, t.d0[k], dot(now, n), dot(now, turned_left(n)) - arm * t.now_rolling[k], slid};
    const DiscResponse f = respond(motion, t.elongation[k]);
    t.distance[k] = d;
    t.n_x[k] = n[0];
    t.n_y[k] = n[1];
    t.slid[k] = slid;
    t.elastic[k] = f.elastic;
    t.viscous[k] = f.viscous;
    t.tangential[k] = f.tangential.force;
    t.new_elongation[k] = f.tangential.elongation;
    t.state[k] = f.tangential.state;
    const Vec2 force = force_on_first(f.elastic + f.viscous, f.tangential.force, n);
    t.f_x[k] = force[0];
    t.f_y[k] = force[1];
    t.twist[k] = torque_per_radius(f.tangential.force, d, t.d0[k]);
  }
}

/// Fills the rows of the evaluation: those that touch from the lanes, the others as open.
void write_rows(const Candidates& c, const Touching& t, Evaluation<2>& out) {
  PairForce<2>* pair = out.pair.data() + c.begin;
  ContactState* state = out.trial_state.data() + c.begin;
  double* history = out.trial_history.data() + c.begin;
  std::fill_n(state, c.count, ContactState::open);
  std::fill_n(history, c.count, 0.0);
  for (int k = 0; k < c.count; ++k) pair[k].active = false;
  for (int a = 0; a < t.count; ++a) {
    const int lane = t.lane[a], k = t.candidate[lane];
    pair[k] = {{t.n_x[lane], t.n_y[lane]},
               t.distance[lane],
               t.elastic[lane],
               t.viscous[lane],
               t.tangential[lane],
               static_cast<std::int32_t>(c.up[k]),
               c.up[k] != 0 || c.along[k] != 0,
               true};
    state[k] = t.state[lane];
    history[k] = t.new_elongation[lane];
  }
}

/// visit(push) for each row that touches, in order; push: as {first, second, force, twist}.
template <class Push, class Visit>
void for_pushes(const System<2>& system, const Candidates& c, const Touching& t, const Visit& visit) {
  for (int a = 0; a < t.count; ++a) {
    const int lane = t.lane[a], row = c.begin + t.candidate[lane];
    visit(Push{system.pairs.first[row], system.pairs.second[row], {t.f_x[lane], t.f_y[lane]}, t.twist[lane]});
  }
}

/// The tangential way of a row that has opened over the last step.
double way_slid_of_open(const System<2>& system, const DiscLaw& law, double dt, const Candidates& c, int k) {
  const State<2>& s = system.state;
  const auto i = system.pairs.first[c.begin + k], j = system.pairs.second[c.begin + k];
  const double d = std::sqrt(c.d2[k]);
  const Vec2 n{c.x[k] / d, c.y[k] / d}, v = s.velocity[j] - s.velocity[i] - system.box.velocity_jump(c.up[k]);
  return way_slid(d, c.d0[k], dot(v, n), dot(v, turned_left(n)),
                  s.radius[i] * s.spin[i] + s.radius[j] * s.spin[j], law.lever_arm, dt);
}

template <class R>
void add_energies(const R& repulsion, const DiscLaw& law, const System<2>& system, double dt,
                  const Candidates& c, const Touching& t, const Evaluation<2>& out, ChunkSum& sum) {
  for (int k = 0; k < c.count; ++k) {
    const double u = system.pairs.history[c.begin + k];
    // A spring that is still wound up when the contact opens is lost to friction.
    if (out.pair[c.begin + k].active || u == 0 || dt == 0) continue;
    const double slid = way_slid_of_open(system, law, dt, c, k);
    sum.energy.sliding_power +=
        book({0, 0, ContactState::slip}, u, slid, 0, dt, law.contact.k_t, law.slip).sliding_power;
  }
  for (int a = 0; a < t.count; ++a) {
    const int lane = t.lane[a], row = c.begin + t.candidate[lane];
    const bool linked = lane >= t.links_begin();
    const PairStiffness& s = linked ? law.link : law.contact;
    sum.energy.elastic += elastic_energy(repulsion, law, t.distance[lane], t.d0[lane], linked);
    const Vec2 v{t.v_x[lane], t.v_y[lane]}, &n = out.pair[row].normal;
    // Torques have these arms, whatever the law's speed has.
    const double v_t = dot(v, turned_left(n)) - t.distance[lane] / t.d0[lane] * t.rolling[lane];
    sum.energy.viscous_power -= t.viscous[lane] * dot(v, n);
    const TangentialBooks books = book({t.tangential[lane], t.new_elongation[lane], out.trial_state[row]},
                                       t.elongation[lane], t.slid[lane], v_t, dt, s.k_t, law.slip);
    sum.energy.tangential += books.energy;
    sum.energy.tangential_viscous_power += books.viscous_power;
    sum.energy.sliding_power += books.sliding_power;
    sum.virial.add_outer(-t.distance[lane], force_on_first(out.pair[row]), out.pair[row].normal);
  }
}

}  // namespace

void DiscContacts::evaluate(const System<2>& system, double dt, Detail detail, Evaluation<2>& out) {
  const PairTable& pairs = system.pairs;
  const auto rows = static_cast<std::size_t>(pairs.size());
  out.pair.resize(rows);
  out.trial_state.resize(rows);
  out.trial_history.resize(rows * static_cast<std::size_t>(pairs.width));
  std::visit([&](const auto& repulsion) { fill_rows(repulsion, system, dt, detail, out); }, repulsion_);
  if (detail == Detail::energies) keep_lossy(out);
}

void DiscContacts::keep_lossy(const Evaluation<2>& evaluation) {
  lossy_.assign(evaluation.pair.size(), {0, 0});
  for (std::size_t row = 0; row < lossy_.size(); ++row) {
    const PairForce<2>& p = evaluation.pair[row];
    if (!p.active) continue;
    const ContactState state = evaluation.trial_state[row];
    const double k_t = state == ContactState::permanent ? law_.link.k_t : law_.contact.k_t;
    const double dashpot = p.tangential - k_t * evaluation.trial_history[row];
    const bool freely = state == ContactState::slip && law_.slip != Slip::clamp;
    (freely ? lossy_[row].sliding : lossy_[row].dashpot) = dashpot;
  }
}

LossPower DiscContacts::loss_power(const System<2>& system, const Evaluation<2>& evaluation) const {
  const State<2>& s = system.state;
  LossPower sum;
  for (std::size_t row = 0; row < lossy_.size(); ++row) {
    const PairForce<2>& p = evaluation.pair[row];
    if (!p.active) continue;
    const auto i = system.pairs.first[row], j = system.pairs.second[row];
    const Vec2 v = s.velocity[j] - s.velocity[i] - system.box.velocity_jump(p.up);
    // Torques have these arms, whatever the law's speed has.
    const double rolling =
        p.distance / (s.radius[i] + s.radius[j]) * (s.radius[i] * s.spin[i] + s.radius[j] * s.spin[j]);
    const double v_t = dot(v, turned_left(p.normal)) - rolling;
    sum += {p.viscous * dot(v, p.normal), -lossy_[row].dashpot * v_t, -lossy_[row].sliding * v_t};
  }
  return sum;
}

template <class R>
void DiscContacts::fill_rows(const R& repulsion, const System<2>& system, double dt, Detail detail,
                             Evaluation<2>& out) {
  const PairTable& pairs = system.pairs;
  const Lattice<2> images = system.box.lattice();
  const DiscLaw law = law_;
  const SlipRule slip(law.slip, law.contact.k_t);
  const double range = range_of(repulsion);
  const auto contact = [=](const PairMotion& m, double u) {
    return respond_contact(repulsion, law, slip, m, u);
  };
  const auto link = [=](const PairMotion& m, double u) { return respond_link(repulsion, law, m, u); };
  const std::int64_t sites = system.state.size();
  const bool serial = runs_in_place(sites);
  if (!serial) pushes_.begin(chunk_count(sites), sites);
  const auto add = [radius = system.state.radius.data(), &out](const Push& push, const auto& here) {
    if (here(push.first)) {
      out.force[push.first] += push.force;
      out.torque[push.first] += radius[push.first] * push.twist;
    }
    if (here(push.second)) {
      out.force[push.second] -= push.force;
      out.torque[push.second] += radius[push.second] * push.twist;
    }
  };
  constexpr auto everywhere = [](std::int32_t) { return true; };

  const ChunkSum total = sum_chunks<ChunkSum>(sites, [&](std::int64_t begin, std::int64_t end) {
    ChunkSum sum;
    for (int row = pairs.begin[begin]; row < pairs.begin[end]; row += batch_size) {
      Candidates c;
      Touching t;
      c.begin = row;
      c.count = std::min(batch_size, pairs.begin[end] - row);
      separate(system, images, c);
      select_touching(pairs, range, c, t);
      gather_motion(system, out.now, c, t);
      apply_law(0, t.contacts, law.lever_arm, dt, t, contact);
      apply_law(t.links_begin(), batch_size, law.lever_arm, dt, t, link);
      write_rows(c, t, out);
      if (serial) for_pushes<Push>(system, c, t, [&](const Push& push) { add(push, everywhere); });
      else
        for_pushes<Push>(system, c, t, [&](const Push& push) {
          pushes_.keep(begin / chunk_size, push, std::array{push.first, push.second});
        });
      if (detail == Detail::energies) add_energies(repulsion, law, system, dt, c, t, out, sum);
    }
    return sum;
  });
  out.energy += total.energy;
  out.virial += total.virial;
  if (!serial) pushes_.add(add);
}

}  // namespace supple
