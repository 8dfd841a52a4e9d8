#include "vtkTextCloudReader.h"

#include "PlateModel/PlateModelParser.h"
#include "TextCloud/TextCloudParser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTextCloudReader);

//------------------------------------------------------------------------------
int vtkTextCloudReader::CanReadFile(const char* name)
{
  // A count and rows of numbers may also be the vertices of a plate model, which is excluded.
  const auto looksRight = [](std::string_view start, std::uint64_t size)
  { return conformal::looksLikeTextCloud(start) && !conformal::looksLikePlateModel(start, size); };
  return Superclass::StartsLike(name, +looksRight) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkTextCloudReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece& piece, const conformal::Run& run)
{
  conformal::TextCloudOptions options;
  options.DecimalComma = this->DecimalComma;
  options.SkipMalformedLines = this->SkipMalformedLines;
  options.Piece = piece;
  return conformal::parseTextCloud(input, options, {}, run);
}

//------------------------------------------------------------------------------
void vtkTextCloudReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DecimalComma: " << (this->DecimalComma ? "On" : "Off") << "\n";
  os << indent << "SkipMalformedLines: " << (this->SkipMalformedLines ? "On" : "Off") << "\n";
}
