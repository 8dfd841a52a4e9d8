#include "vtkSurfacePageWriter.h"

#include "Files.h"
#include "Page/SurfacePage.h"
#include "Texture/SphereViewChoice.h"

#include <fstream>
#include <iterator>

namespace cases
{
namespace
{
using F = vtkSurfacePageWriter;

// A page must be whole, and none of its numbers may be one that JSON does not have.
std::string WhatIsWrong(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string page{ std::istreambuf_iterator<char>(file), {} };
  const std::size_t begin = page.find("id=\"description\">");
  const std::size_t end = page.find("</script>", begin);
  if (begin >= end || end >= page.size() || page.find("</html>", end) >= page.size())
  {
    return "the page is not whole";
  }
  const std::string description = page.substr(begin, end - begin);
  const std::size_t number = description.find(":["); // names stand behind the numbers
  const std::string numbers = description.substr(number, description.find("\"arrays\"") - number);
  const bool isFinite =
    numbers.find("nan") == std::string::npos && numbers.find("inf") == std::string::npos;
  return isFinite ? "" : "the page has a number that is not finite";
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::SurfacePageOptions options;
  const conformal::SphereViewOptions view;
  vtkNew<vtkSurfacePageWriter> writer;
  return { Same("ColorArrayName", writer->GetColorArrayName(), options.ColorArrayName),
    Same("RepeatTexture", writer->GetRepeatTexture(), options.RepeatsTexture),
    Same("ViewDirection", conformal::Vector3(writer->GetViewDirection()), view.ViewDirection),
    Same("ViewUp", conformal::Vector3(writer->GetViewUp()), view.ViewUp) };
}
}

Case SurfacePageWriter()
{
  Case all = CaseOf<F>("vtkSurfacePageWriter");
  Mode page = WritesOther(".html", {}, BadIds | BadPoints | BadMap,
    Set<F>([](F* f) { f->SetThreeJSFileName(CONFORMALSOM_THREE_STAND_IN); }));
  page.File.WhatIsWrong = WhatIsWrong;
  page.Ports.push_back(Picture());
  const std::vector<std::string> names = { "no such array", "SpherePosition",
    std::string(100000, 'x'), "</script>\xFF\n" };
  std::vector<std::string> files = names;
  files.insert(files.end(), { "/dev/zero", "/dev/null", "/", "." });
  page.Properties = { Texts<F>("ColorArrayName", names,
                        [](F* f, const std::string& name) { f->SetColorArrayName(name); }),
    Texts<F>(
      "ThreeJSFileName", files, [](F* f, const std::string& name) { f->SetThreeJSFileName(name); }),
    Vector3("ViewDirection", &F::SetViewDirection), Vector3("ViewUp", &F::SetViewUp),
    Integer("MaximumTextureSize", &F::SetMaximumTextureSize),
    Integer("TextureQuality", &F::SetTextureQuality),
    Switch("RepeatTexture", &F::SetRepeatTexture) };
  all.Modes = { page };
  all.Mirrors = Mirrors;
  return all;
}
}
