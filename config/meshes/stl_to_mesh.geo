// Fills the closed surfaces of an STL file with tetrahedra. Copy this file beside the STL, set the name, the unit and
// the size of the elements, and run
//   gmsh -3 -format msh22 stl_to_mesh.geo -o body.msh
Merge "surface.stl";
UNIT = 1;                // metres in a unit of the STL file: 0.001 for millimetres
ELEMENT_SIZE = 0.008;    // edge length of the elements [m]
CAVITIES = 1;            // a shell whose bounding box lies within that of another is, 1, a cavity in it (and a shell in
                         // the cavity a body again); 0, a body of its own, such as one that lies in a bend of the other

// The triangles become smooth patches, divided where they meet at more than 40 degrees, and are then meshed anew.
ClassifySurfaces{40 * Pi / 180, 1, 1, Pi};
CreateGeometry;
patches() = Surface{:};
last = #patches() - 1;

// Patches that have a curve in common are of one shell, which is known by the first of them.
first_at() = {};
For p In {0 : last}
  shell(p) = p;
  curves() = Abs(Boundary{ Surface{patches(p)}; });
  For c In {0 : #curves() - 1}
    For k In {#first_at() : curves(c)}
      first_at(k) = -1;
    EndFor
    If (first_at(curves(c)) < 0)
      first_at(curves(c)) = p;
    Else
      a = shell(first_at(curves(c)));
      b = shell(p);
      For q In {0 : p}
        If (shell(q) == a || shell(q) == b)
          shell(q) = (a < b) ? a : b;
        EndIf
      EndFor
    EndIf
  EndFor
EndFor

// The bounding box of each shell, of which the first patch comes first.
For p In {0 : last}
  box() = BoundingBox Surface{patches(p)};
  s = shell(p);
  For k In {0 : 2}
    low(3 * p + k) = box(k);
    high(3 * p + k) = box(k + 3);
    low(3 * s + k) = (box(k) < low(3 * s + k)) ? box(k) : low(3 * s + k);
    high(3 * s + k) = (box(k + 3) > high(3 * s + k)) ? box(k + 3) : high(3 * s + k);
  EndFor
EndFor

// How many other shells lie round each, and whether shell q lies round shell p: round(p (last + 1) + q).
For p In {0 : last}
  depth(p) = 0;
  For q In {0 : last}
    inside = CAVITIES && shell(p) == p && shell(q) == q && p != q;
    For k In {0 : 2}
      inside = inside && low(3 * p + k) >= low(3 * q + k) && high(3 * p + k) <= high(3 * q + k);
    EndFor
    round(p * (last + 1) + q) = inside;
    depth(p) = depth(p) + inside;
  EndFor
EndFor

// A volume in every second shell, without the shells right inside it.
For p In {0 : last}
  If (shell(p) == p)
    own() = {};
    For q In {0 : last}
      If (shell(q) == p)
        own() += patches(q);
      EndIf
    EndFor
    Surface Loop(p + 1) = own();
  EndIf
EndFor
volumes() = {};
For p In {0 : last}
  If (shell(p) == p && depth(p) % 2 == 0)
    loops() = {p + 1};
    For q In {0 : last}
      If (round(q * (last + 1) + p) && depth(q) == depth(p) + 1)
        loops() += q + 1;
      EndIf
    EndFor
    Printf("Body %g has %g cavities", #volumes() + 1, #loops() - 1);
    Volume(p + 1) = loops();
    volumes() += p + 1;
  EndIf
EndFor
Physical Volume("body", 1) = volumes();

// With a wrong unit there would be thousands of millions of elements, and gmsh would go on without end.
LARGEST = 300;           // elements along the longest side: some 1e8 in a cube
length = 0;
For p In {0 : last}
  For k In {0 : 2}
    length = (shell(p) == p && high(3 * p + k) - low(3 * p + k) > length) ? high(3 * p + k) - low(3 * p + k) : length;
  EndFor
EndFor
Printf("The longest shell has %g m", length * UNIT);
If (length * UNIT > LARGEST * ELEMENT_SIZE)
  Error("It is more than %g elements of %g m long: is UNIT right, and ELEMENT_SIZE?", LARGEST, ELEMENT_SIZE);
  Exit;
EndIf

Mesh.MeshSizeMin = ELEMENT_SIZE / UNIT;
Mesh.MeshSizeMax = ELEMENT_SIZE / UNIT;
Mesh.ScalingFactor = UNIT;
Mesh.Optimize = 1;
Mesh.SaveAll = 0;        // only the tetrahedra of the volumes
