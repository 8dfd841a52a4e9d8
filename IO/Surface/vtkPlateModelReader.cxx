#include "vtkPlateModelReader.h"

#include "PlateModel/PlateModelParser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPlateModelReader);

//------------------------------------------------------------------------------
int vtkPlateModelReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikePlateModel) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkPlateModelReader::Parse(conformal::ByteReader& input,
  const conformal::FilePiece&, const std::function<bool(double)>& progress)
{
  return conformal::parsePlateModel(input, {}, progress);
}

//------------------------------------------------------------------------------
void vtkPlateModelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
