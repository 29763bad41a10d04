// A ball of 10 mm radius, its upper half left out, on a disc of 10 mm radius and height: both halves
// of the section, with mesh lines on the axis x = 0 between them, for
//   gmsh -2 -order 1 -format msh41 -o ball.msh ball.geo
R = 10; fine = 0.02; coarse = 3; half = 0.25;
dip = R - Sqrt(R^2 - half^2);
Point(1) = {0, R, 0};
Point(2) = {-R, R, 0};
Point(3) = {-half, dip, 0};
Point(4) = {0, 0, 0};
Point(5) = {half, dip, 0};
Point(6) = {R, R, 0};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Circle(4) = {5, 1, 6};
Line(5) = {6, 1};
Line(6) = {1, 2};
Line(7) = {4, 1};
Curve Loop(1) = {3, 4, 5, -7};
Plane Surface(1) = {1};
Curve Loop(2) = {1, 2, 7, 6};
Plane Surface(2) = {2};

Point(11) = {-R, -R, 0};
Point(12) = {0, -R, 0};
Point(13) = {R, -R, 0};
Point(14) = {R, 0, 0};
Point(15) = {half, 0, 0};
Point(16) = {0, 0, 0};
Point(17) = {-half, 0, 0};
Point(18) = {-R, 0, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 15};
Line(15) = {15, 16};
Line(16) = {16, 17};
Line(17) = {17, 18};
Line(18) = {18, 11};
Line(19) = {12, 16};
Curve Loop(11) = {12, 13, 14, 15, -19};
Plane Surface(11) = {11};
Curve Loop(12) = {11, 19, 16, 17, 18};
Plane Surface(12) = {12};

Transfinite Curve {2, 3, 15, 16} = Round(half / fine) + 1;
Field[1] = Distance;
Field[1].CurvesList = {2, 3, 15, 16};
Field[1].NumPointsPerCurve = 400;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = fine;
Field[2].SizeMax = coarse;
Field[2].DistMin = 0.06;
Field[2].DistMax = 7;
Background Field = 2;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Algorithm = 6;
Recombine Surface {1, 2, 11, 12};

Physical Surface("upper") = {1, 2};
Physical Surface("lower") = {11, 12};
Physical Curve("upper.contact") = {2, 3};
Physical Curve("upper.fixed") = {5, 6};
Physical Curve("lower.contact") = {15, 16};
Physical Curve("lower.fixed") = {11, 12};
