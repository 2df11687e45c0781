#include "supple/force/force_field.hpp"

namespace supple {

template <int Dim>
void ForceField<Dim>::add(const Interaction<Dim>& interaction) {
  if (!bodies_) throw input_error("no such force between microgel discs", "it acts on bodies of many sites");
  interactions_.push_back(interaction.clone());
}

template <int Dim>
void ForceField<Dim>::add_hessian(System<Dim>& system, HessianBlocks<Dim>& blocks, HessianKind kind) {
  begin_hessian(system);
  terms_.add_hessian(system, blocks, kind);
  finish_hessian(system, blocks);
}

template <int Dim>
void ForceField<Dim>::add_joining_hessian(System<Dim>& system, HessianBlocks<Dim>& blocks) {
  begin_hessian(system);
  terms_.add_joining_hessian(system, blocks);
  finish_hessian(system, blocks);
}

template <int Dim>
void ForceField<Dim>::begin_hessian(System<Dim>& system) {
  if (!bodies_) throw input_error("this force field has no Hessian", "its contacts have memory");
  neighbors_.update(system);
}

template <int Dim>
void ForceField<Dim>::finish_hessian(System<Dim>& system, HessianBlocks<Dim>& blocks) {
  bodies_->add_hessian(system, blocks);
  if (walls_) add_wall_hessian(system, *walls_, blocks);
  external_.add_hessian(blocks);
}

template class ForceField<2>;
template class ForceField<3>;

}  // namespace supple
