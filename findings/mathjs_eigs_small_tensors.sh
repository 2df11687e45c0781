#!/usr/bin/env bash
# mathjs 15.2.0 (npm), `eigs` of a symmetric tensor in SI units, s times ((2, 1, 0), (1, 2, 1), (0, 1, 2)): the inertia of a grain
# of a millimetre, in kg m^2, has s near 1e-13.
#
# Guess: the principal moments are s times 0.586, 2 and 3.414 for every s.
# Seen: the rotations end when all off the diagonal is below an absolute 1e-12 by the size of the matrix. At 1e-12 the moments are
# wrong by up to half, below it nothing is rotated, and the values are those on the diagonal, 2, 2, 2, the axes those of the
# coordinates. No exception. Divide by the largest entry first.
#   1: 0.585786 2.000000 3.414214
#   0.000001: 0.585786 2.000000 3.414214
#   1e-9: 0.585786 2.000000 3.414214
#   1e-10: 0.585788 2.000000 3.414212
#   1e-11: 0.585987 1.999801 3.414212
#   1e-12: 0.853722 1.831185 3.315094
#   1e-13: 2.000000 2.000000 2.000000
#   axes at 1e-13: (1, 0, 0) (0, 1, 0) (0, 0, 1)
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . mathjs@15.2.0 >/dev/null
cat > moments.mjs <<'NODE'
import { eigs } from 'mathjs';
const tensor = (s) => [[2 * s, s, 0], [s, 2 * s, s], [0, s, 2 * s]];
const words = (answer, s) => answer.values.map((value) => (value / s).toFixed(6)).join(' ');
for (const s of [1, 1e-6, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13]) console.log(`${s}: ${words(eigs(tensor(s)), s)}`);
const { eigenvectors } = eigs(tensor(1e-13));
console.log(`axes at 1e-13: ${eigenvectors.map(({ vector }) => `(${vector.join(', ')})`).join(' ')}`);
NODE
node moments.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
1: 0.585786 2.000000 3.414214
0.000001: 0.585786 2.000000 3.414214
1e-9: 0.585786 2.000000 3.414214
1e-10: 0.585788 2.000000 3.414212
1e-11: 0.585987 1.999801 3.414212
1e-12: 0.853722 1.831185 3.315094
1e-13: 2.000000 2.000000 2.000000
axes at 1e-13: (1, 0, 0) (0, 1, 0) (0, 0, 1)
SEEN
