#include "vtkTIFFStackWriter.h"

#include "Glue/StackConversions.h"
#include "TIFF/TIFFStackWriter.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <array>
#include <string>

vtkStandardNewMacro(vtkTIFFStackWriter);

//------------------------------------------------------------------------------
int vtkTIFFStackWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkTIFFStackWriter::WriteFiles(const conformal::Run& run)
{
  const std::string path = this->FileName; // a copy: observers may change it
  const bool isUp = this->YAxis == UP;
  const glue::StackPixels pixels = this->PixelType == UINT16 ? glue::StackPixels::UInt16
    : this->PixelType == FLOAT32                             ? glue::StackPixels::Float32
                                                             : glue::StackPixels::Automatic;
  conformal::TIFFStack stack = glue::ToStack(vtkImageData::SafeDownCast(this->GetInput(0)),
    this->ArrayName, this->Unit, pixels, this->NumberOfFrames);
  stack.Info.FrameInterval = this->FrameInterval;
  const std::string bytes = conformal::makeTIFFStack(stack, isUp, run);
  this->WriteTogether({ { path, bytes } });
}

//------------------------------------------------------------------------------
void vtkTIFFStackWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  static const std::array<const char*, 3> types = { "Automatic", "UInt16", "Float32" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Unit: " << this->Unit << "\n";
  os << indent << "PixelType: " << types[this->PixelType] << "\n";
  os << indent << "YAxis: " << (this->YAxis == UP ? "Up" : "Down") << "\n";
  os << indent << "NumberOfFrames: " << this->NumberOfFrames << "\n";
  os << indent << "FrameInterval: " << this->FrameInterval << "\n";
}
