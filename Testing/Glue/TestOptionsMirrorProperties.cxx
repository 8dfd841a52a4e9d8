// Options of the core and properties of the classes have the same defaults.
#include "../Cases/Case.h"
#include "E57/E57Parser.h"
#include "LAS/LASParser.h"
#include "PLY/PLYParser.h"
#include "StanfordScans/AlignedScans.h"
#include "TIFF/TIFFStackParser.h"
#include "TextCloud/TextCloudParser.h"
#include "vtkConformalLASReader.h"
#include "vtkConformalPLYReader.h"
#include "vtkE57Reader.h"
#include "vtkStanfordScansReader.h"
#include "vtkTIFFStackReader.h"
#include "vtkTextCloudReader.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

TEST(OptionsMirrorProperties, OfEveryCase)
{
  int compared = 0;
  for (const cases::Case& of : cases::All())
  {
    for (const cases::Mirror& mirror : of.Mirrors ? of.Mirrors() : std::vector<cases::Mirror>())
    {
      EXPECT_TRUE(mirror.IsSame) << of.Class << ": " << mirror.Name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(OptionsMirrorProperties, ConformalLASReader)
{
  const conformal::LASOptions options;
  vtkNew<vtkConformalLASReader> reader;
  EXPECT_EQ(reader->GetShiftCoordinates(), options.ShiftCoordinates);
}

TEST(OptionsMirrorProperties, E57Reader)
{
  const conformal::E57Options options;
  vtkNew<vtkE57Reader> reader;
  EXPECT_EQ(reader->GetScanId(), options.ScanId);
  EXPECT_EQ(reader->GetShiftCoordinates(), options.ShiftCoordinates);
}

TEST(OptionsMirrorProperties, ConformalPLYReader)
{
  const conformal::PLYOptions options;
  vtkNew<vtkConformalPLYReader> reader;
  EXPECT_EQ(reader->GetMaximumEdgeLength(), options.MaximumEdgeLength);
}

TEST(OptionsMirrorProperties, StanfordScansReader)
{
  const conformal::AlignedScansOptions options;
  vtkNew<vtkStanfordScansReader> reader;
  EXPECT_EQ(reader->GetInvertRotation(), options.InvertRotation);
  EXPECT_EQ(reader->GetAllowExternalFiles(), options.AllowExternalFiles);
  EXPECT_EQ(reader->GetRequireAllScans(), options.RequireAllScans);
}

TEST(OptionsMirrorProperties, TIFFStackReader)
{
  const conformal::TIFFStackOptions options;
  vtkNew<vtkTIFFStackReader> reader;
  EXPECT_EQ(reader->GetYAxis() == vtkTIFFStackReader::UP, options.FirstRowUp);
}

TEST(OptionsMirrorProperties, TextCloudReader)
{
  const conformal::TextCloudOptions options;
  vtkNew<vtkTextCloudReader> reader;
  EXPECT_EQ(reader->GetDecimalComma(), options.DecimalComma);
  EXPECT_EQ(reader->GetSkipMalformedLines(), options.SkipMalformedLines);
}
