// Set a locale with a decimal comma, such as 0,5, while the object exists.
#ifndef CommaLocale_h
#define CommaLocale_h

#include <clocale>
#include <locale>
#include <string>

class CommaLocale
{
public:
  CommaLocale()
  {
    std::locale::global(std::locale(std::locale(), new Comma)); // for streams, on every system
    std::setlocale(LC_ALL, "de_DE.UTF-8");                      // for strtod, if installed
  }
  ~CommaLocale()
  {
    std::locale::global(this->LocaleBefore);
    std::setlocale(LC_ALL, this->Before.c_str());
  }
  CommaLocale(const CommaLocale&) = delete;
  void operator=(const CommaLocale&) = delete;

private:
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };

  std::string Before = std::setlocale(LC_ALL, nullptr);
  std::locale LocaleBefore;
};

#endif
