// A symmetric airfoil, 12 per cent thick, from splines in a disc. The trailing edge is sharp.

n = 20;                // points on each side
For i In {0:n}
  x = 0.5 * (1 - Cos(Pi * i / n));  // dense at both edges
  y = 0.6 * (0.2969 * Sqrt(x) - 0.1260 * x - 0.3516 * x^2 + 0.2843 * x^3 - 0.1036 * x^4);
  If (i == 0)
    Point(100) = {0, 0, 0};  // leading edge
  ElseIf (i == n)
    Point(120) = {1, 0, 0};  // trailing edge
  Else
    Point(100 + i) = {x, y, 0};
    Point(200 + i) = {x, -y, 0};
  EndIf
EndFor
Spline(1) = {120:108:-1};                   // upper side, from the trailing edge forward
Spline(2) = {108:100:-1, 201:208};          // nose
Spline(3) = {208:219, 120};                 // lower side

Point(1) = {0.5, 0, 0};
Point(2) = {3.5, 0, 0};
Point(3) = {0.5, 3, 0};
Point(4) = {-2.5, 0, 0};
Point(5) = {0.5, -3, 0};
Circle(11) = {2, 1, 3};
Circle(12) = {3, 1, 4};
Circle(13) = {4, 1, 5};
Circle(14) = {5, 1, 2};

Curve Loop(1) = {11, 12, 13, 14};
Curve Loop(2) = {1, 2, 3};
Plane Surface(1) = {1, 2};

Physical Surface("air", 1) = {1};
Physical Curve("wing", 1) = {1, 2, 3};
Physical Curve("far field", 2) = {11:14};
Physical Point("trailing edge", 1) = {120};
