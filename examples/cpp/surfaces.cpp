/// Jams elastic shells in 3D: surfaces [SHELLS]
#include <cstdio>
#include <cstdlib>

#include "supple/core/error.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/random_surfaces.hpp"
#include "supple/observe/rattlers.hpp"

int main(int argc, char** argv) {
  try {
    supple::SurfaceSample
        sample;  // geodesic spheres of 42 vertices and two sizes, the small ones of volume 1
    sample.count = argc > 1 ? std::atoi(argv[1]) : 8;
    sample.shape.bending = 0.05;
    const supple::Case laws;  // rough contacts, k_c = 1: docs/parameters.md
    supple::Packing<3> packing = supple::packing_of(laws, supple::random_surfaces(sample));

    supple::JamSpec wanted;
    wanted.search = supple::JamSearch::pressure;
    wanted.pressure = 1e-6;  // [k_v v0]
    const auto end = supple::jam(packing, wanted, [](const supple::JamProgress<3>& p) {
      std::fprintf(stderr, "phi about %.4f, P = %.2e\n", p.state.packing_fraction, p.state.pressure);
      return true;  // false: the search stops, and throws `interrupted`
    });

    const supple::System<3>& s = packing.system;
    const auto fraction = supple::packing_fraction(s, packing.outline);
    supple::BodyContacts<3>& contacts = *packing.field->bodies();
    const auto touching = supple::site_contacts(s, contacts.records(s), contacts.laws());
    const auto rattlers = supple::find_rattlers(s, touching);
    const auto numbers = supple::count_contacts(supple::contact_network(s, touching), rattlers);
    std::printf("P = %.4e %s\nphi = %.5f +- %.5f\nneighbours = %.2f of %d particles\n", end.state.pressure,
                packing.pressure_symbol.c_str(), fraction.total, fraction.error, numbers.mean(),
                numbers.bodies);
  } catch (const supple::Error& e) {  // what is wrong, why, and what to do
    std::fprintf(stderr, "%s\n", e.what());
    return e.exit_code();
  }
}
