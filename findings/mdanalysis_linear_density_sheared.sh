#!/usr/bin/env bash
# MDAnalysis 2.4.2 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1): the density in slices of LinearDensity, of particles on a
# lattice that fill a cell of 10 by 10 by 10, upright and in simple shear; true is 1 in each slice.
#
# Guess: 1 along y and z at every strain; along x, where the cell leans, 1 as well or an error.
# Seen: along z, which shear does not change, 0.894 at strain 0.5 and 0.707 at 1: the volume is taken for the product of the
# three lengths of the cell, as if it were upright. Along y and z come slices beyond the cell, of density 0; along x particles
# beyond the longest length of the cell are left out, a sixth of all. No warning. The cell is that of the first frame
# throughout. Histogram the fractional coordinates yourself.
#   strain 0: slices 10, z 1.000 to 1.000, x 1.000 to 1.000, left out along x 0.000
#   strain 0.5: slices 11, z 0.000 to 0.894, x 0.089 to 1.118, left out along x 0.140
#   strain 1: slices 14, z 0.000 to 0.707, x 0.053 to 0.689, left out along x 0.165
set -euo pipefail
want=2.4.2+dfsg1-1+b1
version=$(dpkg-query -W -f='${Version}' python3-mdanalysis 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-mdanalysis $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import MDAnalysis
import numpy
from MDAnalysis.analysis.lineardensity import LinearDensity
from MDAnalysis.lib.mdamath import triclinic_box

places = (numpy.arange(20) + 0.5) / 20
fractions = numpy.stack(numpy.meshgrid(places, places, places), axis=-1).reshape(-1, 3)
count = len(fractions)
for strain in (0, 0.5, 1):
    cell = numpy.array([[10, 0, 0], [10 * strain, 10, 0], [0, 0, 10.0]])
    universe = MDAnalysis.Universe.empty(count, n_residues=count, atom_resindex=numpy.arange(count), trajectory=True)
    universe.add_TopologyAttr("masses", numpy.full(count, 0.602214076 / 8))  # 8 a unit of volume: density 1 g/cm3
    universe.add_TopologyAttr("charges", numpy.zeros(count))
    universe.load_new((fractions @ cell)[None].astype("f4"), dimensions=triclinic_box(*cell)[None])
    slices = LinearDensity(universe.atoms, binsize=1.0).run().results
    x, z = slices.x.mass_density, slices.z.mass_density
    print(f"strain {strain}: slices {len(z)}, z {z.min():.3f} to {z.max():.3f}, x {x.min():.3f} to {x.max():.3f}, "
          f"left out along x {abs(1 - x.sum() * slices.x.slice_volume / 1000):.3f}")
PYTHON
cat seen
diff seen - <<'SEEN'
strain 0: slices 10, z 1.000 to 1.000, x 1.000 to 1.000, left out along x 0.000
strain 0.5: slices 11, z 0.000 to 0.894, x 0.089 to 1.118, left out along x 0.140
strain 1: slices 14, z 0.000 to 0.707, x 0.053 to 0.689, left out along x 0.165
SEEN
