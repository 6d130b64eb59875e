// A cube of half-width 1 round a ball of radius 0.5, whose surface is made of faces.
SetFactory("OpenCASCADE");
DefineConstant[cells = 8];
Box(1) = {-1, -1, -1, 2, 2, 2};
Sphere(2) = {0, 0, 0, 0.5};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Physical Volume("ball") = {2};
Physical Volume("matrix") = {3};
Mesh.MeshSizeMin = 2 / cells;
Mesh.MeshSizeMax = 2 / cells;
