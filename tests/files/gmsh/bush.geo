// A pin of 9.95 mm, held by a hub, in a bush of 10 to 20 mm, for
//   gmsh -2 -order 1 -format msh41 -o bush.msh bush.geo
// Contact curves reach 40 degrees to either side; model{} is told the radii by body.disc and body.ring.
r = 9.95; R = 10; outer = 20; hub = 1.5; reach = 40 * Pi / 180; fine = 0.2; coarse = 4;

// The pin's centre is at (0, r), the bush's at (0, R): they touch at the origin.
Point(1) = {0, r, 0};
Point(2) = {0, 0, 0};
Point(3) = {r * Sin(reach), r - r * Cos(reach), 0};
Point(4) = {0, 2 * r, 0};
Point(5) = {-r * Sin(reach), r - r * Cos(reach), 0};
Point(6) = {hub, r, 0};
Point(7) = {0, r + hub, 0};
Point(8) = {-hub, r, 0};
Point(9) = {0, r - hub, 0};
Circle(1) = {5, 1, 2};
Circle(2) = {2, 1, 3};
Circle(3) = {3, 1, 4};
Circle(4) = {4, 1, 5};
Circle(5) = {6, 1, 7};
Circle(6) = {7, 1, 8};
Circle(7) = {8, 1, 9};
Circle(8) = {9, 1, 6};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(1) = {1, 2};

Point(11) = {0, R, 0};
Point(12) = {0, 0, 0};
Point(13) = {R * Sin(reach), R - R * Cos(reach), 0};
Point(14) = {0, 2 * R, 0};
Point(15) = {-R * Sin(reach), R - R * Cos(reach), 0};
Point(16) = {0, R - outer, 0};
Point(17) = {outer, R, 0};
Point(18) = {0, R + outer, 0};
Point(19) = {-outer, R, 0};
Circle(11) = {15, 11, 12};
Circle(12) = {12, 11, 13};
Circle(13) = {13, 11, 14};
Circle(14) = {14, 11, 15};
Circle(15) = {16, 11, 17};
Circle(16) = {17, 11, 18};
Circle(17) = {18, 11, 19};
Circle(18) = {19, 11, 16};
Curve Loop(3) = {15, 16, 17, 18};
Curve Loop(4) = {11, 12, 13, 14};
Plane Surface(2) = {3, 4};

Transfinite Curve {1, 2, 11, 12} = Round(R * reach / fine) + 1;
Field[1] = Distance;
Field[1].CurvesList = {1, 2, 11, 12};
Field[1].NumPointsPerCurve = 200;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = fine;
Field[2].SizeMax = coarse;
Field[2].DistMin = 0.4;
Field[2].DistMax = 9.3;
Background Field = 2;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Algorithm = 6;
Recombine Surface {1, 2};

Physical Surface("upper") = {1};
Physical Surface("lower") = {2};
Physical Curve("upper.contact") = {1, 2};
Physical Curve("upper.fixed") = {5, 6, 7, 8};
Physical Curve("lower.contact") = {11, 12};
Physical Curve("lower.fixed") = {15, 16, 17, 18};
