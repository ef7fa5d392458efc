// Two flat arcs and the chord between them share both ends: in one piece each they would be one edge.

Point(1) = {-1, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {0, -3, 0};
Point(4) = {0, 3, 0};
Circle(1) = {1, 3, 2};  // above the chord
Circle(2) = {1, 4, 2};  // below it
Line(3) = {1, 2};
Curve Loop(1) = {1, -3};
Curve Loop(2) = {3, -2};
Plane Surface(1) = {1};
Plane Surface(2) = {2};

Physical Surface("upper", 1) = {1};
Physical Surface("lower", 2) = {2};
Physical Curve("chord", 1) = {3};
Physical Curve("arcs", 2) = {1, 2};
