// A tank of 0.6 m x 0.3 m with a wedge on its floor and two round posts, for
// dam_break_unstructured.prm. Quadrilaterals only: triangles are recombined, and
// what is left of them is divided.
//   gmsh -2 -format msh2 dam_break_unstructured.geo
h = 0.04;

Point(1) = {0, 0, 0, h};
Point(2) = {0.25, 0, 0, h};
Point(3) = {0.31, 0.04, 0, h};
Point(4) = {0.34, 0, 0, h};
Point(5) = {0.6, 0, 0, h};
Point(6) = {0.6, 0.3, 0, h};
Point(7) = {0, 0.3, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 1};
Curve Loop(1) = {1:7};

Macro Post
  p = newp;
  Point(p) = {x, y, 0, h};
  Point(p + 1) = {x + r, y, 0, h};
  Point(p + 2) = {x, y + r, 0, h};
  Point(p + 3) = {x - r, y, 0, h};
  Point(p + 4) = {x, y - r, 0, h};
  c = newc;
  Circle(c) = {p + 1, p, p + 2};
  Circle(c + 1) = {p + 2, p, p + 3};
  Circle(c + 2) = {p + 3, p, p + 4};
  Circle(c + 3) = {p + 4, p, p + 1};
  Curve Loop(n) = {c : c + 3};
  posts() += {c : c + 3};
Return
posts() = {};
n = 2; x = 0.42; y = 0.08; r = 0.025; Call Post;
n = 3; x = 0.5; y = 0.15; r = 0.025; Call Post;

Plane Surface(1) = {1, 2, 3};
Physical Curve(1) = {1:5, 7}; // walls
Physical Curve(2) = {6};      // top
Physical Curve(3) = {posts()};
Physical Surface(4) = {1};

Mesh.RecombineAll = 1;
Mesh.SubdivisionAlgorithm = 1;
Mesh.MshFileVersion = 2.2;
