// Two discs of other materials in a plate: curved interfaces with a material on both sides.

Point(1) = {0, 0, 0};
Point(2) = {4, 0, 0};
Point(3) = {4, 2, 0};
Point(4) = {0, 2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};

x[] = {1.1, 2.8};
r[] = {0.6, 0.8};
For k In {0:1}
  p = 10 * (k + 1);
  Point(p) = {x[k], 1, 0};
  Point(p + 1) = {x[k] + r[k], 1, 0};
  Point(p + 2) = {x[k], 1 + r[k], 0};
  Point(p + 3) = {x[k] - r[k], 1, 0};
  Point(p + 4) = {x[k], 1 - r[k], 0};
  For i In {1:4}
    Circle(p + i) = {p + i, p, p + i % 4 + 1};
  EndFor
  Curve Loop(k + 2) = {p + 1 : p + 4};
  Plane Surface(k + 2) = {k + 2};
EndFor
Plane Surface(1) = {1, 2, 3};

Physical Surface("plate", 1) = {1};
Physical Surface("small disc", 2) = {2};
Physical Surface("large disc", 3) = {3};
Physical Curve("rim", 1) = {1:4};
Physical Curve("small circle", 2) = {11:14};
Physical Curve("large circle", 3) = {21:24};
