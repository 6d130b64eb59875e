// A plate with a crack from x = 0 along z = 0. With `faces` both lengths of the crack, 0.3 and 0.5, are made of faces.
SetFactory("OpenCASCADE");
DefineConstant[cells = 10, faces = 0];
at[] = {0, 1};
If (faces)
  at[] = {0, 0.3, 0.5, 1};
EndIf
For i In {0:#at[] - 2}
  For k In {0:faces}
    Box(newv) = {at[i], 0, -1.5 * (1 - k), at[i + 1] - at[i], 0.1, 3 / (1 + faces)};
  EndFor
EndFor
If (faces)
  BooleanFragments{ Volume{:}; Delete; }{}
EndIf
Mesh.MeshSizeExtendFromBoundary = 0;
Field[1] = Box;
Field[1].VIn = 1 / cells;
Field[1].VOut = 3 / cells;
Field[1].XMin = -1; Field[1].XMax = 2;
Field[1].YMin = -1; Field[1].YMax = 2;
Field[1].ZMin = -0.5; Field[1].ZMax = 0.5;
Field[1].Thickness = 1;
Background Field = 1;
