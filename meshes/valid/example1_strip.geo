// A long strip with one interface inside that touches nothing: thin triangles on both sides of it.

Point(1) = {0, 0, 0};
Point(2) = {30.867, 0, 0};
Point(3) = {30.867, 1, 0};
Point(4) = {0, 1, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Point(5) = {5.579, 0.439, 0};
Point(6) = {25.023, 0.447, 0};
Line(5) = {5, 6};
Curve{5} In Surface{1};

Physical Surface("strip", 1) = {1};
Physical Curve("interface", 1) = {5};
Physical Curve("boundary", 2) = {1:4};
