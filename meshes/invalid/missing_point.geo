// Line 2 ends at a point that does not exist.
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 7};
