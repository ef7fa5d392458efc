// One sector, copied and turned five times: neighbours share curves, coordinates are rounded.

Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {Cos(Pi / 3), Sin(Pi / 3), 0};
Line(1) = {1, 2};
Circle(2) = {2, 1, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};

all[] = {1};
For i In {1:5}
  copy[] = Rotate{ {0, 0, 1}, {0, 0, 0}, i * Pi / 3 }{ Duplicata{ Surface{1}; } };
  all[] += copy[];
EndFor

Physical Surface("odd", 1) = {all[0], all[2], all[4]};
Physical Surface("even", 2) = {all[1], all[3], all[5]};
