#!/usr/bin/env bash
# mdtraj 1.9.7 (Debian 12: python3-mdtraj 1.9.7-6): compute_neighborlist in a sheared (triclinic) periodic cell.
#
# Guess: the pairs within the cutoff are those of compute_distances, which searches images properly.
# Seen: 400 random points in a cubic cell of side 10, cutoff 2.5. At shear strain 0 both agree. From strain 0.3 on
# compute_neighborlist leaves pairs out, without a warning; compute_distances agrees with a sum over all images.
#   strain 0.0: all images 5255, compute_distances 5255, compute_neighborlist 5255
#   strain 0.3: all images 5151, compute_distances 5151, compute_neighborlist 5114
#   strain 0.5: all images 5229, compute_distances 5229, compute_neighborlist 5157
#   strain 1.0: all images 5281, compute_distances 5281, compute_neighborlist 5244
set -euo pipefail
version=$(dpkg-query -W -f='${Version}' python3-mdtraj 2>/dev/null || true)
[ "$version" = 1.9.7-6 ] || { echo "needs python3-mdtraj 1.9.7-6, found '${version:-none}'"; exit 77; }

/usr/bin/python3 -W ignore - <<'PYTHON'
import sys
import numpy as np
import mdtraj

side, cutoff, count = 10.0, 2.5, 400
random = np.random.default_rng(1)
missed = {}
for strain in (0.0, 0.3, 0.5, 1.0):
    cell = np.array([[side, 0, 0], [strain * side, side, 0], [0, 0, side]])
    x = (random.random((count, 3)) @ cell).astype(np.float32)
    i, j = np.triu_indices(count, 1)
    d = x[j].astype(float) - x[i]
    least = np.min([np.linalg.norm(d + a * cell[0] + b * cell[1] + c * cell[2], axis=1)
                    for a in range(-4, 5) for b in (-1, 0, 1) for c in (-1, 0, 1)], axis=0)
    assert np.abs(least - cutoff).min() > 1e-6   # no pair for rounding to decide
    topology = mdtraj.Topology()
    residue = topology.add_residue("X", topology.add_chain())
    for _ in range(count):
        topology.add_atom("A", mdtraj.element.argon, residue)
    frames = mdtraj.Trajectory(x[None], topology)
    frames.unitcell_vectors = cell[None].astype(np.float32)
    distances = mdtraj.compute_distances(frames, np.stack([i, j], 1), periodic=True)[0]
    listed = sum(len(n) for n in mdtraj.compute_neighborlist(frames, cutoff, 0, periodic=True)) // 2
    right, by_distance = int((least < cutoff).sum()), int((distances < cutoff).sum())
    print(f"strain {strain}: all images {right}, compute_distances {by_distance}, compute_neighborlist {listed}")
    assert right == by_distance
    missed[strain] = right - listed
sys.exit(0 if missed[0.0] == 0 and all(missed[s] > 0 for s in (0.3, 0.5, 1.0)) else 1)
PYTHON
