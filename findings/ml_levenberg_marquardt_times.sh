#!/usr/bin/env bash
# ml-levenberg-marquardt 5.1.0 (npm): the loss modulus of a Maxwell model, G w t / (1 + (w t)^2), at 40 frequencies over two
# decades on both sides of 1 / t, without noise, is fitted from 0.8 G and 1.3 t: the same curve, in other units of time.
#
# Guess: G and t are found for every t, or there is a sign that they were not.
# Seen: so for t = 1 and 0.1. From t = 0.01 on the answer is the start, after 100 iterations: derivatives are differences over a
# step of 0.1, whatever the size of a parameter. The answer holds nothing that says whether it converged. Hand over
# gradientDifference, a thousandth of each parameter, and ask for the iterations.
#   t = 1, by the right ones: G 1.000, t 1.000, 3 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
#   t = 0.1, by the right ones: G 1.000, t 1.000, 11 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
#   t = 0.01, by the right ones: G 0.800, t 1.300, 100 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
#   t = 0.001, by the right ones: G 0.800, t 1.300, 100 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
#   t = 0.0001, by the right ones: G 0.800, t 1.300, 100 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
#   the answer holds parameterValues, parameterError, iterations
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . ml-levenberg-marquardt@5.1.0 ml-matrix@6.15.1 >/dev/null
cat > fit.mjs <<'NODE'
import { levenbergMarquardt } from 'ml-levenberg-marquardt';
const loss = ([G, t]) => (w) => (G * w * t) / (1 + (w * t) ** 2);
for (const t of [1, 0.1, 0.01, 0.001, 0.0001]) {
  const x = Array.from({ length: 40 }, (_, i) => 10 ** (-2 + (4 * i) / 39) / t);
  const fit = (options) => {
    const answer = levenbergMarquardt({ x, y: x.map(loss([5, t])) }, loss, { initialValues: [4, 1.3 * t], ...options });
    const [G, time] = answer.parameterValues;
    return `G ${(G / 5).toFixed(3)}, t ${(time / t).toFixed(3)}, ${answer.iterations} iterations`;
  };
  console.log(`t = ${t}, by the right ones: ${fit({})}; gradientDifference: ${fit({ gradientDifference: [5e-3, 1e-3 * t] })}`);
}
const answer = levenbergMarquardt({ x: [1, 2, 3], y: [1, 2, 3].map(loss([5, 1])) }, loss, { initialValues: [4, 1.2] });
console.log(`the answer holds ${Object.keys(answer).join(', ')}`);
NODE
node fit.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
t = 1, by the right ones: G 1.000, t 1.000, 3 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
t = 0.1, by the right ones: G 1.000, t 1.000, 11 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
t = 0.01, by the right ones: G 0.800, t 1.300, 100 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
t = 0.001, by the right ones: G 0.800, t 1.300, 100 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
t = 0.0001, by the right ones: G 0.800, t 1.300, 100 iterations; gradientDifference: G 1.000, t 1.000, 3 iterations
the answer holds parameterValues, parameterError, iterations
SEEN
