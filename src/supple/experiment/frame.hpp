/// Frames from a system and its forces.
#pragma once
#include <string>

#include "supple/contact/laws/body.hpp"
#include "supple/contact/record.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

/// The instant of `evaluation`: contacts of discs as it found them.
Frame make_frame(const System<2>& system, const Evaluation<2>& evaluation);

/// The same of bodies with these contacts: rows ascending, with the friction and the links of the evaluation.
/// Two corners that meet head on, each of which acts on the other's edges, are one row.
Frame make_frame(const System<2>& system, const Evaluation<2>& evaluation,
                 const std::vector<ContactRecord<2>>& records, const BodyLaw& law);

/// The stress tensor of each body, compression positive, as numbers stress_xx ... stress_yy; xy: force along
/// x, line of action along y. Of a disc: (1/2 pi r^2) sum F l^T over its contacts.
void add_stresses(BodyNumbers& numbers, const std::vector<Mat2>& stress);

/// The components of a tensor as numbers NAME_xx ... NAME_yy.
void add_tensor(SystemNumbers& numbers, const std::string& name, const Mat2& tensor);

/// What a run is: sizes and masses of the sites, their bodies or, of discs, crosslinked particles.
RunInfo make_run_info(const System<2>& system, const Units& units);

}  // namespace supple
