#!/usr/bin/env bash
# SciPy 1.10.1 (Debian 12: python3-scipy 1.10.1-2): the shear modulus of periodic networks of springs (a bent triangular lattice
# of 30 by 30 with part of its bonds), for which K u = f is solved for the displacements that are not affine. K has zero modes
# without force, as MINRES allows. Tolerance 1e-5, the default; the residual is |f - K u| / |f|.
#
# Guess: "successful exit" (info 0) means that the relative residual is below the tolerance, as it says for cg and minres alike.
# Seen: so with cg. minres divides its residual by |K| |u| instead of |f|. In a network close to the number of bonds where it
# becomes floppy u is tens of times f: the residual is 3e-3, with info 0, and the modulus is a fifth too large; the closer the
# worse, as of a transition that has moved. Ask for the residual afterwards; cg did not mind the zero modes here, and
# tol=1e-10 gives minres the right number, too.
#   0.95 of the bonds: modulus 0.376, |u| = 1 |f|; cg 0.376 (info 0, residual below 1e-5)
#     minres 0.376 (info 0, residual 3e-04); tol 1e-10 0.376 (info 0, residual below 1e-5)
#   0.72 of the bonds: modulus 0.077, |u| = 15 |f|; cg 0.077 (info 0, residual below 1e-5)
#     minres 0.082 (info 0, residual 2e-03); tol 1e-10 0.077 (info 0, residual below 1e-5)
#   0.69 of the bonds: modulus 0.040, |u| = 29 |f|; cg 0.040 (info 0, residual below 1e-5)
#     minres 0.049 (info 0, residual 3e-03); tol 1e-10 0.040 (info 0, residual below 1e-5)
set -euo pipefail
want=1.10.1-2
version=$(dpkg-query -W -f='${Version}' python3-scipy 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-scipy $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
OPENBLAS_NUM_THREADS=1 /usr/bin/python3 - > seen <<'PYTHON'
import numpy
from scipy.sparse import lil_matrix
from scipy.sparse.linalg import cg, minres

n = 30
area = n * n * 0.75**0.5


def network(part):  # elongation of each spring by the displacements, and by a unit of shear
    random = numpy.random.RandomState(1)
    shifts = 0.2 * random.rand(n * n, 2) - 0.1
    elongations, affine = lil_matrix((3 * n * n, 2 * n * n)), numpy.zeros(3 * n * n)
    springs = [(i, j, di, dj) for j in range(n) for i in range(n) for di, dj in ((1, 0), (0, 1), (-1, 1))]
    for row, (i, j, di, dj) in enumerate(springs):
        if random.rand() > part:
            continue
        a, b = j * n + i, (j + dj) % n * n + (i + di) % n
        bond = numpy.array([di + 0.5 * dj, dj * 0.75**0.5]) + shifts[b] - shifts[a]
        length = numpy.hypot(*bond)
        elongations[row, 2 * a:2 * a + 2], elongations[row, 2 * b:2 * b + 2] = -bond / length, bond / length
        affine[row] = bond[0] * bond[1] / length
    return elongations.tocsr(), affine


def words(answer):
    u, info = answer
    residual = numpy.linalg.norm(f - K @ u) / numpy.linalg.norm(f)
    return f"{modulus(u):.3f} (info {info}, residual {'below 1e-5' if residual < 1e-5 else f'{residual:.0e}'})"


for part in (0.95, 0.72, 0.69):
    R, e = network(part)
    K, f = (R.T @ R).tocsr(), -(R.T @ e)
    modulus = lambda u: (e @ e - f @ u) / area
    exact = numpy.linalg.lstsq(K.toarray(), f, rcond=1e-12)[0]
    size = numpy.linalg.norm(exact) / numpy.linalg.norm(f)
    print(f"{part:.2f} of the bonds: modulus {modulus(exact):.3f}, |u| = {size:.0f} |f|; cg {words(cg(K, f))}")
    print(f"  minres {words(minres(K, f))}; tol 1e-10 {words(minres(K, f, tol=1e-10, maxiter=100000))}")
PYTHON
cat seen
diff seen - <<'SEEN'
0.95 of the bonds: modulus 0.376, |u| = 1 |f|; cg 0.376 (info 0, residual below 1e-5)
  minres 0.376 (info 0, residual 3e-04); tol 1e-10 0.376 (info 0, residual below 1e-5)
0.72 of the bonds: modulus 0.077, |u| = 15 |f|; cg 0.077 (info 0, residual below 1e-5)
  minres 0.082 (info 0, residual 2e-03); tol 1e-10 0.077 (info 0, residual below 1e-5)
0.69 of the bonds: modulus 0.040, |u| = 29 |f|; cg 0.040 (info 0, residual below 1e-5)
  minres 0.049 (info 0, residual 3e-03); tol 1e-10 0.040 (info 0, residual below 1e-5)
SEEN
