// A corner of 270 degrees. Every side is in the group of all sides, some in a second one.

Point(1) = {0, 0, 0};
Point(2) = {2, 0, 0};
Point(3) = {2, 1, 0};
Point(4) = {1, 1, 0};
Point(5) = {1, 2, 0};
Point(6) = {0, 2, 0};
For i In {1:5}
  Line(i) = {i, i + 1};
EndFor
Line(6) = {6, 1};
Curve Loop(1) = {1:6};
Plane Surface(1) = {1};

Physical Surface("domain", 1) = {1};
Physical Curve("boundary", 1) = {1:6};
Physical Curve("notch", 2) = {3, 4};
Physical Point("corner", 1) = {4};
