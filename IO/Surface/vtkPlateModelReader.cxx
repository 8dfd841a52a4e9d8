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
conformal::SurfaceResult vtkPlateModelReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  return conformal::parsePlateModel(input, {}, run);
}

//------------------------------------------------------------------------------
void vtkPlateModelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
