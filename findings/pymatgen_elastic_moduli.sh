#!/usr/bin/env bash
# pymatgen 2022.11.7 (Debian 12: python3-pymatgen 2022.11.7+dfsg1-11+deb12u2): the moduli of an ElasticTensor that is isotropic,
# with a bulk modulus of 100 and a shear modulus of 60, hence a Young's modulus of 150 and a Poisson's ratio of 0.25, and the
# energy of a uniaxial strain of 0.01, whose stress is 180 times 0.01.
#
# Guess: all in the units of the tensor: Young's modulus 150 in each direction, energy 180 * 0.01^2 / 2 = 0.009.
# Seen: bulk and shear modulus are in the units of the tensor. `y_mod` is 1e9 times as large, and `energy_density` 160 times
# less: both hold the tensor for one in GPa and give back Pa and eV per cubic angstrom. So a tensor of a packing in Pa, or
# in units of its springs, has a Young's modulus that does not belong to its own bulk modulus. `directional_elastic_mod` is not
# Young's modulus but that of a strain without strains across it, 180. Take 9 K G / (3 K + G) and the compliance.
#   bulk 100, shear 60, Poisson's ratio 0.25
#   y_mod 1.5e+11 for 150
#   along x: directional_elastic_mod 180, from the compliance 150
#   energy of a strain: energy_density 5.617e-05 for 0.009
set -euo pipefail
want=2022.11.7+dfsg1-11+deb12u2
version=$(dpkg-query -W -f='${Version}' python3-pymatgen 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-pymatgen $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > moduli.py <<'PYTHON'
import numpy
from pymatgen.analysis.elasticity import ElasticTensor, Strain

bulk, shear = 100, 60
voigt = numpy.zeros((6, 6))
voigt[:3, :3] = bulk - 2 * shear / 3
voigt[range(6), range(6)] += [2 * shear] * 3 + [shear] * 3
tensor = ElasticTensor.from_voigt(voigt)
print(f"bulk {tensor.k_vrh:.4g}, shear {tensor.g_vrh:.4g}, Poisson's ratio {tensor.homogeneous_poisson:.4g}")
print(f"y_mod {tensor.y_mod:.4g} for {9 * bulk * shear / (3 * bulk + shear):.4g}")
print(f"along x: directional_elastic_mod {tensor.directional_elastic_mod([1, 0, 0]):.4g}, "
      f"from the compliance {1 / tensor.compliance_tensor.voigt[0, 0]:.4g}")
strain = Strain([[0.01, 0, 0], [0, 0, 0], [0, 0, 0]])
work = numpy.sum(numpy.array(tensor.calculate_stress(strain)) * numpy.array(strain)) / 2
print(f"energy of a strain: energy_density {tensor.energy_density(strain):.4g} for {work:.4g}")
PYTHON
/usr/bin/python3 moduli.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
bulk 100, shear 60, Poisson's ratio 0.25
y_mod 1.5e+11 for 150
along x: directional_elastic_mod 180, from the compliance 150
energy of a strain: energy_density 5.617e-05 for 0.009
SEEN
