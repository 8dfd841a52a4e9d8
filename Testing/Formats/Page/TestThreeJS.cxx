#include "Page/ThreeJS.h"

#include "../../TemporaryFolder.h"

#include <sys/stat.h>

#include <stdexcept>

namespace
{
void expectRefused(const std::string& name, const std::string& part)
{
  try
  {
    conformal::readThreeJS(name);
    FAIL() << name << " was read";
  }
  catch (const std::invalid_argument& e)
  {
    const std::string text = e.what();
    EXPECT_NE(text.find(name + " " + part), std::string::npos) << text;
    EXPECT_NE(text.find("install Debian's package libjs-three"), std::string::npos) << text;
  }
}
}

TEST(ThreeJS, IsReadWhole)
{
  const TemporaryFolder folder;
  const std::string text("exports.WebGLRenderer = 1;\r\n\0\xFF", 30);
  EXPECT_EQ(conformal::readThreeJS(folder.write("three.js", text)), text);
}

TEST(ThreeJS, MayBeMinified)
{
  const TemporaryFolder folder;
  const std::string text = "!function(t,e){e(t)}(this,(function(t){t.WebGLRenderer=Js}));";
  EXPECT_EQ(conformal::readThreeJS(folder.write("three.min.js", text)), text);
}

TEST(ThreeJS, OtherFilesAreRefusedWithWhatToInstall)
{
  const TemporaryFolder folder;
  expectRefused(folder.file("missing.js"), "is no file");
  expectRefused(folder.file("."), "is no file");
  expectRefused("/dev/zero", "is no file");
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
  expectRefused(pipe, "is no file");
  expectRefused(folder.write("empty.js", ""), "is not a classic script");
  expectRefused(
    folder.write("three.module.js", "export { WebGLRenderer };"), "is not a classic script");
  expectRefused(folder.write("three.core.js", "if (this.WebGLRenderer == x.WebGLRenderer) {}"),
    "is not a classic script");
  const std::string large = folder.write("large.js", "");
  std::filesystem::resize_file(std::filesystem::u8path(large), (32 << 20) + 1);
  expectRefused(large, "is too large");
}

TEST(ThreeJS, ThatOfThePackageIsFound)
{
  const std::string name = conformal::findThreeJS();
  EXPECT_EQ(name.substr(0, 28), "/usr/share/javascript/three/");
  if (!std::filesystem::exists(name))
  {
    GTEST_SKIP() << "Debian's package libjs-three is not installed";
  }
  const std::string text = conformal::readThreeJS("");
  EXPECT_GT(text.size(), 100000u);
  EXPECT_EQ(conformal::readThreeJS(name), text);
}
