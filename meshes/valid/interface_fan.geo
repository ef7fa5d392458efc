// Six materials meet at one point, at angles between 18 and 90 degrees.

Point(1) = {0, 0, 0};
Point(2) = {3, 0, 0};
Point(3) = {3, 1, 0};
Point(4) = {3, 3, 0};
Point(5) = {0, 3, 0};
Point(6) = {-3, 3, 0};
Point(7) = {-3, 0, 0};
Point(8) = {-3, -3, 0};
Point(9) = {0, -3, 0};
Point(10) = {3, -3, 0};

Line(1) = {2, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 9};
Line(8) = {9, 10};
Line(9) = {10, 2};
Line(11) = {1, 2};
Line(12) = {1, 3};
Line(13) = {1, 4};
Line(14) = {1, 5};
Line(15) = {1, 7};
Line(16) = {1, 9};

Curve Loop(1) = {11, 1, -12};
Curve Loop(2) = {12, 2, -13};
Curve Loop(3) = {13, 3, -14};
Curve Loop(4) = {14, 4, 5, -15};
Curve Loop(5) = {15, 6, 7, -16};
Curve Loop(6) = {16, 8, 9, -11};
For i In {1:6}
  Plane Surface(i) = {i};
EndFor

Physical Surface("thin wedge", 1) = {1};
Physical Surface("wedge", 2) = {2};
Physical Surface("half", 3) = {3};
Physical Surface("quarters", 4) = {4, 5, 6};
Physical Curve("outer", 1) = {1:9};
Physical Curve("spokes", 2) = {11:16};
Physical Point("hub", 1) = {1};
