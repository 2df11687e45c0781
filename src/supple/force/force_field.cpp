#include "supple/force/force_field.hpp"

namespace supple {

void ForceField::add(const Interaction& interaction) {
  if (!bodies_) throw input_error("no such force between microgel discs", "it acts on bodies of many sites");
  interactions_.push_back(interaction.clone());
}

void ForceField::add_hessian(System<2>& system, HessianBlocks<2>& blocks, HessianKind kind) {
  begin_hessian(system);
  terms_.add_hessian(system, blocks, kind);
  finish_hessian(system, blocks);
}

void ForceField::add_joining_hessian(System<2>& system, HessianBlocks<2>& blocks) {
  begin_hessian(system);
  terms_.add_joining_hessian(system, blocks);
  finish_hessian(system, blocks);
}

void ForceField::begin_hessian(System<2>& system) {
  if (!bodies_) throw input_error("this force field has no Hessian", "its contacts have memory");
  neighbors_.update(system);
}

void ForceField::finish_hessian(System<2>& system, HessianBlocks<2>& blocks) {
  bodies_->add_hessian(system, blocks);
  if (walls_) add_wall_hessian(system, *walls_, blocks);
  external_.add_hessian(blocks);
}

}  // namespace supple
