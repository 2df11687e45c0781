#include "supple/experiment/sound_states.hpp"

namespace supple {

Soundness look_at(const Packing& packing) { return look_at(packing.system, packing.outline); }

bool must_stop(const Packing& packing, const Soundness& soundness) {
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
        "give wider vertices (bodies.diameter_ratio), stiffer edges (bodies.k_l), or contact.kind = "
        "\"smooth\"; or "
        "contact.unsound = \"mark\" to go on and see it marked";
  return numerics_error(soundness.what(), "the state handed over is the last one before", to_do);
}

Soundness LastGood::look() {
  const Soundness soundness = look_at(packing_);
  if (!must_stop(packing_, soundness)) {
    good_ = packing_.system;
    return soundness;
  }
  packing_.system = good_;
  packing_.field->invalidate();
  throw unsound_error(soundness);
}

}  // namespace supple
