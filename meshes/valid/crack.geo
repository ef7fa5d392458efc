// A crack inside a square: three straight pieces, both tips inside.

Point(1) = {0, 0, 0};
Point(2) = {4, 0, 0};
Point(3) = {4, 4, 0};
Point(4) = {0, 4, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Point(5) = {1, 1.5, 0};
Point(6) = {2, 2, 0};
Point(7) = {3, 2, 0};
Point(8) = {3, 2.75, 0};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Curve{5, 6, 7} In Surface{1};

Physical Surface("rock", 1) = {1};
Physical Curve("crack", 1) = {5, 6, 7};
Physical Curve("sides", 2) = {1:4};
Physical Point("tips", 1) = {5, 8};
