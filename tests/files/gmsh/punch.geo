// A punch with a flat of 1 mm and edges of 2 mm radius on a block of 20 x 10 mm, for
//   gmsh -2 -order 1 -format msh41 -o punch.msh punch.geo
flat = 0.5; R = 2; high = 10; wide = 10; fine = 0.02; coarse = 3; reach = 0.68;
half = 0.66; // of the contact curves; beyond it the edges go on to flat + R
dip = R - Sqrt(R^2 - (half - flat)^2);
Point(1) = {-flat, 0, 0};
Point(2) = {0, 0, 0};
Point(3) = {flat, 0, 0};
Point(4) = {flat, R, 0};
Point(5) = {-flat, R, 0};
Point(6) = {half, dip, 0};
Point(7) = {-half, dip, 0};
Point(8) = {flat + R, R, 0};
Point(9) = {-flat - R, R, 0};
Point(10) = {flat + R, high, 0};
Point(20) = {-flat - R, high, 0};
Circle(1) = {7, 5, 1};
Line(2) = {1, 2};
Line(3) = {2, 3};
Circle(4) = {3, 4, 6};
Circle(5) = {6, 4, 8};
Line(6) = {8, 10};
Line(7) = {10, 20};
Line(8) = {20, 9};
Circle(9) = {9, 5, 7};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8, 9};
Plane Surface(1) = {1};
Physical Surface("upper") = {1};
Physical Curve("upper.contact") = {1, 2, 3, 4};
Physical Curve("upper.fixed") = {7};

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

Transfinite Curve {2, 3} = Round(flat / fine) + 1;
Transfinite Curve {1, 4} = Round((half - flat) / fine) + 1;
Transfinite Curve {14, 15} = Round(reach / fine) + 1;

Field[1] = Distance;
Field[1].CurvesList = {1, 2, 3, 4, 14, 15};
Field[1].NumPointsPerCurve = 400;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = fine;
Field[2].SizeMax = coarse;
Field[2].DistMin = 0.04;
Field[2].DistMax = 6.7;
Background Field = 2;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Algorithm = 6;
Recombine Surface {1, 11};
