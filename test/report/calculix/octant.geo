// An eighth of a block of half-width 4, with a quarter of a disc of unit radius in its face z = 0; fine at the front.
SetFactory("OpenCASCADE");
DefineConstant[edge = 0.1];
Box(1) = {0, 0, 0, 4, 4, 4};
Disk(100) = {0, 0, 0, 1, 1};
BooleanFragments{ Volume{1}; Delete; }{ Surface{100}; Delete; }
Recursive Delete { Surface{:}; }
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMax = 1;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.35 * Sqrt((Sqrt(x^2 + y^2) - 1)^2 + z^2)", edge);
Background Field = 1;
