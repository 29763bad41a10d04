// A half cylinder of radius 10 mm on a plate of 20 x 10 mm, as model{} has them, for
//   gmsh -2 -order 1 -format msh41 -o gmsh_pair.msh gmsh_pair.geo
// Units are mm. The bodies have points of their own where they touch, and physical groups name
// what is what: surfaces upper and lower, curves upper.contact, upper.fixed and so on.
R = 10; fine = 0.02; coarse = 2;
half = 0.5;   // half the candidate contact zone of the cylinder
reach = 0.6;  // and of the plate
dip = R - Sqrt(R^2 - half^2);

// The cylinder: its arc, and the flat top that is built in.
Point(1) = {0, R, 0, coarse};
Point(2) = {-R, R, 0, coarse};
Point(3) = {-half, dip, 0, fine};
Point(4) = {0, 0, 0, fine};
Point(5) = {half, dip, 0, fine};
Point(6) = {R, R, 0, coarse};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Circle(4) = {5, 1, 6};
Line(5) = {6, 1};
Line(6) = {1, 2};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};

// The plate: its base is built in.
Point(11) = {-R, -R, 0, coarse};
Point(12) = {R, -R, 0, coarse};
Point(13) = {R, 0, 0, coarse};
Point(14) = {reach, 0, 0, fine};
Point(15) = {0, 0, 0, fine};
Point(16) = {-reach, 0, 0, fine};
Point(17) = {-R, 0, 0, coarse};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 15};
Line(15) = {15, 16};
Line(16) = {16, 17};
Line(17) = {17, 11};
Curve Loop(2) = {11, 12, 13, 14, 15, 16, 17};
Plane Surface(2) = {2};

Transfinite Curve {2, 3} = Round(half / fine) + 1;
Transfinite Curve {14, 15} = Round(reach / fine) + 1;

// Fine down to half the contact's width below the surface, then ever coarser.
Field[1] = Distance;
Field[1].CurvesList = {2, 3, 14, 15};
Field[1].NumPointsPerCurve = 200;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = fine;
Field[2].SizeMax = coarse;
Field[2].DistMin = 0.1;
Field[2].DistMax = 10;
Background Field = 2;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Algorithm = 6;
Recombine Surface {1, 2};

Physical Surface("upper") = {1};
Physical Surface("lower") = {2};
Physical Curve("upper.contact") = {2, 3};
Physical Curve("upper.fixed") = {5, 6};
Physical Curve("lower.contact") = {14, 15};
Physical Curve("lower.fixed") = {11};
