// Line 3 is not a statement of the language.
Point(1) = {0, 0, 0};
Punkt(2) := 1, 0;
