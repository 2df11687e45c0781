#!/usr/bin/env bash
# ESyS-Particle 2.3.5 (Debian 12: esys-particle 2.3.5+dfsg2-6+b1): two spheres of radius 1 overlap by 0.1, in the middle of a cell
# of length 10 that is periodic along x (circDimList), or across its boundary, at x = 9 and 0.9; velocities after 100 steps.
#
# Guess: the two cases push each other apart alike, however many processes share the work.
# Seen: across the boundary they do not touch unless the cell is divided among processes along x: with one process, or two along
# y, nothing happens, as if there were no periodicity, and no word is said. With two along x it is as in the middle. Choose
# mpiDimList with at least two along each periodic axis, and try a pair across it first.
#   in the middle, one process: -1.581 1.581
#   across the boundary, one process: 0.000 0.000
#   across the boundary, two along y: 0.000 0.000
#   across the boundary, two along x: -1.581 1.581
set -euo pipefail
want=2.3.5+dfsg2-6+b1
version=$(dpkg-query -W -f='${Version}' esys-particle 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs esys-particle $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > pair.py <<'PYTHON'
import sys

from esys.lsm import *
from esys.lsm.util import *

along_x, along_y, first, second = (float(word) for word in sys.argv[-4:])
parts = [int(along_x), int(along_y), 1]
world = LsmMpi(numWorkerProcesses=parts[0] * parts[1], mpiDimList=parts)
world.initNeighbourSearch(particleType="NRotSphere", gridSpacing=2.5, verletDist=0.2)
world.setNumTimeSteps(100)
world.setTimeStepSize(0.001)
world.setSpatialDomain(BoundingBox(Vec3(0, -10, -10), Vec3(10, 10, 10)), circDimList=[True, False, False])
for number, x in enumerate((first, second)):
    world.createParticle(NRotSphere(id=number, posn=Vec3(x, 0.3, 0), radius=1.0, mass=1.0))
world.createInteractionGroup(NRotElasticPrms(name="push", normalK=1000.0, scaling=True))
world.createFieldSaver(ParticleVectorFieldSaverPrms(
    fieldName="velocity", fileName="velocity", fileFormat="RAW2", beginTimeStep=0, endTimeStep=100, timeStepIncr=100))
world.run()
PYTHON
run() { # NAME, processes along x and y, places
  rm -f velocity.*
  timeout 30 mpirun --allow-run-as-root --oversubscribe -np $(($2 * $3 + 1)) esysparticle pair.py "$2" "$3" "$4" "$5" \
    > messages 2>&1 || { cat messages; exit 1; }
  awk -v name="$1" '{ speeds = speeds sprintf(" %.3f", $4) } END { print name ":" speeds }' velocity.1.dat
}
{
  run "in the middle, one process" 1 1 4 5.9
  run "across the boundary, one process" 1 1 9 0.9
  run "across the boundary, two along y" 1 2 9 0.9
  run "across the boundary, two along x" 2 1 9 0.9
} > seen
cat seen
diff seen - <<'SEEN'
in the middle, one process: -1.581 1.581
across the boundary, one process: 0.000 0.000
across the boundary, two along y: 0.000 0.000
across the boundary, two along x: -1.581 1.581
SEEN
