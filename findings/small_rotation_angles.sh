#!/usr/bin/env bash
# gl-matrix 3.4.4 and quaternion 2.2.0 (npm), transforms3d 0.4 (Debian 12: python3-transforms3d 0.4+ds-2): the angle and axis of a
# rotation from its quaternion, as for the angular velocity of a grain from two frames. The angle goes from 0.01 to 1e-9.
#
# Guess: the angle, to the digits of its number type, as the quaternion holds it (its third component is half of it).
# Seen: it is the arc cosine of the fourth component, which is next to 1. gl-matrix, which has single precision, is 2.3% off at an
# angle of 0.001 and has 0 and the axis x at 1e-4, also for the angle between quaternions. The other two have double precision:
# quaternion has angle 0 at 1e-6, with an axis of length 5e-7, transforms3d is 1% off at 1e-7 and has 0 at 1e-8. Grains that turn
# slowly do not turn. Take twice the vector part, or the arc sine of its length.
#   gl-matrix, 0.01: angle 0.01001, axis 0 0 0.9993, to no rotation 0.01001, twice its z 0.01
#   gl-matrix, 0.001: angle 0.0009766, axis 0 0 1.024, to no rotation 0.0009766, twice its z 0.001
#   gl-matrix, 0.0001: angle 0, axis 1 0 0, to no rotation 0, twice its z 0.0001
#   gl-matrix, 0.00001: angle 0, axis 1 0 0, to no rotation 0, twice its z 0.00001
#   quaternion, 0.01: angle 0.01, axis 0 0 1, twice its z 0.01
#   quaternion, 0.0001: angle 0.0001, axis 0 0 1, twice its z 0.0001
#   quaternion, 0.000001: angle 0, axis 0 0 5e-7, twice its z 0.000001
#   quaternion, 1e-8: angle 0, axis 0 0 5e-9, twice its z 1e-8
#   transforms3d, 0.01: angle 0.01, axis 0 0 1, twice its z 0.01
#   transforms3d, 1e-06: angle 1e-06, axis 0 0 1, twice its z 1e-06
#   transforms3d, 1e-07: angle 9.884e-08, axis 0 0 1, twice its z 1e-07
#   transforms3d, 1e-08: angle 0, axis 0 0 1, twice its z 1e-08
set -euo pipefail
want=0.4+ds-2
version=$(dpkg-query -W -f='${Version}' python3-transforms3d 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-transforms3d $want, found '${version:-none}'"; exit 77; }
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . gl-matrix@3.4.4 quaternion@2.2.0 >/dev/null
cat > angles.mjs <<'NODE'
import { quat, vec3 } from 'gl-matrix';
import Quaternion from 'quaternion';
const four = (v) => Number(v.toPrecision(4));
for (const angle of [1e-2, 1e-3, 1e-4, 1e-5]) {
  const [q, axis] = [quat.setAxisAngle(quat.create(), [0, 0, 1], angle), vec3.create()];
  const seen = quat.getAxisAngle(axis, q);
  console.log(`gl-matrix, ${angle}: angle ${four(seen)}, axis ${Array.from(axis, four).join(' ')}, to no rotation ` +
    `${four(quat.getAngle(quat.create(), q))}, twice its z ${four(2 * q[2])}`);
}
for (const angle of [1e-2, 1e-4, 1e-6, 1e-8]) {
  const q = Quaternion.fromAxisAngle([0, 0, 1], angle);
  const [axis, seen] = q.toAxisAngle();
  console.log(`quaternion, ${angle}: angle ${four(seen)}, axis ${axis.map(four).join(' ')}, twice its z ${four(2 * q.z)}`);
}
NODE
cat > angles.py <<'PYTHON'
from transforms3d.quaternions import axangle2quat, quat2axangle

for angle in (1e-2, 1e-6, 1e-7, 1e-8):
    q = axangle2quat([0, 0, 1], angle)
    axis, seen = quat2axangle(q)
    print(f"transforms3d, {angle:g}: angle {seen:.4g}, axis {' '.join(f'{x:.4g}' for x in axis)}, twice its z {2 * q[3]:.4g}")
PYTHON
node angles.mjs > seen 2> messages || { cat messages; exit 1; }
/usr/bin/python3 angles.py >> seen
cat seen
diff seen - <<'SEEN'
gl-matrix, 0.01: angle 0.01001, axis 0 0 0.9993, to no rotation 0.01001, twice its z 0.01
gl-matrix, 0.001: angle 0.0009766, axis 0 0 1.024, to no rotation 0.0009766, twice its z 0.001
gl-matrix, 0.0001: angle 0, axis 1 0 0, to no rotation 0, twice its z 0.0001
gl-matrix, 0.00001: angle 0, axis 1 0 0, to no rotation 0, twice its z 0.00001
quaternion, 0.01: angle 0.01, axis 0 0 1, twice its z 0.01
quaternion, 0.0001: angle 0.0001, axis 0 0 1, twice its z 0.0001
quaternion, 0.000001: angle 0, axis 0 0 5e-7, twice its z 0.000001
quaternion, 1e-8: angle 0, axis 0 0 5e-9, twice its z 1e-8
transforms3d, 0.01: angle 0.01, axis 0 0 1, twice its z 0.01
transforms3d, 1e-06: angle 1e-06, axis 0 0 1, twice its z 1e-06
transforms3d, 1e-07: angle 9.884e-08, axis 0 0 1, twice its z 1e-07
transforms3d, 1e-08: angle 0, axis 0 0 1, twice its z 1e-08
SEEN
