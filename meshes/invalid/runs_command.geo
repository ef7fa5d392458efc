// A geometry has no business to run programs.
Point(1) = {0, 0, 0};
SystemCall "true";
