// A block of half-width 4 round a disc z = 0. With `faces` the discs of radius 0.8, 1 and 1.2 are made of faces.
SetFactory("OpenCASCADE");
DefineConstant[cells = 10, faces = 0];
Box(1) = {-4, -4, -4, 8, 8, 8};
If (faces)
  Disk(101) = {0, 0, 0, 0.8};
  Disk(102) = {0, 0, 0, 1};
  Disk(103) = {0, 0, 0, 1.2};
  BooleanFragments{ Volume{1}; Delete; }{ Surface{101, 102, 103}; Delete; }
EndIf
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Field[1] = Box;
size = 1.3 / (0.35 * cells);
Field[1].VIn = size;
Field[1].VOut = 4 * size;
Field[1].XMin = -1.3; Field[1].XMax = 1.3;
Field[1].YMin = -1.3; Field[1].YMax = 1.3;
Field[1].ZMin = -1.3; Field[1].ZMax = 1.3;
Field[1].Thickness = 2.7;
Background Field = 1;
