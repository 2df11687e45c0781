#include "supple/experiment/sound_states.hpp"

namespace supple {

template <int Dim>
Soundness look_at(const Packing<Dim>& packing) {
  return look_at(packing.system, packing.outline);
}

template <int Dim>
bool must_stop(const Packing<Dim>& packing, const Soundness& soundness) {
  return !soundness.has_areas() || (packing.on_unsound == OnUnsound::stop && !soundness.sound());
}

Error unsound_error(const Soundness& soundness) {
  const char* to_do =
      "give vertices that are wider (bodies.diameter_ratio) or stiffer (contact.k_c), smaller steps or a "
      "lower pressure; or contact.unsound = \"mark\" to go on and see it marked";
  if (!soundness.has_areas())
    to_do =
        "give bending stiffness (bodies.k_b), A0 nearer to the regular polygon's, smaller steps or a lower "
        "pressure";
  else if (soundness.inside + soundness.crossing == 0)
    to_do =
        "give wider vertices (bodies.diameter_ratio), stiffer edges (bodies.k_l; in 3D triangles, "
        "bodies.k_a), or contact.kind = "
        "\"smooth\"; or "
        "contact.unsound = \"mark\" to go on and see it marked";
  return numerics_error(soundness.what(), "the state handed over is the last one before", to_do);
}

template <int Dim>
Soundness LastGood<Dim>::look() {
  const Soundness soundness = look_at(packing_);
  if (!must_stop(packing_, soundness)) {
    good_ = packing_.system;
    return soundness;
  }
  go_back();
  throw unsound_error(soundness);
}

template <int Dim>
void LastGood<Dim>::go_back() {
  packing_.system = good_;
  packing_.field->invalidate();
}

template Soundness look_at(const Packing<2>&);
template Soundness look_at(const Packing<3>&);
template bool must_stop(const Packing<2>&, const Soundness&);
template bool must_stop(const Packing<3>&, const Soundness&);
template class LastGood<2>;
template class LastGood<3>;

}  // namespace supple
