// All points of the loop lie on one line.
Point(1) = {0, 0, 0};
Point(2) = {1, 0.5, 0};
Point(3) = {2, 1, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
