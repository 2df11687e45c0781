/// Frames from a system and its forces.
#pragma once
#include <string>

#include "supple/contact/laws/table.hpp"
#include "supple/contact/record.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

/// The frame of microgel discs at the instant of `evaluation`, with the contacts and the stress of each disc.
Frame<2> make_frame(const System<2>& system, const Evaluation<2>& evaluation);

/// The frame of deformable particles with these contacts, and the friction and links of the evaluation; rows
/// ascend. Two corners that meet head on, each acting on the edges of the other, are one row.
template <int Dim>
Frame<Dim> make_frame(const System<Dim>& system, const Evaluation<Dim>& evaluation,
                      const std::vector<ContactRecord<Dim>>& records, const ContactLaws& laws);

/// Adds the stress tensor of each body, compression positive, as numbers stress_xx to stress_yy (3D:
/// stress_zz); in xy, x is the direction of the force and y that of the position. The stress of a microgel
/// disc is 1/(2 pi r^2) sum F l^T over its contacts: each contact counts half for either disc.
template <int Dim>
void add_stresses(BodyNumbers& numbers, const std::vector<Mat<Dim>>& stress);

/// Adds the components of a tensor as numbers NAME_xx to NAME_yy (3D: NAME_zz).
template <int Dim>
void add_tensor(SystemNumbers& numbers, const std::string& name, const Mat<Dim>& tensor);

/// What stays the same in a run: sizes and masses of sites, and the bodies or, of discs, the crosslinked
/// particles that they form.
template <int Dim>
RunInfo<Dim> make_run_info(const System<Dim>& system, const Units& units);

}  // namespace supple
