#include "supple/force/force_field.hpp"

namespace supple {

void ForceField::add_hessian(System<2>& system, HessianBlocks<2>& blocks, HessianKind kind) {
  if (!bodies_) throw input_error("this force field has no Hessian", "its contacts have memory");
  neighbors_.update(system);
  terms_.add_hessian(system, blocks, kind);
  bodies_->add_hessian(system, blocks);
  if (walls_) add_wall_hessian(system, *walls_, blocks);
  external_.add_hessian(blocks);
}

}  // namespace supple
