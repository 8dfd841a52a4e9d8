#include "SPHARM/SPHARMCoefficients.h"

#include "Bytes/FileValues.h"
#include "Bytes/NumberText.h"
#include "Bytes/ProgressReport.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
constexpr double RootOfHalf = 0.70710678118654752440;

// Return the degree L for which `count` is (L + 1)^2. If there is no such degree, return -1.
std::int64_t degreeOf(std::uint64_t count)
{
  const auto root = static_cast<std::uint64_t>(std::llround(std::sqrt(static_cast<double>(count))));
  return root > 0 && root * root == count ? static_cast<std::int64_t>(root) - 1 : -1;
}

// Tuple in which a coefficient of the file is stored, and its factor.
struct HarmonicPlace
{
  std::size_t Tuple = 0;
  double Factor = 1.0;
};

// Find the tuple of a coefficient. For each degree, the file contains order 0 first, then cos and
// sin of each order.
HarmonicPlace placeOf(std::size_t degree, std::size_t number)
{
  const std::size_t order = (number + 1) / 2;
  const bool isCos = number % 2 == 1;
  const std::size_t middle = degree * (degree + 1);
  const double sign = order % 2 == 0 ? 1.0 : -1.0;
  return { isCos ? middle + order : middle - order, order == 0 ? 1.0 : sign * RootOfHalf };
}

class CoefficientReader
{
public:
  CoefficientReader(ByteReader& input, const ParseLimits& limits, const Run& run)
    : Input(input)
    , Limits(limits)
    , Progress(input, run)
  {
  }

  NamedArray read()
  {
    this->Input.requireBytes();
    if (!looksLikeSPHARMCoefficients(this->Input.peek(SniffedBytes)))
    {
      this->Input.fail(ParseCode::UnrecognizedType,
        "expected { N,{x, y, z}, ...} with the number N of coefficients");
    }
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    this->Input.advance(this->Input.peek(mark.size()).substr(0, 3) == mark ? mark.size() : 0);
    this->take('{');
    const auto count = this->next<std::uint64_t>(',', "the number of coefficients");
    const std::int64_t degree = degreeOf(count);
    if (degree < 0)
    {
      this->Input.fail(ParseCode::Malformed,
        "found " + std::to_string(count) + " coefficients, expected (L + 1)^2 of a degree L");
    }
    this->take(',');
    NamedArray array = makeArray("Coefficients", ScalarType::Float64, 3);
    constexpr std::uint64_t minimumBytes = 7; // {0,0,0}
    array.Values.resize(3 * sizeof(double) *
      this->Limits.checkedCount(
        this->Input, "coefficients", count, minimumBytes, 3 * sizeof(double)));
    for (std::size_t l = 0; l <= static_cast<std::size_t>(degree); ++l)
    {
      for (std::size_t number = 0; number <= 2 * l; ++number)
      {
        this->Progress.tick();
        this->readTuple(placeOf(l, number), array);
        const bool isLast = static_cast<std::int64_t>(l) == degree && number == 2 * l;
        this->take(isLast ? '}' : ',');
      }
    }
    this->skipBlanks();
    if (!this->Input.peek(1).empty())
    {
      this->failExpecting("the end of the file");
    }
    return array;
  }

  static constexpr std::size_t SniffedBytes = 4096;

private:
  void readTuple(const HarmonicPlace& place, NamedArray& array)
  {
    this->take('{');
    std::array<double, 3> tuple{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      if (c > 0)
      {
        this->take(',');
      }
      tuple[c] = place.Factor * this->next<double>(c < 2 ? ',' : '}', "a finite number");
    }
    this->take('}');
    std::memcpy(array.Values.data() + place.Tuple * sizeof(tuple), tuple.data(), sizeof(tuple));
  }

  // Read a number that ends at a blank or a delimiter. The delimiter is not consumed.
  template <typename T>
  T next(char delimiter, const char* expected)
  {
    this->skipBlanks();
    constexpr std::size_t longest = 4096;
    const std::string_view text = this->Input.peek(longest + 1);
    T value = T();
    const std::size_t length = readNumber(text, value, delimiter);
    if (length == 0 || length > longest || !std::isfinite(static_cast<double>(value)))
    {
      this->failExpecting(expected);
    }
    this->Input.advance(length);
    return value;
  }

  void take(char letter)
  {
    this->skipBlanks();
    if (this->Input.peek(1).substr(0, 1) != std::string_view(&letter, 1))
    {
      this->failExpecting(std::string(1, letter));
    }
    this->Input.advance(1);
  }

  void skipBlanks() { TextValues(this->Input).skipBlanks(); }

  [[noreturn]] void failExpecting(const std::string& expected)
  {
    const std::string_view text = this->Input.peek(1);
    if (text.empty())
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file ends, expected " + expected);
    }
    const std::size_t length =
      std::find_if(text.begin() + 1, text.end(), [](char c) { return isBlank(c) || c == ','; }) -
      text.begin();
    this->Input.fail(
      ParseCode::Malformed, "found " + quoted(text.substr(0, length)) + ", expected " + expected);
  }

  ByteReader& Input;
  const ParseLimits& Limits;
  ProgressReport Progress;
};

void appendCoefficient(std::string& text, double value)
{
  char buffer[40];
  constexpr int digits = 15;
  const auto result =
    std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, digits);
  text.append(buffer, result.ptr);
}
}

//------------------------------------------------------------------------------
SurfaceResult parseSPHARMCoefficients(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return parseSurface([&](SurfaceData& data)
    { data.PointArrays.push_back(CoefficientReader(input, limits, run).read()); });
}

//------------------------------------------------------------------------------
bool looksLikeSPHARMCoefficients(std::string_view start)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  std::size_t place = start.substr(0, mark.size()) == mark ? mark.size() : 0;
  const auto skipBlanks = [&]()
  {
    while (place < start.size() && isBlank(start[place]))
    {
      ++place;
    }
  };
  const auto takes = [&](char letter)
  {
    skipBlanks();
    const bool isThere = place < start.size() && start[place] == letter;
    place += isThere ? 1 : 0;
    return isThere;
  };
  if (!takes('{'))
  {
    return false;
  }
  skipBlanks();
  const std::size_t first = place;
  while (place < start.size() && start[place] >= '0' && start[place] <= '9')
  {
    ++place;
  }
  return place > first && takes(',') && takes('{');
}

//------------------------------------------------------------------------------
std::string makeSPHARMCoefficients(const NamedArray& coefficients, const Run& run)
{
  const bool isRight = coefficients.Type == ScalarType::Float64 && coefficients.Components == 3;
  const std::int64_t degree = isRight ? degreeOf(coefficients.numberOfTuples()) : -1;
  if (degree < 0)
  {
    throw std::invalid_argument("coefficients must be (L + 1)^2 tuples of 3 numbers");
  }
  std::string text = "{ " + std::to_string(coefficients.numberOfTuples()) + ",";
  for (std::size_t l = 0; l <= static_cast<std::size_t>(degree); ++l)
  {
    run.report(static_cast<double>(l * l) / coefficients.numberOfTuples());
    for (std::size_t number = 0; number <= 2 * l; ++number)
    {
      const HarmonicPlace place = placeOf(l, number);
      std::array<double, 3> tuple{};
      std::memcpy(
        tuple.data(), coefficients.Values.data() + place.Tuple * sizeof(tuple), sizeof(tuple));
      text += l + number > 0 ? ",\n{" : "{";
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double value = tuple[c] / place.Factor;
        if (!std::isfinite(value))
        {
          throw std::invalid_argument("a coefficient is too large for a number of the file");
        }
        text += c > 0 ? ", " : "";
        appendCoefficient(text, value);
      }
      text += '}';
    }
  }
  return text + "}\n";
}
}
