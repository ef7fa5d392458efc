// A ring between two circles: all of the boundary is curved.

Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {-1, 0, 0};
Point(4) = {0.4, 0, 0};
Point(5) = {-0.4, 0, 0};
Point(6) = {0, 1, 0};
Point(7) = {0, -1, 0};
Circle(1) = {2, 1, 6};
Circle(2) = {6, 1, 3};
Circle(3) = {3, 1, 7};
Circle(4) = {7, 1, 2};
Circle(5) = {4, 1, 5};  // half circles: their plane is taken from the other curves
Circle(6) = {5, 1, 4};

Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 6};
Plane Surface(1) = {1, 2};

Physical Surface("ring", 1) = {1};
Physical Curve("outer", 1) = {1:4};
Physical Curve("inner", 2) = {5, 6};
