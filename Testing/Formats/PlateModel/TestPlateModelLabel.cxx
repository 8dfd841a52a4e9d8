#include "PlateModel/PlateModelLabel.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

using conformal::parsePlateModelLabel;
using conformal::PlateModelLabel;

namespace
{
const std::string PDS3 =
  "PDS_VERSION_ID = PDS3\r\n/* UNIT = METER */\r\nTARGET_NAME   = \"433 EROS\"\r\n"
  "OBJECT = TABLE\r\n  OBJECT = COLUMN\r\n    NAME = \"X\"\r\n    UNIT = KILOMETER\r\n"
  "  END_OBJECT = COLUMN\r\n  OBJECT = COLUMN\r\n    UNIT = \"N/A\"\r\n"
  "  END_OBJECT = COLUMN\r\nEND_OBJECT = TABLE\r\nEND\r\n";
const std::string PDS4 =
  "<?xml version=\"1.0\"?>\n<!-- <unit>m</unit> "
  "-->\n<Product_Observational>\n<title><name>No</name></title>"
  "<Target_Identification>\n <name> 101955 Bennu "
  "</name><type>Asteroid</type></Target_Identification>\n"
  "<Field_Character><name>x</name><pds:unit nil=\"no\">km</pds:unit></Field_Character>\n"
  "<Field_Character><name>n</name><unit>none</unit></Field_Character>\n</Product_Observational>\n";
}

TEST(PlateModelLabel, HasTheUnitAndTheBodyOfBothVersions)
{
  for (const auto& [text, name] :
    { std::make_pair(PDS3, "433 EROS"), std::make_pair(PDS4, "101955 Bennu"),
      std::make_pair("\xEF\xBB\xBF \n" + PDS4, "101955 Bennu") })
  {
    const PlateModelLabel label = parsePlateModelLabel(text);
    EXPECT_EQ(label.TargetName, name);
    EXPECT_EQ(label.MetersPerUnit, 1000.0);
    EXPECT_FALSE(label.HasSeveralUnits);
  }
}

TEST(PlateModelLabel, KnowsTheSpellingsOfUnits)
{
  for (const char* unit : { "KM", "km", "\"KILOMETERS\"", "<KM>", "Kilometre", "\" kilometer \"" })
  {
    EXPECT_EQ(parsePlateModelLabel("UNIT = " + std::string(unit)).MetersPerUnit, 1000.0) << unit;
  }
  for (const char* unit : { "M", "\"METERS\"", "metre", "m" })
  {
    EXPECT_EQ(parsePlateModelLabel("UNIT=" + std::string(unit) + "\n").MetersPerUnit, 1.0) << unit;
  }
  for (const char* unit : { "DEGREE", "\"", "<", "", "kmh", "\"\"", "<>" })
  {
    EXPECT_EQ(parsePlateModelLabel("UNIT = " + std::string(unit)).MetersPerUnit, 0.0) << unit;
  }
}

TEST(PlateModelLabel, RefusesToChooseBetweenUnits)
{
  for (const char* text :
    { "UNIT = KM\nUNIT = M\nUNIT = KM\n", "<a><unit>m</unit><unit>km</unit></a>" })
  {
    const PlateModelLabel label = parsePlateModelLabel(text);
    EXPECT_TRUE(label.HasSeveralUnits);
    EXPECT_EQ(label.MetersPerUnit, 0.0);
  }
}

// Whatever the text, there is an end, and nothing is read outside of it.
TEST(PlateModelLabel, ReadsBrokenTexts)
{
  for (const std::string& whole : { PDS3, PDS4 })
  {
    for (std::size_t size = 0; size < whole.size(); ++size)
    {
      parsePlateModelLabel(whole.substr(0, size));
      parsePlateModelLabel(whole.substr(size));
    }
  }
  for (const char* text :
    { "", "<", "<>", "</>", "<:>", "<unit", "=", "= =", "/*", "<!--", "TARGET_NAME = \"" })
  {
    EXPECT_EQ(parsePlateModelLabel(text).MetersPerUnit, 0.0) << text;
  }
}
