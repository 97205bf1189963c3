// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas of random words, and tables of grains as somebody might send them: each is taken, or refused by
// one line. A formula that is taken gives the same number twice; a table that is taken has positive, finite
// grains.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/packing/packing.h>

#include <unistd.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>

using namespace softgrain;

namespace
{
/// Seconds after which an input counts as a hang; the signal then ends the program.
constexpr unsigned int limit = 20;

/// "taken", "refused", or what is wrong with the way in which it was refused.
std::string verdict(const std::function<void()> &read)
{
  std::string found = "taken";
  alarm(limit);
  try
  {
    read();
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    found =
        message.empty() || message.find('\n') != std::string::npos ? "not one line: " + message : "refused";
  }
  catch (const std::exception &error)
  {
    found = std::string("no InputError: ") + error.what();
  }
  alarm(0);
  return found;
}

bool same_bits(const double a, const double b)
{
  return std::memcmp(&a, &b, sizeof(double)) == 0;
}

std::string read_formula(const std::string &text)
{
  return verdict(
      [&]()
      {
        const Expression formula(text, {"t", "x"});
        const Expression copy = formula;
        if (!same_bits(formula({0.3, 2.}), copy({0.3, 2.})))
          throw std::runtime_error("two values of " + text);
      });
}

void random_formulas(const unsigned int n)
{
  static const std::vector<std::string> words = {
      "t",  "x",    "y", "pi",  "_e",   "1",   "0",   "1e308", "1e-320", "1e999", "nan", "inf", "+",
      "-",  "*",    "/", "^",   "(",    ")",   ",",   "<",     ">=",     "==",    "=",   "!=",  "&&",
      "||", "?",    ":", "sin", "sqrt", "log", "min", "sum",   "rint",   "atan2", ";",   "!",   " ",
      "\"", "0x1F", ".", "e",   "1e",   "#",   "{",   "é",     "if",     "#1"};
  std::mt19937_64 generator(11);
  std::size_t taken = 0, refused = 0;
  for (unsigned int i = 0; i < n; ++i)
  {
    std::string text;
    for (std::size_t k = 1 + generator() % 12; k > 0; --k)
      text += words[generator() % words.size()];
    const std::string found = read_formula(text);
    taken += found == "taken";
    refused += found == "refused";
    if (found != "taken" && found != "refused")
      std::cout << text << ": " << found << '\n';
  }
  std::cout << "random formulas: " << (taken + refused == n ? "all" : "not all") << " taken or refused, "
            << (taken > n / 100 ? "some" : "hardly any") << " taken, " << (refused > n / 2 ? "most" : "few")
            << " refused\n";
}

std::string repeated(const std::string &text, const unsigned int n)
{
  std::string result;
  result.reserve(text.size() * n);
  for (unsigned int i = 0; i < n; ++i)
    result += text;
  return result;
}

void large_formulas()
{
  for (const unsigned int n : {10u, 1000u, 100000u})
  {
    std::cout << n << " brackets: " << read_formula(repeated("(", n) + "t" + repeated(")", n)) << '\n';
    std::cout << n << " functions: " << read_formula(repeated("sin(", n) + "t" + repeated(")", n)) << '\n';
    std::cout << n << " signs: " << read_formula(repeated("-", n) + "t") << '\n';
    std::cout << n << " choices: " << read_formula(repeated("t?1:", n) + "2") << '\n';
    std::cout << n << " terms: " << read_formula(repeated("t+", n) + "t") << '\n';
    std::cout << n << " powers: " << read_formula(repeated("t^", n) + "t") << '\n';
    std::cout << n << " open: " << read_formula(repeated("(", n)) << '\n';
  }
}

void table(const std::string &what, const std::string &text)
{
  std::ofstream("table.csv", std::ios::binary) << text;
  const std::string found = verdict(
      []()
      {
        for (const Packing<2>::Ball &grain : read_packing<2>("table.csv").balls)
          if (!std::isfinite(grain.center[0] + grain.center[1]) || !(grain.radius > 0.) ||
              !std::isfinite(grain.radius))
            throw std::runtime_error("a grain of no size or place");
      });
  std::cout << what << ": " << found << '\n';
}

void tables()
{
  const std::string head = "x_m,y_m,radius_m\n", good = "0.1,0.2,1e-3\n";
  table("good", head + good);
  table("no end of line", head + "0.1,0.2,1e-3");
  table("lines of Windows", "x_m,y_m,radius_m\r\n0.1,0.2,1e-3\r\n");
  table("byte-order mark", "\xEF\xBB\xBF" + head + good);
  table("empty", "");
  table("only a heading", head);
  table("no heading", good);
  table("two headings", head + head + good);
  table("missing column", "x_m,y_m\n0.1,0.2\n");
  table("column twice", "x_m,y_m,radius_m,radius_m\n0.1,0.2,1e-3,2e-3\n");
  table("missing number", head + "0.1,,1e-3\n");
  table("superfluous number", head + "0.1,0.2,1e-3,4\n");
  table("radius below zero", head + "0.1,0.2,-1e-3\n");
  table("radius zero", head + "0.1,0.2,0\n");
  table("nan", head + "nan,0.2,1e-3\n");
  table("infinite", head + "0.1,inf,1e-3\n");
  table("too large for a number", head + "0.1,0.2,1e999\n");
  table("too small for a number", head + "0.1,0.2,1e-999\n");
  table("not a number", head + "0.1,0.2,thick\n");
  table("a number and more", head + "0.1,0.2,1e-3m\n");
  table("empty line within", head + good + "\n" + good);
  table("binary", std::string("x_m,y_m,radius_m\n\0\x01\x02\xFF,3\n", 26));
  table("zero byte in a number", head + std::string("0.1,0.2,1e-3\0\n", 14));
  table("a line of a million letters", head + std::string(1000000, '1') + ",0.2,1e-3\n");
  table("a million commas", head + std::string(1000000, ',') + "\n");
  table("a million digits behind the point", head + "0." + std::string(1000000, '1') + ",0.2,1e-3\n");
  table("no name of a material", "x_m,y_m,radius_m,material\n0.1,0.2,1e-3,\n");
}
} // namespace

int main(const int argc, char **argv)
{
  random_formulas(argc > 1 ? std::stoul(argv[1]) : 20000);
  large_formulas();
  tables();
}
