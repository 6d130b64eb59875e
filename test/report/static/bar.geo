// A bar, thrice divided along: 0.2 and 0.4 of its length may be clamped. With `faces` its mid-plane is made of faces.
SetFactory("OpenCASCADE");
DefineConstant[cells = 4, faces = 0];
length = 1; height = 0.2;
at[] = {0, 0.2, 0.4, 1};
For i In {0:2}
  For k In {0:faces}
    Box(newv) = {at[i] * length, 0, k * height / 2, (at[i + 1] - at[i]) * length, height, height / (1 + faces)};
  EndFor
EndFor
BooleanFragments{ Volume{:}; Delete; }{}
Mesh.MeshSizeMin = height / cells;
Mesh.MeshSizeMax = height / cells;
