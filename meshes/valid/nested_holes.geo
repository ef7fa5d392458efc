// A square frame; in its hole an island; in the island another hole. Two components.

side[] = {6, 4, 2, 1};
For k In {0:3}
  a = 3 - side[k] / 2;
  b = 3 + side[k] / 2;
  Point(10 * k + 1) = {a, a, 0};
  Point(10 * k + 2) = {b, a, 0};
  Point(10 * k + 3) = {b, b, 0};
  Point(10 * k + 4) = {a, b, 0};
  For i In {1:4}
    Line(10 * k + i) = {10 * k + i, 10 * k + i % 4 + 1};
  EndFor
  Curve Loop(k + 1) = {10 * k + 1 : 10 * k + 4};
EndFor
Plane Surface(1) = {1, 2};
Plane Surface(2) = {3, 4};

Physical Surface("frame", 1) = {1};
Physical Surface("island", 2) = {2};
Physical Curve("outer sides", 1) = {1:4, 21:24};
Physical Curve("inner sides", 2) = {11:14, 31:34};
