// A block of 2 x 1 mm with waves, 0.1 mm long and 0.1 um high to either side, on a flat one, for
//   gmsh -2 -order 1 -format msh41 -o waves.msh waves.geo
length = 0.1; height = 1e-4; high = 1; wide = 1; coarse = 0.5; reach = 0.45;
crests = 7; each = 10; // waves in contact, elements a wave
fine = length / each;
n = crests * each;
For i In {0 : n}
  x = (i - n / 2) * fine;
  Point(1000 + i) = {x, height * (1 - Cos(2 * Pi * x / length)), 0};
EndFor
For i In {0 : n - 1}
  Line(1000 + i) = {1000 + i, 1001 + i};
  Transfinite Curve {1000 + i} = 2;
EndFor
Point(1) = {wide, 0.5 * high, 0};
Point(2) = {wide, high, 0};
Point(3) = {-wide, high, 0};
Point(4) = {-wide, 0.5 * high, 0};
Line(1) = {1000 + n, 1};
Line(2) = {1, 2};
Line(3) = {2, 3};
Line(4) = {3, 4};
Line(5) = {4, 1000};
Curve Loop(1) = {1000 : 1000 + n - 1, 1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Physical Surface("upper") = {1};
Physical Curve("upper.contact") = {1000 : 1000 + n - 1};
Physical Curve("upper.fixed") = {3};

Point(11) = {-wide, -high, 0};
Point(12) = {wide, -high, 0};
Point(13) = {wide, 0, 0};
Point(14) = {reach, 0, 0};
Point(15) = {0, 0, 0};
Point(16) = {-reach, 0, 0};
Point(17) = {-wide, 0, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 15};
Line(15) = {15, 16};
Line(16) = {16, 17};
Line(17) = {17, 11};
Curve Loop(11) = {11, 12, 13, 14, 15, 16, 17};
Plane Surface(11) = {11};
Physical Surface("lower") = {11};
Physical Curve("lower.contact") = {14, 15};
Physical Curve("lower.fixed") = {11};

Transfinite Curve {14, 15} = Round(reach / fine) + 1;

Field[1] = Distance;
Field[1].CurvesList = {1000 : 1000 + n - 1, 14, 15};
Field[1].NumPointsPerCurve = 400;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = fine;
Field[2].SizeMax = coarse;
Field[2].DistMin = 0.02;
Field[2].DistMax = 1.2;
Background Field = 2;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Algorithm = 6;
Recombine Surface {1, 11};
