// A plate of two materials: steel with a round hole on the left, copper on the right.
// The interface is an S of two arcs of 60 degrees, smooth where they meet.

Point(1) = {0, 0, 0};
Point(2) = {2, 0, 0};
Point(3) = {4, 0, 0};
Point(4) = {4, 2, 0};
Point(5) = {2, 2, 0};
Point(6) = {0, 2, 0};
Point(7) = {2, 1, 0};
c = Sqrt(3) / 2;
Point(8) = {2 - c, 0.5, 0};  // centres of the two arcs, of radius 1
Point(9) = {2 + c, 1.5, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Circle(7) = {2, 8, 7};
Circle(8) = {7, 9, 5};

r = 0.4;
Point(10) = {0.9, 1, 0};
Point(11) = {0.9 + r, 1, 0};
Point(12) = {0.9, 1 + r, 0};
Point(13) = {0.9 - r, 1, 0};
Point(14) = {0.9, 1 - r, 0};
Circle(11) = {11, 10, 12};
Circle(12) = {12, 10, 13};
Circle(13) = {13, 10, 14};
Circle(14) = {14, 10, 11};

Curve Loop(1) = {1, 7, 8, 5, 6};
Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(1) = {1, 2};
Curve Loop(3) = {2, 3, 4, -8, -7};
Plane Surface(2) = {3};

Physical Surface("steel", 1) = {1};
Physical Surface("copper", 2) = {2};
Physical Curve("left", 11) = {6};
Physical Curve("right", 12) = {3};
Physical Curve("walls", 13) = {1, 2, 4, 5};
Physical Curve("hole", 14) = {11, 12, 13, 14};
Physical Curve("interface", 15) = {7, 8};
