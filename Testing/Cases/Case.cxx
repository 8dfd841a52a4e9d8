#include "Case.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>

namespace cases
{
namespace
{
vtkSmartPointer<vtkDataObject> GoodInput(Data takes)
{
  if (takes == Data::Picture)
  {
    return SmallPicture();
  }
  if (takes == Data::Outlines)
  {
    return Ellipsoid();
  }
  return PlacesOnABody();
}
}

//------------------------------------------------------------------------------
Port Surface(unsigned int reads, const std::string& name)
{
  return { Data::Surface, reads, true, false, name };
}

//------------------------------------------------------------------------------
Port Variant(unsigned int reads, const std::string& name)
{
  return { Data::Surface, reads, true, true, name };
}

//------------------------------------------------------------------------------
Port Good()
{
  return { Data::Surface, 0, false };
}

//------------------------------------------------------------------------------
Port Places(unsigned int reads, const std::string& name)
{
  return { Data::Places, reads, true, false, name };
}

//------------------------------------------------------------------------------
Port Outlines(unsigned int reads, const std::string& name)
{
  return { Data::Outlines, reads, true, false, name };
}

//------------------------------------------------------------------------------
Port Picture(const std::string& name)
{
  return { Data::Picture, 0, true, false, name };
}

//------------------------------------------------------------------------------
Port Nothing()
{
  return { Data::Nothing, 0, false };
}

//------------------------------------------------------------------------------
bool Mode::hasOthers() const
{
  const auto surfaces = std::count_if(this->Ports.begin(), this->Ports.end(),
    [](const Port& port) { return port.Takes == Data::Surface; });
  return this->TakesMore || surfaces > 1;
}

//------------------------------------------------------------------------------
Algorithm Case::make(
  const Mode& mode, int port, vtkDataObject* input, double scale, int frequency) const
{
  const vtkSmartPointer<vtkPolyData> good = Ellipsoid(scale, frequency);
  const Algorithm algorithm = this->Make();
  for (int i = 0; i < static_cast<int>(mode.Ports.size()); ++i)
  {
    const Data takes = mode.Ports[i].Takes;
    if (i == port)
    {
      algorithm->SetInputDataObject(i, input);
    }
    else if (takes == Data::Surface)
    {
      algorithm->SetInputDataObject(i, good);
    }
    else if (takes != Data::Nothing)
    {
      algorithm->SetInputDataObject(i, GoodInput(takes));
    }
  }
  if (mode.Set)
  {
    mode.Set(algorithm, good);
  }
  return algorithm;
}

//------------------------------------------------------------------------------
std::string Case::name(const Mode& mode, int port) const
{
  const bool hasOwn = port < static_cast<int>(mode.Ports.size()) && !mode.Ports[port].Name.empty();
  const std::string& suffix = hasOwn ? mode.Ports[port].Name : mode.Name;
  return suffix.empty() ? this->Class : this->Class + " (" + suffix + ")";
}

//------------------------------------------------------------------------------
const Case& Of(const std::string& className)
{
  const std::vector<Case>& all = All();
  const auto found =
    std::find_if(all.begin(), all.end(), [&](const Case& item) { return item.Class == className; });
  if (found == all.end())
  {
    throw std::out_of_range("Testing/Cases has no " + className + ".cxx");
  }
  return *found;
}
}
