// An animal with two long ears, 0.2 m tall: fused ellipsoids. It looks along x, z is up, and it stands on z = 0. Lengths
// in metres. Makes animal.msh with
//   gmsh -3 -format msh22 animal.geo
SetFactory("OpenCASCADE");

// Each ellipsoid: its centre x, y, z; its half axes; its turn about y, then about x [rad]. What has y > 0 is mirrored.
ellipsoids() = {
  -0.005, 0,     0.076,   0.062, 0.041, 0.042,   -0.25, 0,      // body
   0.052, 0,     0.116,   0.036, 0.029, 0.030,    0.20, 0,      // head
   0.078, 0,     0.108,   0.015, 0.017, 0.017,    1.57, 0,      // snout
  -0.068, 0,     0.072,   0.017, 0.017, 0.017,    1.57, 0,      // tail
   0.037, 0.021, 0.164,   0.013, 0.010, 0.040,   -0.25, -0.22,  // ear
   0.036, 0.025, 0.038,   0.014, 0.013, 0.032,   -0.10, 0,      // front leg
   0.043, 0.025, 0.012,   0.021, 0.014, 0.012,    0,    0,      // front foot
  -0.036, 0.035, 0.050,   0.028, 0.017, 0.037,   -0.20, 0,      // haunch
  -0.022, 0.038, 0.012,   0.034, 0.015, 0.012,    0,    0       // hind foot
};
volumes() = {};
For i In {0 : #ellipsoids() - 1 : 8}
  e() = ellipsoids({i : i + 7});
  For side In {e(1) > 0 ? -1 : 1 : 1 : 2}
    v = newv;
    volumes() += v;
    Sphere(v) = {0, 0, 0, 1};
    Rotate {{0, 0, 1}, {0, 0, 0}, Pi / 2 * side} { Volume{v}; }  // the seam outwards, away from other seams
    Dilate {{0, 0, 0}, {e(3), e(4), e(5)}} { Volume{v}; }
    Rotate {{0, 1, 0}, {0, 0, 0}, e(6)} { Volume{v}; }
    Rotate {{1, 0, 0}, {0, 0, 0}, e(7) * side} { Volume{v}; }
    Translate {e(0), e(1) * side, e(2)} { Volume{v}; }
  EndFor
EndFor
animal() = BooleanUnion{ Volume{volumes(0)}; Delete; }{ Volume{volumes({1 : #volumes() - 1})}; Delete; };

Physical Volume("animal", 1) = {animal()};

Mesh.MeshSizeMin = 0.0108;
Mesh.MeshSizeMax = 0.0108;
Mesh.Optimize = 1;
Mesh.OptimizeThreshold = 0.5;
Mesh.Smoothing = 5;
Mesh.SaveAll = 0;     // only the tetrahedra of the volume
