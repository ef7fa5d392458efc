// A wedge with an angle of 3 degrees that no refinement can improve.

h = 10 * Tan(3 * Pi / 180);
Point(1) = {0, 0, 0};
Point(2) = {10, 0, 0};
Point(3) = {10, h, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};

Physical Surface("wedge", 1) = {1};
Physical Curve("sides", 1) = {1, 3};
Physical Curve("end", 2) = {2};
