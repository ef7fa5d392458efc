// Two squares that overlap: the part in the middle would belong to both.
For k In {0:1}
  p = 10 * k;
  Point(p + 1) = {k, k, 0};
  Point(p + 2) = {k + 2, k, 0};
  Point(p + 3) = {k + 2, k + 2, 0};
  Point(p + 4) = {k, k + 2, 0};
  For i In {1:4}
    Line(p + i) = {p + i, p + i % 4 + 1};
  EndFor
  Curve Loop(k + 1) = {p + 1 : p + 4};
  Plane Surface(k + 1) = {k + 1};
EndFor
