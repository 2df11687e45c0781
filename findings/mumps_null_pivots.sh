#!/usr/bin/env bash
# MUMPS 5.5.1 and the Cholesky factors of PETSc 3.18.5 itself (Debian 12: libmumps-5.5 5.5.1-1, python3-petsc4py-real3.18
# 3.18.5-1): how many zero modes a periodic network of springs has, from one factorisation of its stiffness: the null pivots
# that MUMPS finds (ICNTL(24) = 1), and MatGetInertia, with negative, zero and positive pivots. Points of a triangular
# lattice, moved a little, a share of its springs left out at random.
#
# Guess: as many as the dense solver has below 1e-9; where all springs are there two, the translations.
# Seen: MUMPS is right where there are few. With more floppy modes it misses a fifth to a half of them, 23 of 42, and some
# pivots are negative (15), as if the network were unstable, though no eigenvalue is below -1e-13. PETSc by itself finds no
# zero at all, or hundreds, 295 of 512. Neither says anything. Count eigenvalues.
#   2 zero modes: MUMPS all of them, negative pivots: none; PETSc another number
#   4 zero modes: MUMPS all of them, negative pivots: none; PETSc another number
#   20 zero modes: MUMPS fewer, negative pivots: some; PETSc another number
#   26 zero modes: MUMPS fewer, negative pivots: some; PETSc another number
#   42 zero modes: MUMPS fewer, negative pivots: some; PETSc another number
set -euo pipefail
for pair in libmumps-5.5=5.5.1-1 python3-petsc4py-real3.18=3.18.5-1 python3-scipy=1.10.1-2; do
  name=${pair%%=*} want=${pair#*=}
  version=$(dpkg-query -W -f='${Version}' "$name" 2>/dev/null || true)
  [ "$version" = "$want" ] || { echo "needs $name $want, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > pivots.py <<'PYTHON'
import numpy
import petsc4py

petsc4py.init(["pivots"])
import scipy.sparse
from petsc4py import PETSc


def stiffness(n, missing, seed):
    edges = numpy.array([[n, 0], [n / 2, n * 0.75**0.5]])
    random = numpy.random.RandomState(seed)
    fractions = numpy.array([[i, j] for j in range(n) for i in range(n)]) / n
    points = fractions @ edges + 0.1 * (random.rand(n * n, 2) - 0.5)
    matrix = numpy.zeros((2 * n * n, 2 * n * n))
    for j in range(n):
        for i in range(n):
            for di, dj in ((1, 0), (0, 1), (-1, 1)):
                if random.rand() < missing:
                    continue
                a, b = j * n + i, (j + dj) % n * n + (i + di) % n
                bond = points[b] - points[a] + numpy.array([(i + di) // n, (j + dj) // n]) @ edges
                bond /= numpy.linalg.norm(bond)
                row = numpy.zeros(2 * n * n)
                row[2 * a:2 * a + 2], row[2 * b:2 * b + 2] = -bond, bond
                matrix += numpy.outer(row, row)
    return matrix


def factor(matrix, package):
    upper = scipy.sparse.triu(scipy.sparse.csr_matrix(matrix)).tocsr()
    stored = PETSc.Mat().createSBAIJ(upper.shape, 1, csr=(upper.indptr, upper.indices, upper.data))
    stored.assemble()
    solver = PETSc.PC().create()
    solver.setOperators(stored)
    solver.setType("cholesky")
    solver.setFactorSolverType(package)
    if package == "mumps":
        solver.setFactorSetUpSolverType()
        solver.getFactorMatrix().setMumpsIcntl(24, 1)
        solver.getFactorMatrix().setMumpsIcntl(13, 1)
    solver.setUp()
    return solver.getFactorMatrix()


for n, missing, seed in ((6, 0, 1), (8, 0.36, 1), (10, 0.4, 2), (12, 0.4, 1), (16, 0.4, 3)):
    matrix = stiffness(n, missing, seed)
    values = numpy.linalg.eigvalsh(matrix)
    assert values[0] > -1e-13
    zeros = (values < 1e-9).sum()
    (negative, found, _), other = factor(matrix, "mumps").getInertia(), factor(matrix, "petsc").getInertia()[1]
    word = "all of them" if found == zeros else "fewer" if found < 0.95 * zeros else found
    print(f"{zeros} zero modes: MUMPS {word}, negative pivots: {'some' if negative else 'none'}; "
          f"PETSc {'the same' if other == zeros else 'another number'}")
PYTHON
OMP_NUM_THREADS=1 /usr/bin/python3 pivots.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
2 zero modes: MUMPS all of them, negative pivots: none; PETSc another number
4 zero modes: MUMPS all of them, negative pivots: none; PETSc another number
20 zero modes: MUMPS fewer, negative pivots: some; PETSc another number
26 zero modes: MUMPS fewer, negative pivots: some; PETSc another number
42 zero modes: MUMPS fewer, negative pivots: some; PETSc another number
SEEN
