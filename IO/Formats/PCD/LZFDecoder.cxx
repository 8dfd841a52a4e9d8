#include "PCD/LZFDecoder.h"

namespace conformal
{
//------------------------------------------------------------------------------
unsigned char LZFDecoder::nextByte()
{
  const std::string_view bytes = this->Input.peek(1);
  if (bytes.empty())
  {
    this->Input.fail(ParseCode::PrematureEnd, "the file ends inside compressed data");
  }
  if (this->Left-- == 0)
  {
    this->Input.fail(
      ParseCode::Malformed, "the compressed data are shorter than the header states");
  }
  const auto byte = static_cast<unsigned char>(bytes[0]);
  this->Input.advance(1);
  return byte;
}

//------------------------------------------------------------------------------
void LZFDecoder::nextControl()
{
  constexpr std::size_t longestShort = 7;
  const std::size_t control = this->nextByte();
  if (control < 32)
  {
    this->Literals = control + 1;
    return;
  }
  this->Repeats = (control >> 5) + 2;
  if (control >> 5 == longestShort)
  {
    this->Repeats += this->nextByte();
  }
  this->Distance = ((control & 31) << 8) + this->nextByte() + 1;
  if (this->Distance > this->Done)
  {
    this->Input.fail(ParseCode::Malformed,
      "found a reference to " + std::to_string(this->Distance) + " bytes back, with only " +
        std::to_string(this->Done) + " decompressed");
  }
}

//------------------------------------------------------------------------------
void LZFDecoder::read(char* bytes, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i, ++this->Done)
  {
    if (this->Literals == 0 && this->Repeats == 0)
    {
      this->nextControl();
    }
    if (this->Literals > 0)
    {
      bytes[i] = static_cast<char>(this->nextByte());
      --this->Literals;
    }
    else
    {
      bytes[i] = this->History[(this->Done - this->Distance) % HistoryBytes];
      --this->Repeats;
    }
    this->History[this->Done % HistoryBytes] = bytes[i];
  }
}

//------------------------------------------------------------------------------
void LZFDecoder::end() const
{
  if (this->Left > 0 || this->Literals > 0 || this->Repeats > 0)
  {
    this->Input.fail(ParseCode::Malformed, "found compressed data after the last point");
  }
}
}
