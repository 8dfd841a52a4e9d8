#include "Page/ThreeJS.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace conformal
{
namespace
{
constexpr std::uintmax_t MaximumBuildSize = 32
  << 20; // a larger file is not a library and is not read

// Return whether a script defines the renderer as a property of its exports, whatever these are
// called: minified scripts have "t.WebGLRenderer=". ECMAScript modules contain an export statement
// instead, which a script of a page may not contain.
bool exportsRenderer(const std::string& text)
{
  const std::string property = ".WebGLRenderer";
  for (std::size_t at = text.find(property); at != std::string::npos;
       at = text.find(property, at + 1))
  {
    const std::size_t next = text.find_first_not_of(' ', at + property.size());
    if (next != std::string::npos && text[next] == '=' && text.compare(next, 2, "==") != 0)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
std::string findThreeJS()
{
  const std::string folder = "/usr/share/javascript/three/";
  const char* const names[] = { "three.min.js", "three.js", "build/three.min.js", "build/three.js",
    "three.cjs", "build/three.cjs" };
  for (const char* name : names)
  {
    std::error_code ignored; // on an error the file counts as missing
    if (std::filesystem::is_regular_file(folder + name, ignored))
    {
      return folder + name;
    }
  }
  return folder + names[0];
}

//------------------------------------------------------------------------------
std::string readThreeJS(const std::string& fileName)
{
  if (fileName.empty() && !includedThreeJS().empty())
  {
    return std::string(includedThreeJS());
  }
  const std::string name = fileName.empty() ? findThreeJS() : fileName;
  const std::filesystem::path path = std::filesystem::u8path(name);
  const auto fail = [&](const std::string& what)
  {
    throw std::invalid_argument("three.js is needed to write a page, and " + name + " " + what +
      ": install Debian's package libjs-three, or set ThreeJSFileName to a three.min.js, which "
      "npm's package three has up to version 0.160");
  };
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    fail("is no file");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > MaximumBuildSize)
  {
    fail("is too large");
  }
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(text.data(), static_cast<std::streamsize>(text.size())))
  {
    fail("cannot be read");
  }
  if (!exportsRenderer(text))
  {
    fail("is not a classic script or CommonJS module of it");
  }
  return text;
}
}
