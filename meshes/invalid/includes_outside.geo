// Reads a file that is none of this folder's.
Include "../valid/annulus.geo";
