// Runs a fuzz target on every input in files of the corpus, where no fuzzer does; corpus.py packs
// these files and says how.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

int main(int argc, char* argv[])
{
  int inputs = 0;
  for (int i = 1; i < argc; ++i)
  {
    std::ifstream file(argv[i], std::ios::binary);
    for (std::size_t size = 0; file >> size;)
    {
      std::string bytes(size, '\0');
      if (file.get() != '\n' || !file.read(bytes.data(), static_cast<std::streamsize>(size)))
      {
        std::printf("%s ends in the middle of an input\n", argv[i]);
        return 1;
      }
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++inputs;
    }
    if (!file.eof())
    {
      std::printf("%s is no file of the corpus\n", argv[i]);
      return 1;
    }
  }
  std::printf("%d inputs\n", inputs);
  return inputs > 0 ? 0 : 1;
}
