// The small square lies in the large one, which declares no hole for it.
For k In {0:1}
  p = 10 * k;
  Point(p + 1) = {k, k, 0};
  Point(p + 2) = {4 - k, k, 0};
  Point(p + 3) = {4 - k, 4 - k, 0};
  Point(p + 4) = {k, 4 - k, 0};
  For i In {1:4}
    Line(p + i) = {p + i, p + i % 4 + 1};
  EndFor
  Curve Loop(k + 1) = {p + 1 : p + 4};
  Plane Surface(k + 1) = {k + 1};
EndFor
