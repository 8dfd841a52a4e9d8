// Make valid and broken meshes of SPHARM-PDM for tests.
#ifndef SPHARMMeshSamples_h
#define SPHARMMeshSamples_h

#include "../Bytes/MadeBytes.h"

namespace samples
{
inline const std::string& SPHARMMesh()
{
  static const std::string text =
    "# vtk DataFile Version 3.0\nvtk output\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
    "0 0 0 1.5 0 0\n0 1 0 0 0 1e-3\n\nPOLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  return text;
}

// Return a sphere with the polygons of SPHARMMesh().
inline const std::string& SPHARMSphere()
{
  static const std::string text =
    "# vtk DataFile Version 3.0\nsphere\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
    "-1 -1 -1 1 0 0 0 1 0 0 0 2\nPOLYGONS 4 16\n3 0 2 1 3 0 1 3 3 1 2 3 3 2 0 3\n";
  return text;
}

// Return a file of version 5.1 with cells and arrays that parsers skip.
inline std::string SPHARMMeshByOffsets()
{
  return "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
         "0 0 0 1.5 0 0 0 1 0 0 0 1e-3\nMETADATA\nINFORMATION 2\nNAME L2_NORM_RANGE LOCATION "
         "vtkDataArray\nDATA 2 0 1.5\nNAME X LOCATION Y\nDATA 0\n\n"
         "VERTICES 2 1\nOFFSETS vtktypeint64\n0 1\nCONNECTIVITY vtktypeint64\n3\n"
         "POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n"
         "0 2 1 0 1 3 1 2 3 2 0 3\n\nPOINT_DATA 4\nSCALARS a float\nLOOKUP_TABLE default\n1 2 3 "
         "4\n";
}

inline std::string BinarySPHARMMesh(bool byOffsets)
{
  Bytes bytes(true, "# vtk DataFile Version 4.2\nvtk output\nBINARY\nDATASET POLYDATA\n");
  bytes.text("POINTS 4 float\n")
    .add(std::vector<float>{ 0, 0, 0, 1.5F, 0, 0, 0, 1, 0, 0, 0, 1e-3F });
  if (byOffsets)
  {
    bytes.text("\nPOLYGONS 5 12\nOFFSETS vtktypeint64\n")
      .add(std::vector<std::int64_t>{ 0, 3, 6, 9, 12 })
      .text("\nCONNECTIVITY vtktypeint64\n")
      .add(std::vector<std::int64_t>{ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 });
  }
  else
  {
    bytes.text("\nLINES 1 3\n").add(std::vector<std::int32_t>{ 2, 0, 3 });
    bytes.text("\nPOLYGONS 4 16\n")
      .add(std::vector<std::int32_t>{ 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3 });
  }
  return bytes.text("\n").bytes();
}

inline std::vector<std::string> SPHARMMeshFiles()
{
  return { SPHARMMesh(), SPHARMMeshByOffsets(), BinarySPHARMMesh(false), BinarySPHARMMesh(true) };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadSPHARMMeshFiles()
{
  const std::string &mesh = SPHARMMesh(), offsets = SPHARMMeshByOffsets();
  return { replaced(mesh, "# vtk", "# VTK"), replaced(mesh, "ASCII", "TEXT"),
    replaced(mesh, "DATASET", "DATA"), replaced(mesh, "POLYDATA", "UNSTRUCTURED_GRID"),
    replaced(mesh, "POINTS 4 float", "POINTS 4 int"), replaced(mesh, "POINTS 4 float", "POINTS 4"),
    replaced(mesh, "POINTS 4", "POINTS -4"), replaced(mesh, "POINTS 4", "POINTS 5"),
    replaced(mesh, "POINTS 4", "POINTS 3"), replaced(mesh, "POINTS 4", "POINTS 4000000000000"),
    replaced(mesh, "POINTS 4 float\n", ""), replaced(mesh, "POLYGONS", "TRIANGLE_STRIPS"),
    replaced(mesh, "1.5", "1.2.3"), replaced(mesh, "1.5", "nan"), replaced(mesh, "1.5", "inf"),
    replaced(mesh, "1.5", "1,5"), replaced(mesh, "1.5", "one"), replaced(mesh, "1.5", "1e99"),
    replaced(mesh, "POLYGONS 4 16", "POLYGONS 4 15"),
    replaced(mesh, "POLYGONS 4 16", "POLYGONS 4 17"),
    replaced(mesh, "POLYGONS 4 16", "POLYGONS 3 16"),
    replaced(mesh, "POLYGONS 4 16", "POLYGONS 5 16"),
    replaced(mesh, "POLYGONS 4 16", "POLYGONS 4000000000000 16"),
    replaced(mesh, "3 0 1 3", "3 0 1 4"), replaced(mesh, "3 0 1 3", "3 0 1 -1"),
    replaced(mesh, "3 0 1 3", "-3 0 1 3"), replaced(mesh, "3 0 1 3", "9 0 1 3"),
    replaced(mesh, "3 2 0 3\n", ""), replaced(mesh, "3 2 0 3", "3 2 0"),
    replaced(mesh, "3 2 0 3\n", "3 2 0 3\nmore"), replaced(offsets, "0 3 6 9 12", "1 3 6 9 12"),
    replaced(offsets, "0 3 6 9 12", "0 6 3 9 12"), replaced(offsets, "0 3 6 9 12", "0 3 6 9 11"),
    replaced(offsets, "0 3 6 9 12", "0 3 6 9"), replaced(offsets, "POLYGONS 5 12", "POLYGONS 5 13"),
    replaced(offsets, "POLYGONS 5 12\nOFFSETS vtktypeint64", "POLYGONS 5 12\nOFFSETS float"),
    replaced(offsets, "CONNECTIVITY", "CONNECTIONS"), replaced(offsets, "1 3 1 2 3", "1 3 1 2 4"),
    BinarySPHARMMesh(false).substr(0, 110), BinarySPHARMMesh(true).substr(0, 220) };
}
}

#endif
