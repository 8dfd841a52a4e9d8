#include "Files/FileOutput.h"

#include "Bytes/ParseStatus.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <iterator>
#include <list>
#include <random>
#include <stdexcept>
#include <system_error>

namespace conformal
{
namespace
{
bool isControlCharacter(char c)
{
  constexpr unsigned char blank = ' ';
  constexpr unsigned char erase = 0x7F;
  const auto code = static_cast<unsigned char>(c);
  return code < blank || code == erase;
}

WriteStatus failureOf(const std::string& path, const std::exception& e)
{
  const auto* error = dynamic_cast<const std::system_error*>(&e);
  constexpr int full[] = { ENOSPC, EDQUOT, EFBIG };
  const bool isFull =
    error && std::find(std::begin(full), std::end(full), error->code().value()) != std::end(full);
  return { isFull ? WriteCode::OutOfDiskSpace : WriteCode::CannotOpen,
    path + " cannot be written: " + (error ? error->code().message() : e.what()) };
}
}

//------------------------------------------------------------------------------
std::string makeTemporaryName()
{
  constexpr char digits[] = "0123456789abcdef";
  std::random_device random;
  std::string name = ".conformalsom-";
  for (int i = 0; i < 16; ++i)
  {
    name += digits[random() % 16];
  }
  return name;
}

//------------------------------------------------------------------------------
WriteStatus writeFiles(
  const std::vector<std::pair<std::string, std::string_view>>& files, const MakeName& makeName)
{
  for (const auto& [path, bytes] : files)
  {
    if (std::any_of(path.begin(), path.end(), isControlCharacter))
    {
      return { WriteCode::InvalidName,
        "the file name " + conformal::quoted(path) + " contains a control character" };
    }
  }
  std::list<OutputFile> outputs;
  std::string current;
  WriteStatus failure;
  try
  {
    for (const auto& [path, bytes] : files)
    {
      current = path;
      outputs.emplace_back(path, makeName);
      for (auto other = outputs.begin(); other != std::prev(outputs.end()); ++other)
      {
        if (other->isSameAs(outputs.back()))
        {
          throw std::invalid_argument("it is the same file as " + other->path());
        }
      }
    }
    auto output = outputs.begin();
    for (const auto& [path, bytes] : files)
    {
      current = path;
      (output++)->write(bytes);
    }
    for (output = outputs.begin(); output != outputs.end(); ++output)
    {
      current = output->path();
      output->takePlace(std::next(output) != outputs.end());
    }
    return {};
  }
  catch (const std::exception& e)
  {
    failure = failureOf(current, e);
  }
  for (auto output = outputs.rbegin(); output != outputs.rend(); ++output)
  {
    failure.Message += output->putBack();
  }
  return failure;
}
}
