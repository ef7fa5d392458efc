// Sizes that ask for four thousand million boundary points.
Point(1) = {0, 0, 0, 1e-9};
Point(2) = {1, 0, 0, 1e-9};
Point(3) = {1, 1, 0, 1e-9};
Point(4) = {0, 1, 0, 1e-9};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
