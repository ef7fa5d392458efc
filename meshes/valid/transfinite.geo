// Numbers of points on the curves, graded on two of them; one of the curves is an arc.

Point(1) = {0, 0, 0};
Point(2) = {2, 0, 0};
Point(3) = {2, 1, 0};
Point(4) = {0, 1, 0};
Point(5) = {1, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Circle(3) = {3, 5, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};

Transfinite Curve{1} = 9;
Transfinite Curve{2} = 6 Using Progression 1.3;
Transfinite Curve{4} = 6 Using Progression 1 / 1.3;
Transfinite Curve{3} = 12;

Physical Surface("tunnel", 1) = {1};
Physical Curve("roof", 1) = {3};
Physical Curve("floor", 2) = {1};
