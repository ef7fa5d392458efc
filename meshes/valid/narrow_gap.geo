// Two round holes a hundredth of their radius apart: chords of 30 degrees would cut into each other.

Point(1) = {-3, -2, 0};
Point(2) = {3, -2, 0};
Point(3) = {3, 2, 0};
Point(4) = {-3, 2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};

x[] = {-1.005, 1.005};
For k In {0:1}
  p = 10 * (k + 1);
  Point(p) = {x[k], 0, 0};
  For i In {1:4}
    angle = (i - 0.5) * Pi / 2;
    Point(p + i) = {x[k] + Cos(angle), Sin(angle), 0};
  EndFor
  For i In {1:4}
    Circle(p + i) = {p + i, p, p + i % 4 + 1};
  EndFor
  Curve Loop(k + 2) = {p + 1 : p + 4};
EndFor
Plane Surface(1) = {1, 2, 3};

Physical Surface("plate", 1) = {1};
Physical Curve("holes", 1) = {11:14, 21:24};
