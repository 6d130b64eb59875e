// A liver of 0.2 m with a capsule, a tumour and a ligament: a thick right lobe at x = 0, a thin left lobe at x = 0.2, a
// notch between them on the front margin, a flat underside. z is up, y points backwards. Lengths in metres. Makes
// liver.msh with
//   gmsh -3 -format msh22 liver.geo
SetFactory("OpenCASCADE");

LENGTH = 0.2;
SECTIONS = 11;      // cross sections along x, which each skin is drawn through
CORNERS = 16;       // points of a cross section
CAPSULE = 0.004;    // thickness of the capsule's layer: one element; the real capsule is a fortieth of it
SIZE = 0.0075;      // of the elements

// Makes the volume `shape`, whose surface lies `inset` below the skin.
Macro Shape
  wires() = {};
  For s In {0 : SECTIONS - 1}
    // Sections crowd at both ends, where they shrink like those of an ellipsoid; the last cap stays a small disc.
    angle = Pi * (0.07 + 0.86 * s / (SECTIONS - 1));
    c = (1 - Cos(angle)) / 2;
    round = Sin(angle);
    depth = 0.066 * round * (1 - 0.45 * c) - inset;    // half, along y
    height = 0.046 * round * (1 - 0.50 * c) - inset;   // half, along z
    notch = 0.30 * Exp(-((c - 0.66) / 0.08)^2);
    corners() = {};
    For i In {0 : CORNERS - 1}
      theta = 2 * Pi * i / CORNERS;
      back = Cos(theta);
      up = Sin(theta);
      x = inset + (LENGTH - 2 * inset) * c;
      y = 0.010 * c + depth * back * (back < 0 ? 1 - notch : 1);
      // The front margin is thinner than the back, and the underside flatter than the top.
      z = height * up * (1 + 0.25 * back) * (up < 0 ? 0.65 : 1) + 0.012 * c;
      p = newp;
      Point(p) = {x, y, z};
      corners() += p;
    EndFor
    l = newl;
    Spline(l) = {corners(), corners(0)};
    w = newll;
    Wire(w) = {l};
    wires() += w;
  EndFor
  shape = newv;
  ThruSections(shape) = {wires()};
Return

inset = 0;
Call Shape;
outer = shape;
inset = CAPSULE;
Call Shape;
inner = shape;

tumour = newv;
Sphere(tumour) = {0.105, 0.004, 0.010, 0.016};
column = newv;      // an upright one; what of the capsule lies in it is the ligament's
Cylinder(column) = {0.052, 0.016, 0, 0, 0, 0.1, 0.024};
Dilate {{0.052, 0.016, 0}, {1.5, 1, 1}} { Volume{column}; }

skin() = BooleanDifference{ Volume{outer}; Delete; }{ Volume{inner}; };
ligament() = BooleanIntersection{ Volume{column}; Delete; }{ Volume{skin()}; };
capsule() = BooleanDifference{ Volume{skin()}; Delete; }{ Volume{ligament()}; };
parenchyma() = BooleanDifference{ Volume{inner}; Delete; }{ Volume{tumour}; };
Coherence;          // neighbours share their faces; the volumes keep their numbers

Physical Volume("parenchyma", 1) = {parenchyma()};
Physical Volume("capsule", 2) = {capsule()};
Physical Volume("tumour", 3) = {tumour};
Physical Volume("ligament", 4) = {ligament()};

Mesh.MeshSizeMin = SIZE;
Mesh.MeshSizeMax = SIZE;
Mesh.Optimize = 1;
Mesh.OptimizeThreshold = 0.5;
Mesh.Smoothing = 5;
Mesh.SaveAll = 0;     // only the tetrahedra of the volumes
