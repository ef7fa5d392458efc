// A slit that starts on the boundary and ends inside.

Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {2, 0, 0};
Point(4) = {2, 2, 0};
Point(5) = {0, 2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Curve Loop(1) = {1:5};
Plane Surface(1) = {1};

Point(6) = {1.25, 1, 0};
Line(6) = {2, 6};
Curve{6} In Surface{1};

Physical Surface("plate", 1) = {1};
Physical Curve("slit", 1) = {6};
Physical Curve("bottom", 2) = {1, 2};
