// Two rooms joined by a channel a hundred times longer than wide.

Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {1, 0.49, 0};
Point(4) = {3, 0.49, 0};
Point(5) = {3, 0, 0};
Point(6) = {4, 0, 0};
Point(7) = {4, 1, 0};
Point(8) = {3, 1, 0};
Point(9) = {3, 0.51, 0};
Point(10) = {1, 0.51, 0};
Point(11) = {1, 1, 0};
Point(12) = {0, 1, 0};
For i In {1:11}
  Line(i) = {i, i + 1};
EndFor
Line(12) = {12, 1};
Curve Loop(1) = {1:12};
Plane Surface(1) = {1};

Physical Surface("fluid", 1) = {1};
Physical Curve("inlet", 1) = {12};
Physical Curve("outlet", 2) = {6};
Physical Curve("channel", 3) = {3, 9};
