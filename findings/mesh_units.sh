#!/usr/bin/env bash
# Meshes with units: a cube with a side of 1 in files that say micron, millimeter, inch and meter, as 3MF, as AMF, and as COLLADA
# (<unit meter="...">), read by OpenSCAD 2021.01 and Assimp 5.2.5 (Debian 12: openscad 2021.01-6, assimp-utils 5.2.5~ds0-1+b1).
#
# Guess: the four cubes differ by the factors of their units, in whatever unit the program works.
# Seen: a 3MF or AMF file has a side of 1 in both programs, in a micrometre as in a metre, without a word: the unit is not read.
# So a grain in inches and one in millimetres from two tomographs are put into one packing with a factor of 25.4, and a file
# of OpenSCAD has millimetres in it, whatever was in the one before. Of a COLLADA file Assimp has metres, as it should.
#   OpenSCAD, 3MF: micron 1, millimeter 1, inch 1, meter 1
#   OpenSCAD, AMF: micron 1, millimeter 1, inch 1, meter 1
#   Assimp, 3MF: micron 1, millimeter 1, inch 1, meter 1
#   Assimp, AMF: micron 1, millimeter 1, inch 1, meter 1
#   Assimp, COLLADA: micron 1e-06, millimeter 0.001, inch 0.0254, meter 1
set -euo pipefail
for pair in openscad=2021.01-6 assimp-utils=5.2.5~ds0-1+b1; do
  name=${pair%%=*} want=${pair#*=}
  version=$(dpkg-query -W -f='${Version}' "$name" 2>/dev/null || true)
  [ "$version" = "$want" ] || { echo "needs $name $want, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > units.py <<'PYTHON'
import subprocess
import zipfile

units = {"micron": 1e-6, "millimeter": 1e-3, "inch": 0.0254, "meter": 1}
points = [(a, b, c) for c in (0, 1) for b in (0, 1) for a in (0, 1)]
squares = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6))
triangles = [three for a, b, c, d in squares for three in ((a, b, c), (a, c, d))]
head = '<?xml version="1.0" encoding="UTF-8"?>'
types = "application/vnd.ms-package.3dmanufacturing-3dmodel+xml"
package = "http://schemas.openxmlformats.org/package/2006/"


def write(unit):
    vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in points)
    faces = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in triangles)
    with zipfile.ZipFile(f"{unit}.3mf", "w") as file:
        file.writestr("[Content_Types].xml", f'{head}<Types xmlns="{package}content-types"><Default Extension="rels" ContentType='
                      '"application/vnd.openxmlformats-package.relationships+xml"/>'
                      f'<Default Extension="model" ContentType="{types}"/></Types>')
        file.writestr("_rels/.rels", f'{head}<Relationships xmlns="{package}relationships"><Relationship Id="a" Target='
                      '"/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
        file.writestr("3D/3dmodel.model", f'{head}<model unit="{unit}" xml:lang="en-US" '
                      'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model">'
                      f"<mesh><vertices>{vertices}</vertices><triangles>{faces}</triangles></mesh></object></resources>"
                      '<build><item objectid="1"/></build></model>')
    vertices = "".join(f"<vertex><coordinates><x>{x}</x><y>{y}</y><z>{z}</z></coordinates></vertex>" for x, y, z in points)
    faces = "".join(f"<triangle><v1>{a}</v1><v2>{b}</v2><v3>{c}</v3></triangle>" for a, b, c in triangles)
    open(f"{unit}.amf", "w").write(f'{head}<amf unit="{unit}" version="1.1"><object id="0"><mesh><vertices>{vertices}</vertices>'
                                   f"<volume>{faces}</volume></mesh></object></amf>")
    flat = [" ".join(str(x) for row in rows for x in row) for rows in (points, triangles)]
    open(f"{unit}.dae", "w").write(
        f'{head}<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>'
        "<created>2020-01-01T00:00:00Z</created><modified>2020-01-01T00:00:00Z</modified>"
        f'<unit name="{unit}" meter="{units[unit]}"/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh>'
        f'<source id="p"><float_array id="n" count="24">{flat[0]}</float_array><technique_common><accessor source="#n" count="8" '
        'stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>'
        '</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="12">'
        f'<input semantic="VERTEX" source="#v" offset="0"/><p>{flat[1]}</p></triangles></mesh></geometry></library_geometries>'
        '<library_visual_scenes><visual_scene id="s"><node id="d"><instance_geometry url="#g"/></node></visual_scene>'
        '</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>')


def openscad(file):
    open("import.scad", "w").write(f'import("{file}");')
    subprocess.run(["openscad", "-o", "out.off", "import.scad"], check=True, capture_output=True)
    rows = [row.split() for row in open("out.off").read().split("\n")[1:]]
    return max(float(row[0]) for row in rows if len(row) == 3)


def assimp(file):
    subprocess.run(["assimp", "export", file, "out.obj"], check=True, capture_output=True)
    return max(float(row.split()[1]) for row in open("out.obj") if row.startswith("v "))


for unit in units:
    write(unit)
names = {"3mf": "3MF", "amf": "AMF", "dae": "COLLADA"}
for program, read, kinds in (("OpenSCAD", openscad, ("3mf", "amf")), ("Assimp", assimp, ("3mf", "amf", "dae"))):
    for kind in kinds:
        print(f"{program}, {names[kind]}: " + ", ".join(f"{unit} {read(f'{unit}.{kind}'):g}" for unit in units))
PYTHON
/usr/bin/python3 units.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
OpenSCAD, 3MF: micron 1, millimeter 1, inch 1, meter 1
OpenSCAD, AMF: micron 1, millimeter 1, inch 1, meter 1
Assimp, 3MF: micron 1, millimeter 1, inch 1, meter 1
Assimp, AMF: micron 1, millimeter 1, inch 1, meter 1
Assimp, COLLADA: micron 1e-06, millimeter 0.001, inch 0.0254, meter 1
SEEN
