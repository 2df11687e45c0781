#!/usr/bin/env bash
# Formulas: equal-style variables of LAMMPS 20220106, vtkArrayCalculator of VTK 9.1 with each of its two parsers, and Octave
# 7.3 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2, python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1, octave 7.3.0-2), for
# x = 2.
#
# Guess: -x^2 is -4, exp(-x^2/2) is 0.135 and 2^3^2 is 512, as on paper and in Octave's -x^2.
# Seen: in LAMMPS, and in VTK with its older parser (SetFunctionParserTypeToFunctionParser), the minus comes before the power:
# -x^2 is +4, and a Gaussian profile exp(-x^2/2) grows to 7.39, where 1-x^2 is -3. The other parser of VTK, its default for
# calculators, has -4. Powers of powers are taken from the left in LAMMPS, VTK's older parser and Octave, 64, and from the
# right in the other. A force field or an initial velocity pasted from one into the other has the other sign. Write -(x^2) or
# 0-x^2.
#   LAMMPS: -x^2 4, 1-x^2 -3, exp(-x^2/2) 7.389, -(x^2) -4, 2^3^2 64
#   VTK, FunctionParser: -x^2 4, 1-x^2 -3, exp(-x^2/2) 7.389, -(x^2) -4, 2^3^2 64
#   VTK, ExprTkFunctionParser: -x^2 -4, 1-x^2 -3, exp(-x^2/2) 0.1353, -(x^2) -4, 2^3^2 512
#   Octave: -x^2 -4, 1-x^2 -3, exp(-x^2/2) 0.1353, -(x^2) -4, 2^3^2 64
set -euo pipefail
for pair in lammps=20220106.git7586adbb6a+ds1-2+b2 python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1 octave=7.3.0-2; do
  name=${pair%%=*} want=${pair#*=}
  version=$(dpkg-query -W -f='${Version}' "$name" 2>/dev/null || true)
  [ "$version" = "$want" ] || { echo "needs $name $want, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > powers.in <<'IN'
variable x equal 2
variable a equal -v_x^2
variable b equal 1-v_x^2
variable c equal exp(-v_x^2/2)
variable d equal -(v_x^2)
variable e equal 2^3^2
print "SEEN LAMMPS: -x^2 $(v_a), 1-x^2 $(v_b), exp(-x^2/2) $(v_c:%.4g), -(x^2) $(v_d), 2^3^2 $(v_e)"
IN
cat > powers.py <<'PYTHON'
import vtk

formulas = ("-x^2", "1-x^2", "exp(-x^2/2)", "-(x^2)", "2^3^2+0*x")
for parser in ("FunctionParser", "ExprTkFunctionParser"):
    values = []
    for formula in formulas:
        points, x, data = vtk.vtkPoints(), vtk.vtkDoubleArray(), vtk.vtkPolyData()
        points.InsertNextPoint(0, 0, 0)
        x.InsertNextValue(2)
        x.SetName("x")
        data.SetPoints(points)
        data.GetPointData().AddArray(x)
        calculator = vtk.vtkArrayCalculator()
        calculator.SetInputData(data)
        getattr(calculator, "SetFunctionParserTypeTo" + parser)()
        calculator.AddScalarArrayName("x")
        calculator.SetFunction(formula)
        calculator.SetResultArrayName("result")
        calculator.Update()
        values.append(calculator.GetOutput().GetPointData().GetArray("result").GetValue(0))
    print(f"VTK, {parser}: " + ", ".join(f"{f.split('+')[0]} {v:.4g}" for f, v in zip(formulas, values)))
PYTHON
cat > powers.m <<'OCTAVE'
x = 2;
printf("Octave: -x^2 %g, 1-x^2 %g, exp(-x^2/2) %.4g, -(x^2) %g, 2^3^2 %g\n", -x^2, 1-x^2, exp(-x^2/2), -(x^2), 2^3^2);
OCTAVE
{
  lmp -in powers.in -log none | sed -n 's/^SEEN //p'
  /usr/bin/python3 powers.py
  octave-cli -q powers.m
} > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
LAMMPS: -x^2 4, 1-x^2 -3, exp(-x^2/2) 7.389, -(x^2) -4, 2^3^2 64
VTK, FunctionParser: -x^2 4, 1-x^2 -3, exp(-x^2/2) 7.389, -(x^2) -4, 2^3^2 64
VTK, ExprTkFunctionParser: -x^2 -4, 1-x^2 -3, exp(-x^2/2) 0.1353, -(x^2) -4, 2^3^2 512
Octave: -x^2 -4, 1-x^2 -3, exp(-x^2/2) 0.1353, -(x^2) -4, 2^3^2 64
SEEN
