/// Power of the forces by which energy is lost.
#pragma once

namespace supple {

/// Of dashpots along normals, of those along contacts that stick or are linked, and of friction that slips,
/// at some velocities: negative where they brake [energy/time]. What springs store is none of it.
struct LossPower {
  double viscous = 0, tangential_viscous = 0, sliding = 0;
  LossPower& operator+=(const LossPower& b) {
    viscous += b.viscous;
    tangential_viscous += b.tangential_viscous;
    sliding += b.sliding;
    return *this;
  }
};

}  // namespace supple
