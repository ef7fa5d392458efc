// OpenCASCADE cuts a disc and a square that overlap into three surfaces. Its circles start where
// it likes, and its lines have a length as parameter.
SetFactory("OpenCASCADE");

Disk(1) = {0, 0, 0, 1};
Rectangle(2) = {0, 0, 0, 2, 2};
BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }

Physical Surface("both", 1) = {1};
Physical Surface("disc only", 2) = {2};
Physical Surface("square only", 3) = {3};
