#include "vtkPlateModelReader.h"

#include "Bytes/ByteReader.h"
#include "PlateModel/PlateModelLabel.h"
#include "PlateModel/PlateModelParser.h"
#include "Text/JSONText.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

vtkStandardNewMacro(vtkPlateModelReader);

namespace
{
// Return the position of the dot before the extension of a file name, or the length of the name.
std::size_t ExtensionOf(const std::string& name)
{
  const std::size_t dot = name.find_last_of("./");
  return dot == name.npos || name[dot] == '/' ? name.size() : dot;
}

std::string LowerExtensionOf(const std::string& name)
{
  std::string extension = name.substr(ExtensionOf(name));
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

// Return the name of the label beside a table: the file of the same name with the extension .lbl or
// .xml. Without such a file, return an empty name.
std::string LabelOf(const std::string& name)
{
  for (const char* extension : { ".lbl", ".LBL", ".xml", ".XML" })
  {
    std::string label = name.substr(0, ExtensionOf(name)) + extension;
    conformal::ByteReader input;
    if (label != name && conformal::openFile(label, input).ok())
    {
      return label;
    }
  }
  return {};
}
}

//------------------------------------------------------------------------------
int vtkPlateModelReader::CanReadFile(const char* name)
{
  const std::string extension = name ? LowerExtensionOf(name) : ".obj";
  const bool isNamed = extension == ".tab" || extension == ".ver";
  return extension != ".obj" &&
      Superclass::StartsLike(
        name, isNamed ? conformal::looksLikeNamedPlateModel : conformal::looksLikePlateModel)
    ? 1
    : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkPlateModelReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  return conformal::parsePlateModel(input, {}, run);
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkPlateModelReader::FilesReadToo()
{
  return { LabelOf(this->FileName) };
}

//------------------------------------------------------------------------------
int vtkPlateModelReader::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // A copy, since observers of the progress may change the property for the next run.
  const std::string name = this->FileName ? this->FileName : "";
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  if (this->GetErrorCode() == vtkErrorCode::NoError && !name.empty())
  {
    this->AddLabel(LabelOf(name), vtkPolyData::GetData(outputVector));
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkPlateModelReader::AddLabel(const std::string& name, vtkPolyData* output)
{
  constexpr std::size_t maximumBytes = std::size_t(1) << 20; // labels have a few KiB
  conformal::ByteReader input;
  if (name.empty() || output->GetNumberOfPoints() == 0 || !conformal::openFile(name, input).ok())
  {
    return;
  }
  conformal::PlateModelLabel label;
  const conformal::ParseStatus status = conformal::statusOf([&]()
    { label = conformal::parsePlateModelLabel(input.peek(maximumBytes).substr(0, maximumBytes)); });
  if (!status.ok())
  {
    vtkWarningMacro(<< name << ": " << status.text() << "; the label is ignored");
    return;
  }
  if (label.HasSeveralUnits)
  {
    vtkWarningMacro(<< name << ": the label has both kilometers and meters; the unit is unknown");
  }
  if (label.MetersPerUnit > 0.0)
  {
    vtkNew<vtkDoubleArray> meters;
    meters->SetName("MetersPerUnit");
    meters->InsertNextValue(label.MetersPerUnit);
    output->GetFieldData()->AddArray(meters);
  }
  if (!label.TargetName.empty())
  {
    vtkNew<vtkStringArray> target;
    target->SetName("TargetName");
    target->InsertNextValue(conformal::validUTF8(label.TargetName));
    output->GetFieldData()->AddArray(target);
  }
}

//------------------------------------------------------------------------------
void vtkPlateModelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
