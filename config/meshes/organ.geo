// A soft body like a liver, 0.2 m long: a thick right lobe at x = 0, a thin left lobe at x = 0.2, a notch between them
// on the lower margin, a hollow underside. Lengths in metres. Makes organ.msh with
//   gmsh -3 -format msh22 organ.geo
SetFactory("OpenCASCADE");

LENGTH = 0.2;
SECTIONS = 13;   // cross sections along x, which the skin is drawn through
CORNERS = 16;    // points of a cross section

For s In {0 : SECTIONS - 1}
  // Sections crowd at both ends, where they shrink like those of an ellipsoid; the last cap stays a small disc.
  angle = Pi * (0.06 + 0.88 * s / (SECTIONS - 1));
  c = (1 - Cos(angle)) / 2;
  round = Sin(angle);
  height = 0.062 * round * (1 - 0.50 * c);
  depth = 0.045 * round * (1 - 0.60 * c);
  notch = 0.35 * Exp(-((c - 0.60) / 0.09)^2);
  For i In {0 : CORNERS - 1}
    theta = 2 * Pi * i / CORNERS;
    up = Sin(theta);
    out = Cos(theta);
    y = 0.015 * c + height * up * (up < 0 ? 1 - notch : 1);
    // The lower margin is thinner than the upper one, and the underside flatter than the top.
    z = depth * out * (1 + 0.30 * up) * (out < 0 ? 0.55 : 1) - 0.25 * depth * up * up - 0.02 * c * c;
    Point(100 * (s + 1) + i) = {LENGTH * c, y, z};
  EndFor
  Spline(s + 1) = {100 * (s + 1) : 100 * (s + 1) + CORNERS - 1, 100 * (s + 1)};
  Wire(s + 1) = {s + 1};
EndFor
ThruSections(1) = {1 : SECTIONS};

Physical Volume("organ", 1) = {1};

Mesh.MeshSizeMin = 0.0077;
Mesh.MeshSizeMax = 0.0077;
Mesh.Optimize = 1;
Mesh.SaveAll = 0;     // only the tetrahedra of the volume
