// A curve and a point inside a surface that the mesh must keep, with no surface of their own.

Point(1) = {0, 0, 0};
Point(2) = {2, 0, 0};
Point(3) = {2, 1, 0};
Point(4) = {0, 1, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Point(5) = {0.5, 0.3, 0};
Point(6) = {1.1, 0.7, 0};
Line(5) = {5, 6};
Curve{5} In Surface{1};
Point(7) = {1.6, 0.35, 0};
Point{7} In Surface{1};

Physical Surface("plate", 1) = {1};
Physical Curve("rod", 1) = {5};
Physical Curve("rim", 2) = {1:4};
Physical Point("sensor", 1) = {7};
