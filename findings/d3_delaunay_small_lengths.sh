#!/usr/bin/env bash
# d3-delaunay 6.0.6 and voronoi 1.0.0 (npm): Voronoi cells of 200 grains in a square of side L, clipped to it; local packing
# fractions are their areas.
#
# Guess: cells of L = 1e-6 are those of L = 1, a millionth in size.
# Seen: with d3-delaunay 44 of 200 cells are wrong at L = 1e-3 and their areas add up to 1.83 L^2; from L = 1e-4 on one grain has
# the whole square, and cellPolygon of all others is null. Triangles of an area below 5e-10 count as collinear. The triangulation
# itself is right. With voronoi all cells are wrong at 1e-6, and add up to 120 L^2; in between it may throw. Scale positions so
# that the mean distance is about 1, and add up the areas.
#   d3-delaunay, L = 1: 0 wrong, 0 of them without a cell, sum 1.000
#   d3-delaunay, L = 0.01: 0 wrong, 0 of them without a cell, sum 1.000
#   d3-delaunay, L = 0.001: 44 wrong, 2 of them without a cell, sum 1.826
#   d3-delaunay, L = 0.0001: 200 wrong, 199 of them without a cell, sum 1.000
#   d3-delaunay, L = 0.00001: 200 wrong, 199 of them without a cell, sum 1.000
#   d3-delaunay, L = 0.000001: 200 wrong, 199 of them without a cell, sum 1.000
#   voronoi, L = 1: 0 wrong, 0 of them without a cell, sum 1.000
#   voronoi, L = 0.01: 0 wrong, 0 of them without a cell, sum 1.000
#   voronoi, L = 0.001: 0 wrong, 0 of them without a cell, sum 1.000
#   voronoi, L = 0.000001: 200 wrong, 0 of them without a cell, sum 120.040
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . d3-delaunay@6.0.6 voronoi@1.0.0 >/dev/null
cat > cells.mjs <<'NODE'
import { Delaunay } from 'd3-delaunay';
import Voronoi from 'voronoi';
let state = 1;
const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
const places = Array.from({ length: 200 }, () => [random(), random()]);
const area = (edges) => Math.abs(edges.reduce((sum, [a, b]) => sum + (a[0] * b[1] - b[0] * a[1]) / 2, 0));
const byD3 = (L) => {
  const voronoi = Delaunay.from(places.map(([x, y]) => [x * L, y * L])).voronoi([0, 0, L, L]);
  return places.map((_, i) => {
    const corners = voronoi.cellPolygon(i);
    return corners ? area(corners.slice(1).map((b, k) => [corners[k], b])) / L ** 2 : 0;
  });
};
const byVoronoi = (L) => {
  const sites = places.map(([x, y]) => ({ x: x * L, y: y * L }));
  const areas = new Array(200).fill(0);
  for (const { site, halfedges } of new Voronoi().compute(sites, { xl: 0, xr: L, yt: 0, yb: L }).cells) {
    const ends = halfedges.map((edge) => [edge.getStartpoint(), edge.getEndpoint()].map(({ x, y }) => [x, y]));
    areas[sites.findIndex(({ x, y }) => x === site.x && y === site.y)] = area(ends) / L ** 2;
  }
  return areas;
};
const show = (name, cells, scales) => {
  const right = cells(1);
  for (const L of scales) {
    const areas = cells(L);
    const wrong = areas.filter((each, i) => Math.abs(each - right[i]) > 1e-3 * right[i]).length;
    const none = areas.filter((each) => each === 0).length;
    console.log(`${name}, L = ${L}: ${wrong} wrong, ${none} of them without a cell, sum ${areas.reduce((a, b) => a + b).toFixed(3)}`);
  }
};
show('d3-delaunay', byD3, [1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6]);
show('voronoi', byVoronoi, [1, 1e-2, 1e-3, 1e-6]);
NODE
timeout 30 node cells.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
d3-delaunay, L = 1: 0 wrong, 0 of them without a cell, sum 1.000
d3-delaunay, L = 0.01: 0 wrong, 0 of them without a cell, sum 1.000
d3-delaunay, L = 0.001: 44 wrong, 2 of them without a cell, sum 1.826
d3-delaunay, L = 0.0001: 200 wrong, 199 of them without a cell, sum 1.000
d3-delaunay, L = 0.00001: 200 wrong, 199 of them without a cell, sum 1.000
d3-delaunay, L = 0.000001: 200 wrong, 199 of them without a cell, sum 1.000
voronoi, L = 1: 0 wrong, 0 of them without a cell, sum 1.000
voronoi, L = 0.01: 0 wrong, 0 of them without a cell, sum 1.000
voronoi, L = 0.001: 0 wrong, 0 of them without a cell, sum 1.000
voronoi, L = 0.000001: 200 wrong, 0 of them without a cell, sum 120.040
SEEN
