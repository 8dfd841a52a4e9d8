#include "Text/JSONText.h"

#include <gtest/gtest.h>

TEST(JSONText, KeepsValidCharactersAndReplacesOtherBytes)
{
  const std::string valid = "a\x7F\xC3\xBC\xE2\x82\xAC\xF0\x9F\x90\xBB\xEF\xBF\xBF\xF4\x8F\xBF\xBF";
  EXPECT_EQ(conformal::validUTF8(valid), valid);
  const std::string none = "\xEF\xBF\xBD";
  const std::pair<std::string, int> broken[] = {
    { "\x80", 1 },             // goes on with nothing
    { "\xC3", 1 },             // cut off
    { "\xE2\x82", 2 },         // likewise
    { "\xC0\xAF", 2 },         // a slash in two bytes
    { "\xE0\x80\xAF", 3 },     // in three
    { "\xF0\x80\x80\xAF", 4 }, // in four
    { "\xED\xA0\x80", 3 },     // half of a pair
    { "\xF4\x90\x80\x80", 4 }, // beyond the last character
    { "\xFF", 1 },
  };
  for (const auto& [bytes, count] : broken)
  {
    std::string expected = "x";
    for (int i = 0; i < count; ++i)
    {
      expected += none;
    }
    EXPECT_EQ(conformal::validUTF8("x" + bytes + "y"), expected + "y");
  }
}

TEST(JSONText, EscapesWhatJSONAndHTMLDoNotTake)
{
  EXPECT_EQ(conformal::jsonText(""), "\"\"");
  EXPECT_EQ(conformal::jsonText("a\"b\\c\n\x01\x7F"), "\"a\\\"b\\\\c\\u000a\\u0001\\u007f\"");
  EXPECT_EQ(conformal::jsonText(std::string("\0", 1)), "\"\\u0000\"");
  EXPECT_EQ(conformal::jsonText("</script><!--&"), "\"\\u003c/script\\u003e\\u003c!--\\u0026\"");
  EXPECT_EQ(conformal::jsonText("\xFF\xC3\xBC"), "\"\xEF\xBF\xBD\xC3\xBC\"");
}
