#!/usr/bin/env bash
# Mol* 4.18.0 (npm: molstar) reading a LAMMPS text dump: the rows of later frames, and a sheared cell.
#
# Guess: particles are matched by their id, as LAMMPS writes rows in no order unless told so; scaled coordinates are taken
# along the vectors of the cell.
# Seen: rows are matched by place: where the rows of the second frame are in another order, the particles have swapped
# positions under the ids and types of the first frame, and a film of particles at rest shows them jump. Scaled coordinates
# are taken along the bounding box of a sheared cell: (0.5, 0) of a cell of length 10 is at 7. Use dump_modify sort id, scale no.
#   frame 0: ids 1,2 x 1,5
#   frame 1: ids 1,2 x 5,1
#   sheared: x 0,7
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . molstar@4.18.0 >/dev/null
cat > read.cjs <<'NODE'
const { parseLammpsTrajectory } = require('molstar/lib/commonjs/mol-io/reader/lammps/traj/parser');
const { trajectoryFromLammpsTrajectory } = require('molstar/lib/commonjs/mol-model-formats/structure/lammps-trajectory');
const frame = (step, bounds, columns, rows) => `ITEM: TIMESTEP\n${step}\nITEM: NUMBER OF ATOMS\n2\n` +
  `ITEM: BOX BOUNDS ${bounds}\nITEM: ATOMS id type ${columns}\n${rows}\n`;
const models = async (text) => {
  const file = (await parseLammpsTrajectory(text).run()).result;
  const trajectory = await trajectoryFromLammpsTrajectory(file, 'lj').run();
  const all = [];
  for (let i = 0; i < trajectory.frameCount; ++i) {
    const { atomId, x } = (await trajectory.getFrameAtIndex(i)).atomicConformation;
    all.push([Array.from(atomId.toArray()), Array.from(x)]);
  }
  return all;
};
(async () => {
  const flat = 'pp pp pp\n0 10\n0 8\n0 1';
  const film = await models(frame(0, flat, 'x y z', '1 1 1 1 0\n2 1 5 5 0') + frame(10, flat, 'x y z', '2 1 5 5 0\n1 1 1 1 0'));
  film.forEach(([ids, x], i) => console.log(`frame ${i}: ids ${ids} x ${x}`));
  const sheared = 'xy xz yz pp pp pp\n0 14 4\n0 8 0\n0 1 0';
  const [[, x]] = await models(frame(0, sheared, 'xs ys zs', '1 1 0 0 0\n2 1 0.5 0 0'));
  console.log(`sheared: x ${x}`);
})();
NODE
node read.cjs > seen
cat seen
diff seen - <<'SEEN'
frame 0: ids 1,2 x 1,5
frame 1: ids 1,2 x 5,1
sheared: x 0,7
SEEN
