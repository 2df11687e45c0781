#!/usr/bin/env bash
# gmsh 4.8.4 (Debian 12: python3-gmsh 4.8.4+ds2-3) with its OpenCASCADE kernel: union and overlap of two equal discs whose
# centres are 1.3 radii apart, as the solid part of a packing is built before meshing.
#
# Guess: areas by the square of the radius, at every radius, or an error where a length is too small.
# Seen: right down to a radius of 1e-5. At 1e-6 the discs stay two and have no overlap, at 1e-7 it is an error, at 1e-8 they are
# one and the same disc: lengths below 1e-7 are none for OpenCASCADE, whatever the unit. Micrometres in metres lose their
# overlaps. A gap or an overlap of 1e-7 between discs of radius 1 is gone likewise. Build in diameters, scale the mesh.
#   radius 1: union 1 of area 5.5447, overlap 1 of area 0.7385
#   radius 1e-05: union 1 of area 5.5447, overlap 1 of area 0.7385
#   radius 1e-06: union 2 of area 6.2832, overlap 0 of area 0.0000
#   radius 1e-07: union error, overlap error
#   radius 1e-08: union 1 of area 3.1416, overlap 1 of area 3.1416
set -euo pipefail
want=4.8.4+ds2-3
version=$(dpkg-query -W -f='${Version}' python3-gmsh 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-gmsh $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - > seen <<'PYTHON'
import gmsh

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
occ = gmsh.model.occ


def pieces(radius, operation):
    gmsh.model.add("discs")
    discs = [[(2, occ.addDisk(x * radius, 0, 0, radius, radius))] for x in (0, 1.3)]
    try:
        result, _ = operation(*discs)
        return f"{len(result)} of area {sum(occ.getMass(*each) for each in result) / radius**2:.4f}"
    except Exception:
        return "error"
    finally:
        gmsh.model.remove()


for radius in (1, 1e-5, 1e-6, 1e-7, 1e-8):
    print(f"radius {radius}: union {pieces(radius, occ.fuse)}, overlap {pieces(radius, occ.intersect)}")
PYTHON
cat seen
diff seen - <<'SEEN'
radius 1: union 1 of area 5.5447, overlap 1 of area 0.7385
radius 1e-05: union 1 of area 5.5447, overlap 1 of area 0.7385
radius 1e-06: union 2 of area 6.2832, overlap 0 of area 0.0000
radius 1e-07: union error, overlap error
radius 1e-08: union 1 of area 3.1416, overlap 1 of area 3.1416
SEEN
