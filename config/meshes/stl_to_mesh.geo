// Fills the closed surface of an STL file with tetrahedra. Copy this file beside the STL, set the name, the unit and the
// size of the elements, and run
//   gmsh -3 -format msh22 stl_to_mesh.geo -o body.msh
Merge "surface.stl";
UNIT = 1;                // metres in a unit of the STL file: 0.001 for millimetres
ELEMENT_SIZE = 0.008;    // edge length of the elements [m]

// The triangles become smooth patches, divided where they meet at more than 40 degrees, and are then meshed anew.
ClassifySurfaces{40 * Pi / 180, 1, 1, Pi};
CreateGeometry;
Surface Loop(1) = Surface{:};
Volume(1) = {1};
Physical Volume("body", 1) = {1};

Mesh.MeshSizeMin = ELEMENT_SIZE / UNIT;
Mesh.MeshSizeMax = ELEMENT_SIZE / UNIT;
Mesh.ScalingFactor = UNIT;
Mesh.Optimize = 1;
Mesh.SaveAll = 0;        // only the tetrahedra of the volume
