// A closed B-spline with one point at its ends, and an ellipse as hole.

For i In {0:9}
  angle = 2 * Pi * i / 10;
  radius = i % 2 == 0 ? 2 : 1.4;
  Point(i + 1) = {radius * Cos(angle), radius * Sin(angle), 0};
EndFor
BSpline(1) = {1:10, 1};

Point(21) = {0.1, 0, 0};
Point(22) = {0.7, 0, 0};
Point(23) = {0.1, 0.3, 0};
Point(24) = {-0.5, 0, 0};
Point(25) = {0.1, -0.3, 0};
Ellipse(2) = {22, 21, 22, 23};
Ellipse(3) = {23, 21, 24, 24};
Ellipse(4) = {24, 21, 24, 25};
Ellipse(5) = {25, 21, 22, 22};

Curve Loop(1) = {1};
Curve Loop(2) = {2, 3, 4, 5};
Plane Surface(1) = {1, 2};

Physical Surface("blob", 1) = {1};
Physical Curve("rim", 1) = {1};
Physical Curve("eye", 2) = {2:5};
