// A flying man, 1.6 m long, who lies in the air with arms and legs spread, his face down, head first: towards x and, by
// 20 degrees, down; z is up. He is as coarse as the figure of the paper, which has 450 nodes and 1,320 elements: this one has 451 and 1,319. Limbs as
// thick as those of a padded suit keep elements of this size well shaped. Lengths in metres. Makes figure.msh with
//   gmsh -3 -format msh22 figure.geo
SetFactory("OpenCASCADE");

Sphere(1) = {0.05, 0, 0, 1};             // trunk
Dilate {{0.05, 0, 0}, {0.38, 0.26, 0.20}} { Volume{1}; }
Sphere(2) = {0.54, 0, 0.02, 0.18};       // head
parts() = {2};
For side In {-1 : 1 : 2}
  v = newv; parts() += v;                // arm, hand, leg, foot
  Cone(v) = {0.18, 0.10 * side, 0, 0.24, 0.48 * side, 0, 0.13, 0.10};
  v = newv; parts() += v;
  Sphere(v) = {0.45, 0.64 * side, 0, 0.135};
  v = newv; parts() += v;
  Cone(v) = {-0.12, 0.10 * side, 0, -0.58, 0.24 * side, 0, 0.15, 0.115};
  v = newv; parts() += v;
  Sphere(v) = {-0.76, 0.365 * side, 0, 0.155};
EndFor
figure() = BooleanUnion{ Volume{1}; Delete; }{ Volume{parts()}; Delete; };
Rotate {{0, 1, 0}, {0, 0, 0}, 0.35} { Volume{figure()}; }  // head down

Physical Volume("figure", 1) = {figure()};

// Smaller elements inside than on the skin: otherwise nearly all nodes would lie on it.
SKIN_SIZE = 0.118;
INNER_SIZE = 0.076;
Field[1] = MathEval;
Field[1].F = Sprintf("%g", INNER_SIZE);
Field[2] = Restrict;
Field[2].InField = 1;
Field[2].VolumesList = {figure()};
Background Field = 2;
Mesh.MeshSizeMax = SKIN_SIZE;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Optimize = 1;
Mesh.OptimizeThreshold = 0.5;
Mesh.Smoothing = 5;
Mesh.SaveAll = 0;     // only the tetrahedra of the volume
