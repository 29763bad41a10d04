// A half cylinder of 10 mm radius with a coat of 0.1 mm on a block of 20 x 10 mm, for
//   gmsh -2 -order 1 -format msh41 -o coat.msh coat.geo
// The coat, upper.coat, goes round as far as half an arc of 1.2 mm to either side; what is beyond is
// far from the contact and of the body's own material.
R = 10; thick = 0.1; high = 10; wide = 10; fine = 0.015; coarse = 3; reach = 0.25;
half = 0.25 / R; end = 1.2 / R; // angles
in = R - thick;
Point(1) = {0, R, 0};
Point(2) = {-R, R, 0};
Point(3) = {-R * Sin(end), R - R * Cos(end), 0};
Point(4) = {-R * Sin(half), R - R * Cos(half), 0};
Point(5) = {0, 0, 0};
Point(6) = {R * Sin(half), R - R * Cos(half), 0};
Point(7) = {R * Sin(end), R - R * Cos(end), 0};
Point(8) = {R, R, 0};
Point(9) = {-in * Sin(end), R - in * Cos(end), 0};
Point(10) = {in * Sin(end), R - in * Cos(end), 0};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Circle(4) = {5, 1, 6};
Circle(5) = {6, 1, 7};
Circle(6) = {7, 1, 8};
Line(7) = {8, 1};
Line(8) = {1, 2};
Line(9) = {7, 10};
Circle(10) = {9, 1, 10};
Line(18) = {3, 9};
Curve Loop(1) = {1, 18, 10, -9, 6, 7, 8};
Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, 5, 9, -10, -18};
Plane Surface(2) = {2};
Physical Surface("upper") = {1};
Physical Surface("upper.coat") = {2};
Physical Curve("upper.contact") = {3, 4};
Physical Curve("upper.fixed") = {7, 8};

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

Transfinite Curve {3, 4} = Round(R * half / fine) + 1;
Transfinite Curve {14, 15} = Round(reach / fine) + 1;

Field[1] = Distance;
Field[1].CurvesList = {3, 4, 14, 15};
Field[1].NumPointsPerCurve = 400;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = fine;
Field[2].SizeMax = coarse;
Field[2].DistMin = 0.06;
Field[2].DistMax = 6.7;
Background Field = 2;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Algorithm = 6;
Recombine Surface {1, 2, 11};
