#!/usr/bin/env bash
# 3Dmol.js 2.5.5 (npm: 3dmol) reading an extended XYZ film of two frames, each with its own cell and columns for radius, id and
# mass, as a compression gives it.
#
# Guess: two models, each with its cell; columns beyond the positions are ignored or go by their names.
# Seen: three models, the last one empty (addModelsAsFrames then has a blank frame). There is one cell for all, that of the last
# frame, so the cell does not move while the particles do. Where a line has seven numbers or more, the three behind the
# position are an arrow (dx, dy, dz), whatever `Properties` calls them. Give it forces or nothing there, and one frame a model.
#   models: 3, particles 2,2,0
#   cells: 12,10,1
#   arrow of the first particle: 0.5,7,3
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . 3dmol@2.5.5 >/dev/null
cat > read.cjs <<'NODE'
global.window = global.self = global;  // what the library looks for when it is loaded
global.navigator ??= { userAgent: '' };
global.document = { createElement: () => ({ style: {}, getContext: () => null }), addEventListener() {},
                    getElementsByClassName: () => [], body: {} };
const { Parsers } = require('3dmol/build/3Dmol.js');
const frame = (length) => `2
Lattice="${length} 0 0 0 10 0 0 0 1" Properties=species:S:1:pos:R:3:radius:R:1:id:I:1:mass:R:1
A 1 1 0 0.5 7 3
B 2 2 0 0.5 8 3
`;
const models = Parsers.xyz(frame(11) + frame(12), { multimodel: true, assignBonds: false });
console.log(`models: ${models.length}, particles ${models.map((atoms) => atoms.length)}`);
console.log(`cells: ${models.modelData.map(({ cryst }) => [0, 4, 8].map((i) => cryst.matrix.elements[i])).join(' and ')}`);
const { dx, dy, dz } = models[0][0];
console.log(`arrow of the first particle: ${[dx, dy, dz]}`);
NODE
node read.cjs > seen
cat seen
diff seen - <<'SEEN'
models: 3, particles 2,2,0
cells: 12,10,1
arrow of the first particle: 0.5,7,3
SEEN
