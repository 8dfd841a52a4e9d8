// Make valid and broken GIFTI files for tests.
#ifndef GIFTISamples_h
#define GIFTISamples_h

#include "../FreeSurfer/FreeSurferSamples.h"
#include "Text/BinaryTextEncoder.h"

namespace samples
{
struct GIFTIData
{
  std::string Intent;
  std::string Type;
  std::string Dimensions;
  std::string Encoding = "ASCII";
  std::string More = "Endian=\"LittleEndian\"";
  std::string Text;
};

inline std::string GIFTI(const std::vector<GIFTIData>& arrays)
{
  std::string file = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                     "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/gifti.dtd\">\n"
                     "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"" +
    std::to_string(arrays.size()) + "\">\n<MetaData/>\n<LabelTable/>\n";
  for (const GIFTIData& array : arrays)
  {
    file += "<DataArray Intent=\"NIFTI_INTENT_" + array.Intent + "\" DataType=\"NIFTI_TYPE_" +
      array.Type + "\" ArrayIndexingOrder=\"RowMajorOrder\" " + array.Dimensions + " Encoding=\"" +
      array.Encoding + "\" " + array.More +
      " ExternalFileName=\"\" ExternalFileOffset=\"\">\n<MetaData><MD>\n<Name>Name</Name>\n"
      "<Value>" +
      (array.Intent == "SHAPE" ? "sulc &amp; depth" : "") +
      "</Value></MD></MetaData>\n"
      "<Data>" +
      array.Text + "</Data>\n</DataArray>\n";
  }
  return file + "</GIFTI>\n";
}

inline std::string AsciiGIFTI()
{
  return GIFTI({ { "POINTSET", "FLOAT32", "Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\"", "ASCII", "",
                   "0 0 0\n1.5 0 0\n0 1 0\n0 0 1e-3\n" },
    { "TRIANGLE", "INT32", "Dim1=\"3\" Dim0=\"4\" Dimensionality=\"2\"", "ASCII", "",
      "0 2 1 0 1 3 1 2 3 2 0 3" },
    { "SHAPE", "FLOAT32", "Dimensionality=\"1\" Dim0=\"4\"", "ASCII", "", "1 2 3 0.25" } });
}

// Return a binary GIFTI file of a surface. The scale multiplies all coordinates.
inline std::string BinaryGIFTI(bool isBig, bool isCompressed, double scale = 1.0)
{
  const std::string encoding = isCompressed ? "GZipBase64Binary" : "Base64Binary";
  const std::string endian = isBig ? "Endian=\"BigEndian\"" : "Endian=\"LittleEndian\"";
  Bytes points(isBig);
  for (const float coordinate : TetrahedronPoints())
  {
    points.add(scale * static_cast<double>(coordinate));
  }
  Bytes ids(isBig);
  ids.add(TetrahedronIds());
  return GIFTI({ { "POINTSET", "FLOAT64", "Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\"", encoding,
                   endian, conformal::encodeBinaryText(points.bytes(), isCompressed) },
    { "TRIANGLE", "INT32", "Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\"", encoding, endian,
      "\n" + conformal::encodeBinaryText(ids.bytes(), isCompressed) + "\n" } });
}

inline std::string ShapeGIFTI(int points = 4)
{
  std::string values;
  for (int i = 0; i < points; ++i)
  {
    values += std::to_string(i) + " ";
  }
  return GIFTI({ { "SHAPE", "INT16", "Dimensionality=\"1\" Dim0=\"" + std::to_string(points) + "\"",
                   "ASCII", "", values },
    { "NONE", "UINT8", "Dimensionality=\"1\" Dim0=\"" + std::to_string(points) + "\"", "ASCII", "",
      values } });
}

inline std::vector<std::string> GIFTIFiles()
{
  std::string metadata; // ignored by parsers
  for (int i = 0; i < 40; ++i)
  {
    metadata += "<MD><Name>Description " + std::to_string(i) +
      "</Name><Value>who made it, when, by which programs, from which pictures</Value></MD>\n";
  }
  const std::string described = replaced(
    AsciiGIFTI(), "<MetaData/>", "<!-- a remark -->\n<MetaData>" + metadata + "</MetaData>");
  return { AsciiGIFTI(), BinaryGIFTI(false, false), BinaryGIFTI(true, true), described };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadGIFTIFiles()
{
  const std::string ascii = AsciiGIFTI();
  const std::string plain = BinaryGIFTI(false, false);
  const std::string zipped = BinaryGIFTI(false, true);
  const std::string bomb = conformal::encodeBinaryText(std::string(1 << 20, '\0'), true);
  std::vector<std::string> files = { ShapeGIFTI(), replaced(ascii, "POINTSET", "VECTOR"),
    replaced(ascii, "TRIANGLE", "POINTSET"), replaced(ascii, "FLOAT32", "FLOAT128"),
    replaced(ascii, "INT32", "FLOAT32"), replaced(ascii, "\"NIFTI_TYPE_INT32\"", "\"\""),
    replaced(ascii, "Dim0=\"4\"", "Dim0=\"5\""), replaced(ascii, "Dim0=\"4\"", "Dim0=\"3\""),
    replaced(ascii, "Dim0=\"4\"", "Dim0=\"-4\""), replaced(ascii, "Dim0=\"4\"", ""),
    replaced(ascii, "Dim0=\"4\"", "Dim0=\"99999999999\""),
    replaced(ascii, "Dim0=\"4\"", "Dim0=\"18446744073709551615\""),
    replaced(ascii, "Dim0=\"4\"", "Dim9=\"4\""), replaced(ascii, "Dim1=\"3\"", "Dim1=\"0\""),
    replaced(ascii, "Dimensionality=\"2\"", "Dimensionality=\"7\""),
    replaced(ascii, "Dimensionality=\"2\"", ""), replaced(ascii, "ASCII", "EBCDIC"),
    replaced(ascii, "ASCII", "ExternalFileBinary"), replaced(ascii, "ASCII", "Base64Binary"),
    replaced(ascii, "1.5", "1.2.3"), replaced(ascii, "1.5", "1e999"), replaced(ascii, "1.5", "nan"),
    replaced(ascii, "1.5", "1,5"), replaced(ascii, "1.5", ""), replaced(ascii, "1.5", "1.5 1"),
    replaced(ascii, "1.5", std::string(5000, '1')), replaced(ascii, "2 0 3", "2 0 4"),
    replaced(ascii, "2 0 3", "2 0 -1"), replaced(ascii, "2 0 3", "2 0 2147483648"),
    replaced(ascii, "</Data>", ""), replaced(ascii, "</Data>", "</Data><Data>1</Data>"),
    replaced(ascii, "<Data>", "<Dota>"), replaced(ascii, "<Data>", "<DataArray><Data>"),
    replaced(ascii, "</GIFTI>", "</GIFTY>"), ascii.substr(0, ascii.size() / 2),
    ascii + "<GIFTI></GIFTI>", "<!DOCTYPE a [<!ENTITY b \"c\">]><GIFTI>&b;</GIFTI>", "<GIFTI/>",
    "<GIFTI></GIFTI>", "<wrong><GIFTI/></wrong>", replaced(plain, "LittleEndian", "MiddleEndian"),
    replaced(plain, "AA", "A"), replaced(plain, "AA", "A*"), replaced(plain, "AA", "=A"),
    replaced(zipped, "eJ", "eK"), replaced(zipped, "<Data>", "<Data>" + bomb),
    replaced(zipped, "GZipBase64Binary", "Base64Binary"),
    replaced(ascii, "DataArrays=\"3\"", "DataArrays=\"2\""),
    replaced(ascii, "DataArrays=\"3\"", "DataArrays=\"4\""),
    replaced(ascii, "DataArrays=\"3\"", "DataArrays=\"-3\""),
    replaced(ascii, "DataArrays=\"3\"", "DataArrays=\"\""),
    replaced(ascii, "DataArrays=\"3\"", "DataArrays=\"99999999999\""),
    replaced(ascii, " NumberOfDataArrays=\"3\"", ""),
    replaced(ascii, "RowMajorOrder", "DiagonalOrder") };
  return files;
}
}

#endif
