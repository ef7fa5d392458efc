// Would end Gmsh, and with it the program that uses it.
Point(1) = {0, 0, 0};
Exit;
