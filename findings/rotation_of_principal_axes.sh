#!/usr/bin/env bash
# SciPy 1.10.1, transforms3d 0.4 and quaternion 2.4.0 of Octave (Debian 12: python3-scipy 1.10.1-2, python3-transforms3d 0.4+ds-2,
# octave-quaternion 2.4.0-10): the orientation of a grain from its principal axes. The moments are 1, 2, 3, the axes are the
# eigenvectors of the tensor of inertia, by eigh or eig, and go to from_matrix, mat2quat and rotm2q as they are.
#
# Guess: the rotation has these axes, or an error says that the matrix is none.
# Seen: for a third of the grains the three eigenvectors are left-handed, and all three functions return a rotation whose axes are
# others, 44 to 61 degrees off on average: the tensor that is made from it with the same moments is wrong by as much as 2. No
# word of any. Reverse one axis where the determinant is negative.
#   SciPy: left-handed 0.33, wrong of these 1.00, of others 0.00, axes off by 61 degrees, tensor by up to 2.0
#   transforms3d: left-handed 0.33, wrong of these 1.00, of others 0.00, axes off by 44 degrees, tensor by up to 1.9
#   Octave: left-handed 0.33, wrong of these 1.00, of others 0.00, axes off by 49 degrees, tensor by up to 1.9
set -euo pipefail
for want in python3-scipy=1.10.1-2 python3-transforms3d=0.4+ds-2 octave-quaternion=2.4.0-10; do
  version=$(dpkg-query -W -f='${Version}' "${want%%=*}" 2>/dev/null || true)
  [ "$version" = "${want#*=}" ] || { echo "needs ${want%%=*} ${want#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > axes.py <<'PYTHON'
import numpy
from scipy.spatial.transform import Rotation
from transforms3d.quaternions import mat2quat, quat2mat

moments = numpy.diag([1.0, 2.0, 3.0])
turns = Rotation.random(300, random_state=1).as_matrix()
tensors = turns @ moments @ turns.transpose(0, 2, 1)
tensors = (tensors + tensors.transpose(0, 2, 1)) / 2
numpy.savetxt("tensors", tensors.reshape(-1, 9), fmt="%.17g")
axes = numpy.linalg.eigh(tensors)[1]
left = numpy.linalg.det(axes) < 0
for name, made in (("SciPy", Rotation.from_matrix(axes).as_matrix()),
                   ("transforms3d", numpy.array([quat2mat(mat2quat(matrix)) for matrix in axes]))):
    wrong = abs(made @ moments @ made.transpose(0, 2, 1) - tensors).max(axis=(1, 2))
    angles = numpy.degrees(numpy.arccos(numpy.minimum(1, abs((made * axes).sum(axis=1)))))
    print(f"{name}: left-handed {left.mean():.2f}, wrong of these {(wrong[left] > 1e-6).mean():.2f}, of others "
          f"{(wrong[~left] > 1e-6).mean():.2f}, axes off by {angles[left].mean():.0f} degrees, tensor by up to "
          f"{wrong.max():.1f}")
PYTHON
cat > axes.m <<'OCTAVE'
pkg load quaternion
part = @(q) [q.x; q.y; q.z];
wrong = left = angles = [];
for row = load("tensors")'
  tensor = reshape(row, 3, 3);
  [axes, ~] = eig(tensor);
  q = unit(rotm2q(axes));
  made = [part(q * quaternion(0, 1, 0, 0) * q'), part(q * quaternion(0, 0, 1, 0) * q'), part(q * quaternion(0, 0, 0, 1) * q')];
  wrong(end + 1) = max(max(abs(made * diag([1 2 3]) * made' - tensor)));
  left(end + 1) = det(axes) < 0;
  angles(end + 1) = mean(acosd(min(1, abs(sum(made .* axes)))));
end
left = logical(left);
printf("Octave: left-handed %.2f, wrong of these %.2f, of others %.2f, axes off by %.0f degrees, tensor by up to %.1f\n",
       mean(left), mean(wrong(left) > 1e-6), mean(wrong(!left) > 1e-6), mean(angles(left)), max(wrong));
OCTAVE
/usr/bin/python3 axes.py > seen
octave-cli -q axes.m >> seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
SciPy: left-handed 0.33, wrong of these 1.00, of others 0.00, axes off by 61 degrees, tensor by up to 2.0
transforms3d: left-handed 0.33, wrong of these 1.00, of others 0.00, axes off by 44 degrees, tensor by up to 1.9
Octave: left-handed 0.33, wrong of these 1.00, of others 0.00, axes off by 49 degrees, tensor by up to 1.9
SEEN
